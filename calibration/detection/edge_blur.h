#pragma once
// The blur of an edge as an unknown of a fit.

#include <algorithm>
#include <cmath>

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

}  // namespace vignole
