#pragma once
// The plane of a flat target as a camera sees it.

#include <Eigen/Core>

#include "engine/geometry/transform2.h"
#include "engine/optics/calibration.h"
#include "engine/optics/camera_model.h"

namespace vignole::simulator {

/// Pixel -> place on the target. Immutable.
class TargetPlane {
 public:
  TargetPlane(const RangeFinderCalibration& finder, const Extrinsics& cameraFromTarget);
  struct Place {
    Point2 onTarget{0, 0};
    double perFocal = 0;     ///< focal length / distance along the optical axis; not positive: the pixel sees no plane
    double fromLightMm = 0;  ///< distance from the light plane
  };
  [[nodiscard]] Place at(double column, double row) const {
    const Eigen::Vector2d u = undistortedFromPixel(lens_, Vector2T<double>(column, row));
    const Point3 ray(u.x(), u.y(), 1);
    const double inverse = depth_.dot(ray);
    return {Point2(placeX_.dot(ray), placeY_.dot(ray)) / inverse, inverse, light_.dot(ray) / inverse - offset_};
  }

 private:
  Lens<double> lens_;
  Point3 depth_, placeX_, placeY_, light_;
  double offset_ = 0;
};

}  // namespace vignole::simulator
