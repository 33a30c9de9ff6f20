#pragma once
// What two extractions of the same picture have apart: points that only one has, and how far the others moved.

#include <optional>

#include "engine/stripe/stripe.h"

namespace vignole {

/// Points of rejected lines do not count. Pixels.
struct LineDifference {
  std::size_t gained = 0, lost = 0;            ///< points of one without any of the other within 1.5 px
  double meanShiftPx = 0, largestShiftPx = 0;  ///< along the normal, of points that both have
  std::optional<PixelPosition> where;          ///< the longest stretch gained or lost, else the largest shift
};
[[nodiscard]] LineDifference lineDifference(const StripeResult& before, const StripeResult& after);

}  // namespace vignole
