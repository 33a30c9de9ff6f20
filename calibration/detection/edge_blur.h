#pragma once
// The blur of an edge as an unknown of a fit.

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vignole {

/// A pixel's own width blurs by 0.29 px and no picture is sharper than that. The unknown is the logarithm of what comes
/// on top, so that a fit may run towards the sharpest edge without meeting a bound.
class EdgeBlur {
 public:
  explicit EdgeBlur(double unknown) {
    const double more = std::exp(2 * unknown);
    px_ = std::sqrt(kLeastPx * kLeastPx + more);
    share_ = more / (px_ * px_);
  }
  [[nodiscard]] double px() const { return px_; }
  /// Derivative of log(px) by the unknown.
  [[nodiscard]] double share() const { return share_; }

  [[nodiscard]] static double unknownOf(double px) {
    return 0.5 * std::log(std::max(px * px - kLeastPx * kLeastPx, 1e-4));
  }
  static double held(double unknown) { return std::clamp(unknown, -4.0, 4.1); }

 private:
  static constexpr double kLeastPx = 0.33;
  double px_ = 1, share_ = 1;
};

/// Normal distribution: 0 far below, 1 far above, to 1e-7 (Abramowitz and Stegun 7.1.26), and its density.
struct NormalStep {
  double value = 0, density = 0;
};
[[nodiscard]] inline NormalStep normalStep(double z) {
  constexpr double kFar = 5.5;
  if (z > kFar) return {1, 0};
  if (z < -kFar) return {0, 0};
  const double gauss = std::exp(-0.5 * z * z);
  const double t = 1 / (1 + 0.3275911 * std::numbers::sqrt2 / 2 * std::abs(z));
  const double series =
      t * (0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429))));
  const double tail = 0.5 * series * gauss;
  return {z > 0 ? 1 - tail : tail, gauss * std::numbers::inv_sqrtpi / std::numbers::sqrt2};
}

}  // namespace vignole
