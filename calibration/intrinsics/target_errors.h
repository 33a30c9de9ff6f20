#pragma once
// Whether the target itself is as stated: what all views see of a point in the same wrong place is the target's fault.

#include "calibration/intrinsics/target_adjustment.h"

namespace vignole {

/// Standard deviation of the target's points from where they are stated to be, each coordinate, mm, by the residuals of
/// a fit that takes them as stated (analysis of variance: between points against within). 0 where chance explains all,
/// or fewer than `minViews` views show a point.
[[nodiscard]] double targetErrorMm(const TargetObservations& observations, const TargetFit& fit);

/// How many parameters the estimated points amount to: 2 a point where the views fix it, 0 where the prior does.
[[nodiscard]] double effectiveParameters(const TargetObservations& observations, const TargetFit& fit,
                                         double pointSigmaMm);

}  // namespace vignole
