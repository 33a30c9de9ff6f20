#pragma once
// Smoothing along the line by a parabola over a window around each point, which also tells the curvature and so takes
// off what the filter pulls to the inside of a bend: variance / 2 * curvature (stripe design, section 5). The window is
// as wide as the data bear it: it widens until the answers of two windows contradict each other beyond their noise
// (intersection of confidence intervals: Goldenshluger & Nemirovski 1997, Katkovnik 1999), so it stays off corners.

#include <array>
#include <cstddef>

namespace vignole {

/// One window: it adds the neighbours `offsets[0 .. count)` on both sides to those of the windows before.
struct SmoothingWindow {
  std::array<int, 3> offsets{};
  int count = 0;
  float weight = 1;     ///< of each: how many points it stands for
  float room = 0;       ///< neighbours that it reaches to
  float ofPlace = 0;    ///< variance of the parabola's place, in variances of a ridge point
  float ofBend = 0;     ///< variance of its second coefficient, the same / px^4
  float scatter = 0;    ///< expected sum of weighted squared residuals, in variances of a ridge point
  float scatterSd = 0;  ///< its standard deviation
  /// Of a circle w = b u^2 + b^3 u^4 + ... the parabola misses the place by this times b^3 (mean u^2)^2.
  float ofCircle = 0;
  float covariance = 0;  ///< of the two, the same / px^2
};

struct LineSmoothing {
  static constexpr std::size_t kWindows = 5;
  std::array<SmoothingWindow, kWindows> windows;
  float pullPx2 = 0;    ///< variance of filter and lens blur: the pull is half of it times the curvature
  bool applied = true;  ///< false: only the curvature is told, the points stay
};

/// For ridge points of a line filter of variance `filterVariancePx2` (their errors are white noise smoothed by it).
/// `blurVariancePx2`: of the optics.
[[nodiscard]] LineSmoothing lineSmoothing(double filterVariancePx2, double blurVariancePx2, bool applied);

}  // namespace vignole
