#pragma once
// Whether the target itself is as stated: what all views see of a point in the same wrong place is the target's fault.

#include "calibration/intrinsics/target_adjustment.h"

namespace vignole {

/// Standard deviations of the target's points from where they are stated to be, by the residuals of a fit that takes
/// them as stated: each point's best place beside how uncertain that is (variance components). 0 where chance explains
/// it. In-plane and out of plane each by itself.
[[nodiscard]] TargetPrior suspectedErrors(const TargetObservations& observations, const TargetFit& fit);

/// How many parameters the estimated points amount to: 3 a point where the views fix it, 0 where the prior does.
[[nodiscard]] double effectiveParameters(const TargetObservations& observations, const TargetFit& fit,
                                         const TargetPrior& prior);

/// Of x, y, z: 1 / sigma^2.
[[nodiscard]] Eigen::Vector3d priorWeights(const TargetPrior& prior);

}  // namespace vignole
