#pragma once
// How well extracted points meet a scene's truth: the metrics of stripe.md, section 1.

#include <span>

#include "engine/stripe/stripe.h"
#include "tests/synthetic/stripe_scene.h"

namespace vignole::synthetic {

/// rms, bias and worst are of signed perpendicular errors within 3 px, on the body (15 px from ends and gap edges).
struct StripeScore {
  double detection = 0;  ///< share of the visible truth (every px of arc) with a point within 1 px
  int falsePoints = 0;   ///< further than 3 px from the truth
  double rmsPx = 0, biasPx = 0, worstPx = 0;
  double meanSquareZ = 0;  ///< of error / sigmaPx on the body
  double medianSquareZ = 0;
  double edgeMeanSquareZ = 0;  ///< the same for the points that are not on the body
  int bodyPoints = 0;
};

/// Points flagged kRejected are left out.
[[nodiscard]] StripeScore score(const StripeScene& scene, std::span<const StripePoint> points);

}  // namespace vignole::synthetic
