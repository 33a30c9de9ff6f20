#pragma once
// Steger's line points over the whole picture, written as the paper reads: five exact Gaussian derivatives in double.
// Slow; the fast extraction is judged by it.

#include <vector>

#include "engine/geometry/image_view.h"
#include "engine/stripe/stripe.h"

namespace vignole::synthetic {

/// Points with |offset| <= 0.5 px, second derivative above low and connected to one above high (8 neighbours), in
/// groups of at least minLength; thresholds as in StripeSettings. Only x, y, nx, ny and strength (for a stripe of sd
/// sigma) are filled; no order.
[[nodiscard]] std::vector<StripePoint> referenceSteger(const ImageView& image, const StripeSettings& settings);

}  // namespace vignole::synthetic
