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

/// One per thread. Same image, same settings, same bits.
class StripeExtractor {
 public:
  explicit StripeExtractor(const StripeSettings& settings);  ///< settings that passed checked()
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
