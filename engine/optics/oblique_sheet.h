#pragma once
// How the thickness of a laser sheet shows in its plane.

#include <Eigen/LU>

#include "engine/optics/calibration.h"

namespace vignole {

/// The sheet of light has a thickness and is seen obliquely: its light off the plane comes to lie beside the line, so
/// the picture is blurred along `seenAt`. Exact for Gaussian blur and light that changes exponentially along the line.
class ObliqueSheet {
 public:
  ObliqueSheet() = default;
  explicit ObliqueSheet(const RangeFinderCalibration& calibration)
      : variance_(calibration.lightPlane.thicknessMm * calibration.lightPlane.thicknessMm) {
    const Eigen::Vector3d camera =
        -calibration.cameraFromWorld.rotation.transpose() * calibration.cameraFromWorld.translationMm;
    const Eigen::Vector3d& normal = calibration.lightPlane.normal;
    // A point 1 mm off the plane over P is seen at P + normal + (P - camera) / height: linear in P.
    perHeight_ = 1 / (normal.dot(camera) - calibration.lightPlane.distanceMm);
    atOrigin_ = normal.head<2>() - camera.head<2>() * perHeight_;
  }
  [[nodiscard]] double varianceMm2() const { return variance_; }
  /// Where in the plane a point 1 mm off it is seen from the camera, relative to its foot at (x, y): mm.
  [[nodiscard]] Eigen::Vector2d seenAt(double x, double y) const {
    return {atOrigin_.x() + x * perHeight_, atOrigin_.y() + y * perHeight_};
  }

 private:
  Eigen::Vector2d atOrigin_ = Eigen::Vector2d::Zero();
  double perHeight_ = 0, variance_ = 0;
};

}  // namespace vignole
