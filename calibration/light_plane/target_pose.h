#pragma once
// Where a flat target stands before a camera whose lens is known.

#include <Eigen/Core>

#include "calibration/detection/target_finder.h"
#include "engine/optics/calibration.h"

namespace vignole {

struct TargetPose {
  Extrinsics cameraFromTarget;
  /// Of a small turn about the camera's x, y, z (rad) and of the translation (mm), as moved() of reprojection.h. Where
  /// the points scatter more than they say, by that scatter.
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
  double rmsPx = 0;       ///< distances of the points, outliers too
  double chi2PerDof = 1;  ///< by the finder's uncertainties
};

/// Robust. Errors: fewer than 4 points, points on one line, nothing that fits.
[[nodiscard]] Expected<TargetPose> targetPose(const TargetView& view, const PlanarTarget& target, const Intrinsics& in);

}  // namespace vignole
