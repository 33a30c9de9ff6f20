#pragma once
// A distorted ellipse is none: its centre is not the distorted centre of the ellipse.

#include "calibration/intrinsics/target_adjustment.h"

namespace vignole {

/// The observations of circles as they would be if distortion shifted no centre (circleImageShift() taken off, by the
/// fit): what reprojected() has to meet.
[[nodiscard]] TargetObservations withoutCircleShift(const TargetObservations& observations, const TargetFit& fit);

}  // namespace vignole
