#include "engine/profile/translate.h"

namespace vignole {

const char* reasonForNoContour(const StripeResult& stripe) {
  // A dead sensor or a closed shutter shows less than any ambient light; a background near the top is no background.
  constexpr float kBlackDn = 4, kBrightDn = 250;
  if (stripe.overloaded) return "overloaded";
  if (!stripe.lines.empty()) return "only rejected lines";
  if (stripe.backgroundDn <= kBlackDn) return "no stripe (black?)";
  if (stripe.backgroundDn >= kBrightDn) return "no stripe (saturated?)";
  return "no stripe";
}

void Translator::translate(std::uint64_t trigger, const StripeResult& stripe, PartialContour& result) const {
  translateThrough(map_, camera_, trigger, stripe, result, sheet_);
}

}  // namespace vignole
