#pragma once
// Laser line extraction (paper section II-D): smoothing, quadratic polynomial from Gaussian derivatives, hysteresis
// linking, gap linking; worked only where a scan over the bytes saw light.

#include <memory>

#include "engine/geometry/expected.h"
#include "engine/geometry/image_view.h"
#include "engine/stripe/stripe.h"

namespace vignole {

/// Refuses values out of range (sigma 1..8, 0 < low <= high, gapAngle 0..90 ...), naming the field.
[[nodiscard]] Expected<StripeSettings> checked(const StripeSettings& settings);

/// Noise never makes a line: t_l and t_h, as second derivatives t / (2 sqrt(2) sigma^2) (a stripe as wide as the
/// filter), are raised to these multiples of the noise of the second derivative, sn sqrt(3 / (16 pi)) / sigma^3.
inline constexpr double kLowNoiseFactor = 4, kHighNoiseFactor = 7;

/// Name of the SIMD target in use (Highway's words): bits are equal on the same target, 1e-6 px elsewhere.
[[nodiscard]] const char* stripeSimdTarget();

/// One per thread. Same image, same settings, same bits.
class StripeExtractor {
 public:
  explicit StripeExtractor(const StripeSettings& settings, const StripeOptics& optics = {});  ///< settings: checked()
  ~StripeExtractor();
  StripeExtractor(StripeExtractor&&) noexcept;
  StripeExtractor& operator=(StripeExtractor&&) noexcept;

  /// No stripe gives an empty result, not an error. Image at least 32 x 32.
  void extract(const ImageView& image, StripeResult& result);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace vignole
