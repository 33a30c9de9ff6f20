#pragma once
// A plane through lines of light whose target planes are not exactly known: generalised least squares, the poses'
// errors common to all points of a view.

#include <Eigen/Core>
#include <vector>

#include "calibration/intrinsics/calibrated_intrinsics.h"
#include "calibration/light_plane/target_stripe.h"

namespace vignole {

/// A line on a target is known by two points of it, whose errors across the line are independent.
struct LinePoint {
  Eigen::Vector3d mm{0, 0, 0};         ///< camera's frame
  Eigen::Vector3d across{0, 0, 0};     ///< unit vector in the target's plane, across the line
  double sigmaMm = 0;                  ///< along it
  Eigen::Matrix<double, 3, 6> byPose;  ///< of the point, by the target's pose
};
struct PlaneView {
  std::vector<LinePoint> points;  ///< two; none where the line cannot be seen with these intrinsics
  Eigen::Matrix<double, 6, 6> poseCovariance;
};
[[nodiscard]] PlaneView planeView(const TargetLine& line, const TargetPose& pose, const Intrinsics& in);

struct FittedPlane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double distanceMm = 0;  ///< >= 0
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
  double chi2PerDof = 0;  ///< of the lines about the plane, by their and their poses' uncertainties
  bool ok = false;
  [[nodiscard]] double distance(const Eigen::Vector3d& p) const { return normal.dot(p) - distanceMm; }
};
/// At least two views. The covariance is widened where the lines scatter more than they say.
[[nodiscard]] FittedPlane fitPlane(const std::vector<PlaneView>& views);

}  // namespace vignole
