#include "tests/calibration/synthetic_target/synthetic_views.h"

#include <Eigen/Geometry>
#include <numbers>

#include "engine/optics/camera_model.h"

namespace vignole {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

Point2 pixelOf(const Intrinsics& in, const Extrinsics& pose, const Eigen::Vector3d& point) {
  return project<double>(lens(in), pose.rotation, pose.translationMm, point);
}

Extrinsics drawPose(const SyntheticSettings& s, std::mt19937_64& random) {
  const auto uniform = [&](double from, double to) { return std::uniform_real_distribution<double>(from, to)(random); };
  const Eigen::Vector3d middle(s.target.pitchMm * (s.target.columns - 1) / 2,
                               s.target.pitchMm * (s.target.rows - 1) / 2, 0);
  const double focalPx = s.camera.focalMm / s.camera.pixelWidthMm;
  const double widthMm = s.target.pitchMm * s.target.columns;
  const double distance = focalPx * widthMm / (uniform(0.4, 0.7) * s.camera.widthPx);
  const double tilt = uniform(s.minTiltDeg, s.maxTiltDeg) * kDegree, towards = uniform(0, 2 * std::numbers::pi);
  const Eigen::Vector3d axis(std::cos(towards), std::sin(towards), 0);
  Extrinsics pose;
  pose.rotation =
      (Eigen::AngleAxisd(tilt, axis) * Eigen::AngleAxisd(uniform(-20, 20) * kDegree, Eigen::Vector3d::UnitZ()))
          .toRotationMatrix();
  const double atX = uniform(-0.25, 0.25) * s.camera.widthPx / focalPx,
               atY = uniform(-0.25, 0.25) * s.camera.heightPx / focalPx;
  pose.translationMm = distance * Eigen::Vector3d(atX, atY, 1) - pose.rotation * middle;
  return pose;
}

}  // namespace

Point2 imagedCircleCentre(const Intrinsics& in, const Extrinsics& pose, const Eigen::Vector3d& centre,
                          double radiusMm) {
  constexpr int kCorners = 2000;
  Point2 last = pixelOf(in, pose, centre + Eigen::Vector3d(radiusMm, 0, 0));
  const Point2 origin = last;  // for the sake of the digits
  double area = 0;
  Point2 sum(0, 0);
  for (int i = 1; i <= kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    const Point2 next = pixelOf(in, pose, centre + radiusMm * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0));
    const Point2 a = last - origin, b = next - origin;
    const double cross = a.x() * b.y() - a.y() * b.x();
    area += cross;
    sum += cross * (a + b) / 3;
    last = next;
  }
  return origin + sum / area;
}

SyntheticViews syntheticViews(const SyntheticSettings& s, std::mt19937_64& random) {
  SyntheticViews result;
  std::uniform_real_distribution<double> error(-s.targetErrorMm, s.targetErrorMm);
  const Point2 half(s.target.pitchMm * (s.target.columns - 1) / 2, s.target.pitchMm * (s.target.rows - 1) / 2);
  for (const Point2& p : s.target.points()) {
    const Point2 at = (p - half).cwiseQuotient(half);
    result.points.emplace_back(p.x() + (s.targetErrorMm > 0 ? error(random) : 0),
                               p.y() + (s.targetErrorMm > 0 ? error(random) : 0), s.bendMm * at.x() * at.y());
  }
  std::normal_distribution<double> noise(0, 1);
  for (int v = 0; v < s.views; ++v) {
    const Extrinsics pose = drawPose(s, random);
    TargetView view;
    view.file = "view" + std::to_string(v + 1) + ".png";
    view.widthPx = s.camera.widthPx;
    view.heightPx = s.camera.heightPx;
    for (std::size_t i = 0; i < result.points.size(); ++i) {
      const Point2 px = s.target.diameterMm > 0
                            ? imagedCircleCentre(s.camera, pose, result.points[i], s.target.diameterMm / 2)
                            : pixelOf(s.camera, pose, result.points[i]);
      const Point2 seen = px + s.noisePx * Point2(noise(random), noise(random));
      const bool inside =
          seen.x() > 5 && seen.y() > 5 && seen.x() < s.camera.widthPx - 6 && seen.y() < s.camera.heightPx - 6;
      if (inside) view.points.push_back({static_cast<int>(i), seen, s.uPx < 0 ? s.noisePx : s.uPx});
    }
    view.partial = view.points.size() < result.points.size();
    result.views.push_back(std::move(view));
    result.cameraFromTarget.push_back(pose);
  }
  return result;
}

PlanarTarget chessboard(int columns, int rows, double pitchMm) {
  PlanarTarget target;
  target.columns = columns;
  target.rows = rows;
  target.pitchMm = pitchMm;
  return target;
}

PlanarTarget circles(int columns, int rows, double pitchMm, double diameterMm) {
  PlanarTarget target = chessboard(columns, rows, pitchMm);
  target.pattern = TargetPattern::Circles;
  target.diameterMm = diameterMm;
  return target;
}

Intrinsics usualCamera() {
  Intrinsics in;
  in.focalMm = 16.2;
  in.cxPx = 707.3;
  in.cyPx = 505.8;
  return in;
}

}  // namespace vignole
