#include "engine/simulator/target_plane.h"

namespace vignole::simulator {

TargetPlane::TargetPlane(const RangeFinderCalibration& finder, const Extrinsics& cameraFromTarget)
    : lens_(lens(finder.intrinsics)) {
  const Eigen::Matrix3d back = cameraFromTarget.rotation.transpose();
  const Point3 centre = -(back * cameraFromTarget.translationMm);
  // Ray (u, v, f): place = centre + s * back * ray, s = -centre_z / (back * ray)_z.
  Eigen::Matrix3d rays = back;
  rays.col(2) *= lens_.focalMm;
  depth_ = rays.row(2).transpose() / (-centre.z());  // 1/s
  placeX_ = centre.x() * depth_ + rays.row(0).transpose();
  placeY_ = centre.y() * depth_ + rays.row(1).transpose();
  // The rig knows the light plane in the world.
  const Extrinsics& pose = finder.cameraFromWorld;
  const Point3 normal = pose.rotation * finder.lightPlane.normal;
  offset_ = finder.lightPlane.distanceMm + normal.dot(pose.translationMm);
  light_ = Point3(normal.x(), normal.y(), normal.z() * lens_.focalMm);
}

}  // namespace vignole::simulator
