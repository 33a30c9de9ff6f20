#pragma once
// Whether the points of the target are taken as they are stated, or estimated with the camera.

#include "calibration/intrinsics/model_choice.h"

namespace vignole {

/// A stated uncertainty (> 0) is taken at its word. Beyond it points are estimated, in the plane or out of it as well,
/// where the views agree that they are out of place (suspectedErrors) and pictures not seen are predicted better so.
/// `fit` takes the target as stated.
[[nodiscard]] Expected<TargetPrior> decideTarget(const TargetObservations& observations, const LensVariant& variant,
                                                 const TargetFit& fit, double statedMm,
                                                 const CrossValidationSettings& settings, const Job& job);

}  // namespace vignole
