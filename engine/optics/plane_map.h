#pragma once
// Image -> light plane (paper section II-E, Eq. (1) inverted): what runs for every point of every profile.

#include <Eigen/Core>
#include <span>

#include "engine/optics/calibration.h"
#include "engine/optics/camera_model.h"

namespace vignole {

/// Point of the light plane in the world, mm, and its derivatives by the pixel's column and row, mm per px.
struct PlanePoint {
  double x = 0, y = 0;
  double dxdc = 0, dxdr = 0, dydc = 0, dydr = 0;
};

/// Pixel -> undistorted sensor point -> homography of the light plane (any plane, not only z = 0). Immutable, so it may
/// be shared between threads. Pixels whose ray misses the plane give infinite or meaningless coordinates.
class PlaneMap {
 public:
  explicit PlaneMap(const RangeFinderCalibration& calibration);
  [[nodiscard]] PlanePoint operator()(double column, double row) const;
  /// All three of the same length.
  void map(std::span<const float> columns, std::span<const float> rows, std::span<PlanePoint> points) const;

 private:
  Lens<double> lens_;
  Eigen::Matrix3d planeFromSensor_;  ///< homogeneous (x, y, w) in the world from (u, v, 1) in mm on the sensor
};

}  // namespace vignole
