#pragma once
// Where a camera sees a point of a target (paper Eq. (1), right-hand side), with the derivatives that adjustments need.

#include <Eigen/Core>

#include "calibration/intrinsics/calibrated_intrinsics.h"
#include "engine/geometry/transform2.h"

namespace vignole {

using IntrinsicVector = Eigen::Matrix<double, kIntrinsicParameters, 1>;

/// Values in the order of CameraParameter, units as in Intrinsics.
[[nodiscard]] IntrinsicVector toVector(const Intrinsics& in);
/// `like` gives what is no parameter: model, pixel width, size of the picture.
[[nodiscard]] Intrinsics fromVector(const IntrinsicVector& values, const Intrinsics& like);

struct Reprojection {
  Point2 px{0, 0};
  Eigen::Matrix<double, 2, kIntrinsicParameters> byIntrinsics;
  Eigen::Matrix<double, 2, 6> byPose;   ///< small turn about the camera's x, y, z, then translation (mm)
  Eigen::Matrix<double, 2, 3> byPoint;  ///< by the point, mm
};

/// `radiusMm` > 0: the point is the centre of a circle in a plane z = const of the target, seen is the centre of its
/// ellipse before distortion (optics design, section 1.2). False where the camera cannot see it: behind the camera, or
/// beyond what the distortion model can project.
[[nodiscard]] bool reproject(const Intrinsics& in, const Extrinsics& cameraFromTarget,
                             const Eigen::Vector3d& pointInTarget, double radiusMm, Reprojection& result);
/// The same without derivatives; NaN where the camera cannot see it.
[[nodiscard]] Point2 reprojected(const Intrinsics& in, const Extrinsics& cameraFromTarget,
                                 const Eigen::Vector3d& pointInTarget, double radiusMm);

/// pose' = exp([turn]x) pose, translation added.
[[nodiscard]] Extrinsics moved(const Extrinsics& pose, const Eigen::Matrix<double, 6, 1>& change);

}  // namespace vignole
