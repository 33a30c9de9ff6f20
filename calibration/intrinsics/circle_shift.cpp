#include "calibration/intrinsics/circle_shift.h"

#include <array>
#include <cmath>
#include <numbers>

#include "engine/optics/camera_model.h"

namespace vignole {

namespace {

constexpr int kCorners = 32;  // what a polygon is off by is the same before and after distortion
using Polygon = std::array<Point2, kCorners>;

Point2 centroid(const Polygon& polygon) {
  double area = 0;
  Point2 sum(0, 0);
  const Point2 origin = polygon.front();  // for the sake of the digits
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2 a = polygon[i] - origin, b = polygon[(i + 1) % polygon.size()] - origin;
    const double cross = a.x() * b.y() - a.y() * b.x();
    area += cross;
    sum += cross * (a + b) / 3;
  }
  return origin + sum / area;
}

}  // namespace

Point2 distortedCircleShift(const Intrinsics& in, const Extrinsics& pose, const Eigen::Vector3d& centre,
                            double radiusMm) {
  const Lens<double> l = lens(in);
  Polygon before, after;
  for (std::size_t i = 0; i < kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / kCorners;
    const Eigen::Vector3d inCamera =
        pose.rotation * (centre + radiusMm * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0)) + pose.translationMm;
    before[i] = in.focalMm / inCamera.z() * inCamera.head<2>();
    after[i] = pixelFromSensor(l, distort(l, before[i]));
  }
  return centroid(after) - pixelFromSensor(l, distort(l, centroid(before)));
}

TargetObservations withoutCircleShift(const TargetObservations& observations, const TargetFit& fit) {
  TargetObservations shifted = observations;
  if (!(observations.radiusMm > 0)) return shifted;
  for (std::size_t v = 0; v < shifted.views.size(); ++v)
    for (Observation& o : shifted.views[v]) {
      const Point2 shift = distortedCircleShift(fit.intrinsics, fit.cameraFromTarget[v],
                                                fit.points[static_cast<std::size_t>(o.point)], observations.radiusMm);
      if (shift.allFinite()) o.px -= shift;
    }
  return shifted;
}

}  // namespace vignole
