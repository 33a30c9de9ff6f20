#pragma once
// The two inner loops of the renderer, vectorised by Highway with dispatch at run time.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/geometry/image_view.h"

namespace vignole::simulator {

inline constexpr int kBlock = 16;   ///< px: the unit in which light is developed
inline constexpr int kMargin = 64;  ///< px of canvas around the picture, so that kernels never leave it

/// A 2D Gaussian by its inverse covariance: exp(-(a dx^2 + 2 b dx dy + c dy^2) / 2).
struct SplatKernel {
  float a = 1, b = 0, c = 1;
  float scale = 1;    ///< 1 / (2 pi sqrt(det covariance))
  int halfWidth = 8;  ///< of the columns touched; a multiple of 8
  int halfHeight = 8;
};

/// A sample of light at (x, y) px of the picture.
struct Splat {
  float x = 0, y = 0;
  float energy = 0;
  std::uint32_t kernel = 0;
};

/// Light summed up, in floats, with a margin; zero between frames. Knows which blocks have been touched.
class Canvas {
 public:
  Canvas(int width, int height);
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  /// Adds samples in their order. Those whose kernel would leave the margin are left out.
  void add(const std::vector<Splat>& splats, const std::vector<SplatKernel>& kernels);

  float* row(int y) { return data_.data() + (y + kMargin) * stride_ + kMargin; }  ///< y from -kMargin
  std::vector<std::uint8_t> touched;                                              ///< blocksX x blocksY of the picture
  int blocksX = 0, blocksY = 0;
  [[nodiscard]] std::ptrdiff_t stride() const { return stride_; }
  /// Zeroes what add() wrote outside the picture's blocks.
  void clearMargin();

 private:
  int width_, height_;
  std::ptrdiff_t stride_;
  std::vector<float> data_;
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
