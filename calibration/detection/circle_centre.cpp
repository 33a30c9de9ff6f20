#include "calibration/detection/circle_centre.h"

#include <Eigen/LU>

#include "engine/optics/camera_model.h"

namespace vignole {

Point2 circleImageShift(const Intrinsics& in, const Extrinsics& cameraFromTarget, const Point2& centreMm,
                        double radiusMm) {
  const Lens<double> camera = lens(in);
  const Eigen::Matrix3d& r = cameraFromTarget.rotation;
  const Point3 centre = r.col(0) * centreMm.x() + r.col(1) * centreMm.y() + cameraFromTarget.translationMm;
  const Point2 pole = circleCentreInPlane<double>(centreMm, radiusMm, r(2, 0), r(2, 1), centre.z());
  const Point3 at = r.col(0) * pole.x() + r.col(1) * pole.y() + cameraFromTarget.translationMm;
  const double perDepth = in.focalMm / at.z();
  const Point2 undistorted = perDepth * at.head<2>();
  // Half axes of the ellipse: a radius along the target's x and one along its y, seen from the camera.
  const auto halfAxis = [&](int axis) -> Point2 {
    return radiusMm * perDepth * (r.col(axis).head<2>() - r(2, axis) * at.head<2>() / at.z());
  };
  const Point2 a = halfAxis(0), b = halfAxis(1);
  const auto seen = [&](const Point2& offset) -> Point2 {
    return pixelFromSensor(camera, distort(camera, Vector2T<double>(undistorted + offset)));
  };
  const Point2 middle = seen({0, 0});
  const auto second = [&](const Point2& offset) -> Point2 { return seen(offset) + seen(-offset) - 2 * middle; };
  // On the ellipse middle + a cos + b sin the lens adds aa cos^2 / 2 + ab cos sin + bb sin^2 / 2: a constant, and two
  // waves of twice the frequency, of whose parts across the ellipse one half looks like a shift.
  const Point2 aa = second(a), bb = second(b), ab = 0.5 * (second(a + b) - aa - bb);
  Eigen::Matrix2d fromUnitCircle;
  const auto inPx = [&](const Point2& v) { return Point2(v.x() / in.pixelWidthMm, v.y() / in.pixelHeightMm); };
  fromUnitCircle << inPx(a), inPx(b);
  const Eigen::Matrix2d toUnitCircle = fromUnitCircle.inverse();
  const Point2 constant = toUnitCircle * (aa + bb) / 4, cosine = toUnitCircle * (aa - bb) / 4,
               sine = toUnitCircle * ab / 2;
  return fromUnitCircle * (constant + 0.5 * Point2(cosine.x() + sine.y(), sine.x() - cosine.y()));
}

}  // namespace vignole
