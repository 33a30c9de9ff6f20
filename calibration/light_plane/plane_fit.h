#pragma once
// A plane through lines of light whose target planes are not exactly known: generalised least squares, the poses'
// errors common to all points of a view.

#include <Eigen/Core>
#include <vector>

#include "calibration/intrinsics/calibrated_intrinsics.h"
#include "calibration/light_plane/target_stripe.h"

namespace vignole {

struct PlanePoint3 {
  Eigen::Vector3d mm{0, 0, 0};         ///< camera's frame
  Eigen::Vector3d perPx{0, 0, 0};      ///< by a shift of the line along its normal in the picture
  Eigen::Matrix<double, 3, 6> byPose;  ///< by the target's pose
  double sigmaPx = 0;
};
struct PlaneView {
  std::vector<PlanePoint3> points;
  Eigen::Matrix<double, 6, 6> poseCovariance;
};
/// Points of a line in the camera's frame.
[[nodiscard]] PlaneView planeView(const TargetLine& line, const TargetPose& pose, const Intrinsics& in);

struct FittedPlane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double distanceMm = 0;  ///< >= 0
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
  double chi2PerDof = 0, poseChi2PerDof = 0;
  bool ok = false;
  [[nodiscard]] double distance(const Eigen::Vector3d& p) const { return normal.dot(p) - distanceMm; }
};
/// At least 3 points. Uncertainties are widened where the points, or the views, scatter more than they say.
[[nodiscard]] FittedPlane fitPlane(const std::vector<PlaneView>& views);

/// Standard uncertainty of a view's line along the plane's normal, its pose's part included, mm.
[[nodiscard]] double lineUncertainty(const PlaneView& view, const Eigen::Vector3d& normal);

}  // namespace vignole
