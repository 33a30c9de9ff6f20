#pragma once
// The two inner loops of the renderer, vectorised by Highway with dispatch at run time.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/geometry/image_view.h"

namespace vignole::simulator {

inline constexpr int kBlock = 16;   ///< px: the unit in which light is developed
inline constexpr int kMargin = 64;  ///< px of canvas around the picture, so that kernels never leave it

/// A 2D Gaussian by its inverse covariance: exp(-(a dx^2 + 2 b dx dy + c dy^2) / 2). Columns where it is below 1e-37 in
/// the middle row stay dark: they matter where an ellipse six times as long as wide lies at 45 degrees.
struct SplatKernel {
  float a = 1, b = 0, c = 1;
  float bend = 0.36787944F;  ///< exp(-c)
  float scale = 1;           ///< 1 / (2 pi sqrt(det covariance))
  float halfWidth = 8;       ///< px from the centre that the light reaches; columns are touched in whole blocks
  int halfHeight = 8;
};

/// A sample of light at (x, y) px of the picture.
struct Splat {
  float x = 0, y = 0;
  float energy = 0;
  std::uint32_t kernel = 0;
};

/// Light summed up, in floats, with a margin; zero between frames. Knows which blocks have been touched. A block's row
/// is one cache line, and light is added to whole ones only: samples lie so close that a row is still on its way to the
/// cache when the next sample needs it, and only the very same 64 bytes are handed on without waiting.
class Canvas {
 public:
  Canvas(int width, int height);
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  /// Adds samples in their order. Those whose kernel would leave the margin are left out.
  void add(const std::vector<Splat>& splats, const std::vector<SplatKernel>& kernels);

  /// Where a sample's light goes: the columns from `left` and the rows around y.
  struct Area {
    float* row;  ///< y's
    int left, columns, y;
  };
  /// Notes the blocks as touched; nothing where the kernel would leave the margin.
  [[nodiscard]] std::optional<Area> reserve(const Splat& splat, const SplatKernel& kernel);
  [[nodiscard]] std::ptrdiff_t stride() const { return linesPerRow_ * kBlock; }  ///< floats from row to row

  float* row(int y) { return data_.front().light.data() + (y + kMargin) * stride() + kMargin; }  ///< y from -kMargin
  std::vector<std::uint8_t> touched;  ///< blocksX x blocksY of the picture
  int blocksX = 0, blocksY = 0;
  /// Zeroes what add() wrote outside the picture's blocks.
  void clearMargin();

 private:
  struct alignas(64) Line {
    std::array<float, kBlock> light{};
  };
  int width_, height_;
  std::ptrdiff_t linesPerRow_;
  std::vector<Line> data_;
  bool marginTouched_ = false;
};

struct DevelopSettings {
  float gain = 1;  ///< on the light
  float ambientDn = 0;
  float readVariance = 0;          ///< DN^2
  float shotPerDn = 0;             ///< variance per DN of signal
  const float* speckle = nullptr;  ///< speckleField()
  const float* normals = nullptr;  ///< normal deviates
  std::uint32_t normalCount = 0;
  std::uint64_t key = 0;  ///< of the frame
};

/// Turns the touched blocks into pixels, with speckle, shot and read noise, and zeroes them.
void develop(Canvas& canvas, const DevelopSettings& settings, const MutableImageView& image);

/// The SIMD target that is used, "AVX2" and the like.
[[nodiscard]] const char* lightKernelTarget();

}  // namespace vignole::simulator
