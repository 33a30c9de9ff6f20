#pragma once
// A distorted ellipse is none: its centre is not the distorted centre of the ellipse.

#include "calibration/intrinsics/target_adjustment.h"

namespace vignole {

/// Centroid of the circle's image less what reprojected() says, px: 0.01 px for circles of 13 px radius in the corners
/// of a picture with a distortion of 1 %, and growing with both.
[[nodiscard]] Point2 distortedCircleShift(const Intrinsics& in, const Extrinsics& cameraFromTarget,
                                          const Eigen::Vector3d& centreInTarget, double radiusMm);

/// The observations as they would be if distortion shifted no centre.
[[nodiscard]] TargetObservations withoutCircleShift(const TargetObservations& observations, const TargetFit& fit);

}  // namespace vignole
