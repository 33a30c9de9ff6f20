#pragma once
// Steger's test of every pixel in a band of eight rows: smoothed by a Gaussian, its quadratic polynomial by 3 x 3
// differences, the line's direction and its offset from the pixel's centre (paper section II-D, steps 1 and 2).

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vignole {

inline constexpr int kMaxFilterRadius = 28;  ///< enough for sigma = 8 px
inline constexpr int kMaxBandWidth = 128;    ///< px
inline constexpr int kBandHeight = 8;        ///< px

/// Smoothing taps that add up to 1, each the Gaussian's integral over its pixel.
struct RidgeFilter {
  int radius = 0;
  std::array<float, 2 * kMaxFilterRadius + 1> taps{};
  double variancePx2 = 0;    ///< of the taps, px^2
  double gradientNoise = 0;  ///< standard deviation of a first difference for pixels of 1 DN, 1/px
  double ridgeNoise = 0;     ///< the same of a second difference, 1/px^2
  float leastRidge = 0;      ///< smallest second derivative across the line, negated, DN/px^2
};
[[nodiscard]] RidgeFilter ridgeFilter(double sigma, double leastRidge);

/// No pixel further away from a block with light, along a row or a column, decides anything: two blocks, or as far as
/// the filter reaches from two pixels beside it.
[[nodiscard]] constexpr int reachPx(const RidgeFilter& filter) { return std::max(16, filter.radius + 3); }

/// One pixel through which a bright line passes, by value.
struct RidgePoint {
  float x = 0, y = 0;    ///< point of the line nearest to the pixel's centre, px
  float nx = 0, ny = 0;  ///< unit normal, either sign
  float ridge = 0;       ///< second derivative across the line, negated, DN/px^2
  float smoothed = 0;    ///< smoothed brightness of the pixel, DN
  float along = 0;       ///< its derivative along the line, in direction (-ny, nx), DN/px; 0 where that turns no normal
  std::uint32_t pixel = 0;  ///< row << 16 | column
};
[[nodiscard]] constexpr std::uint32_t packedPixel(int column, int row) {
  return static_cast<std::uint32_t>(row) << 16U | static_cast<std::uint32_t>(column);
}
[[nodiscard]] constexpr int columnOf(std::uint32_t pixel) { return static_cast<int>(pixel & 0xFFFFU); }
[[nodiscard]] constexpr int rowOf(std::uint32_t pixel) { return static_cast<int>(pixel >> 16U); }

/// Many of them, quantity by quantity. Grows and never shrinks; room for whole vectors behind the last.
struct RidgeArrays {
  std::vector<float> x, y, nx, ny, ridge, smoothed, along;
  std::vector<std::uint32_t> pixel;
  std::size_t size = 0;

  void reserve(std::size_t count);
  void push(const RidgePoint& p);  ///< room must have been reserved
  /// from[order[0]], from[order[1]] ...; room must have been reserved.
  void append(const RidgeArrays& from, std::span<const std::uint32_t> order);
  [[nodiscard]] RidgePoint at(std::size_t i) const {
    return {x[i], y[i], nx[i], ny[i], ridge[i], smoothed[i], along[i], pixel[i]};
  }
};

/// Pixels that may hold a point, with the derivatives of the smoothed picture there. Same habits.
struct RidgeCandidates {
  std::vector<float> dx, dy, dxx, dxy, dyy, smoothed;
  std::vector<std::uint32_t> pixel;
  std::size_t size = 0;
  void reserve(std::size_t count);
};

/// Work space of one thread.
struct RidgeBand {
  static constexpr std::size_t kPitch = kMaxBandWidth + 2 * kMaxFilterRadius + 2 + 38;  // whole vectors of 16 floats
  alignas(64) std::array<std::array<float, kPitch>, kBandHeight + 2> vertical{};
  alignas(64) std::array<std::array<float, kPitch>, kBandHeight + 2> smoothed{};
};

/// Appends the candidates among the `width` x `height` (<= 8) pixels whose top-left one is (`column`, `row`), row by
/// row. `pixels` is the sample at (column - radius - 1, row - radius - 1), readable for width + 2 radius + 2 + 64
/// columns of 2 radius + 10 rows. Room for width x height more must have been reserved.
void findRidgeCandidates(const std::uint8_t* pixels, std::ptrdiff_t stride, int width, int height, int column, int row,
                         const RidgeFilter& filter, RidgeBand& band, RidgeCandidates& candidates);

/// The candidates that pass Steger's test, in their order. `points` is overwritten.
void testRidgeCandidates(const RidgeCandidates& candidates, float leastRidge, RidgeArrays& points);

/// The smoothed values of the 3 x 3 pixels around (column, row), row by row; `pixels` is the sample at
/// (column - radius - 1, row - radius - 1), readable for 2 radius + 3 + 64 columns of 2 radius + 3 rows.
[[nodiscard]] std::array<float, 9> smoothedAround(const std::uint8_t* pixels, std::ptrdiff_t stride,
                                                  const RidgeFilter& filter);

/// Name of the SIMD target in use; results are bit-equal on the same target.
[[nodiscard]] const char* simdTargetName();

}  // namespace vignole
