#pragma once
// Steger's test of every pixel in a band of eight rows: smoothed by a Gaussian, its quadratic polynomial by 3 x 3
// differences, the line's direction and its offset from the pixel's centre (paper section II-D, steps 1 and 2).

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

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

/// A pixel through which a bright line passes.
struct RidgePoint {
  float x = 0, y = 0;    ///< point of the line nearest to the pixel's centre, px
  float nx = 0, ny = 0;  ///< unit normal, either sign
  float ridge = 0;       ///< second derivative across the line, negated, DN/px^2
  float smoothed = 0;    ///< smoothed brightness of the pixel, DN
  std::uint16_t column = 0, row = 0;
};

/// Work space of one thread.
struct RidgeBand {
  static constexpr std::size_t kPitch = kMaxBandWidth + 2 * kMaxFilterRadius + 2 + 38;  // whole vectors of 16 floats
  alignas(64) std::array<std::array<float, kPitch>, kBandHeight + 2> vertical{};
  alignas(64) std::array<std::array<float, kPitch>, kBandHeight + 2> smoothed{};
  std::array<RidgePoint, static_cast<std::size_t>(kMaxBandWidth) * kBandHeight> points;
};

/// Points among the `width` x 8 pixels whose top-left one is (`column`, `row`), row by row. `pixels` is the sample at
/// (column - radius - 1, row - radius - 1), readable for width + 2 radius + 2 + 64 columns of 2 radius + 10 rows.
[[nodiscard]] std::span<const RidgePoint> findRidgePoints(const std::uint8_t* pixels, std::ptrdiff_t stride, int width,
                                                          int column, int row, const RidgeFilter& filter,
                                                          RidgeBand& band);

/// The smoothing alone: afterwards band.smoothed[1 + y][1 + x] belongs to pixel (column + x, row + y), one more to all
/// sides. Same `pixels` as above.
void smoothBand(const std::uint8_t* pixels, std::ptrdiff_t stride, int width, const RidgeFilter& filter,
                RidgeBand& band);

/// Name of the SIMD target in use; results are bit-equal on the same target.
[[nodiscard]] const char* simdTargetName();

}  // namespace vignole
