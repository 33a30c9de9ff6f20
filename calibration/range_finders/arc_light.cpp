#include "calibration/range_finders/arc_light.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "engine/optics/camera_model.h"
#include "engine/optics/nominal_rig.h"

namespace vignole {

namespace {

constexpr double kStepPx = 0.45;  // between samples: for smoothing by 1.5 px and more the sum is the integral
constexpr double kReachSigmas2 = 36;
constexpr int kNewtonSteps = 4;
constexpr double kLongestStepPx = 1;

Point2 pixel(const RangeFinderCalibration& finder, const Lens<double>& camera, const Point2& world, double z) {
  return project<double>(camera, finder.cameraFromWorld.rotation, finder.cameraFromWorld.translationMm,
                         {world.x(), world.y(), z});
}

}  // namespace

struct ArcLight::LogLight {
  double value = 0;
  Point2 gradient{0, 0};
  Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();
};

double pinLight(const ArcScene& scene, double angleRad) {
  const Point2 normal(std::cos(angleRad), std::sin(angleRad));
  const Point2 at = scene.centreMm + scene.radiusMm * normal;
  const Point3 camera = cameraCentre(scene.finder->cameraFromWorld);
  const Point2 toLaser = scene.laserMm - at;
  const Point3 toCamera = (camera - Point3(at.x(), at.y(), 0)).normalized();
  return std::max(0.0, normal.dot(toLaser)) / toLaser.squaredNorm() *
         std::max(0.0, normal.dot(toCamera.head<2>()));
}

ArcLight::ArcLight(const ArcScene& scene) {
  const RangeFinderCalibration& finder = *scene.finder;
  const Lens<double> camera = lens(finder.intrinsics);
  const auto onPin = [&](double angle) {
    return Point2(scene.centreMm + scene.radiusMm * Point2(std::cos(angle), std::sin(angle)));
  };
  const double middle = (scene.fromRad + scene.toRad) / 2;
  const Point2 nearest = onPin(middle);
  constexpr double kHalfMm = 0.5;
  offPlane_ = pixel(finder, camera, nearest, kHalfMm) - pixel(finder, camera, nearest, -kHalfMm);
  covariance_ = scene.smoothingPx2 * Eigen::Matrix2d::Identity() +
                scene.thicknessMm * scene.thicknessMm * offPlane_ * offPlane_.transpose();
  inverse_ = covariance_.inverse();

  // Steps as even as the picture's scale allows: it hardly changes over a pin, but its foreshortening does.
  const double lengthRad = scene.toRad - scene.fromRad;
  const double perRad = 2 * (pixel(finder, camera, onPin(middle + 1e-3), 0) - pixel(finder, camera, onPin(middle - 1e-3), 0)).norm() / 4e-3;
  const int count = std::clamp(static_cast<int>(std::ceil(lengthRad * std::max(perRad, 1.0) / kStepPx)), 8, 2000);
  samples_.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const double angle = scene.fromRad + (i + 0.5) * lengthRad / count;
    const double light = pinLight(scene, angle);
    if (light > 0) samples_.push_back({pixel(finder, camera, onPin(angle), 0), light * lengthRad / count});
  }
}

double ArcLight::smoothingPx(const Point2& direction) const {
  return std::sqrt(direction.dot(covariance_ * direction));
}

ArcLight::LogLight ArcLight::at(const Point2& px) const {
  double sum = 0, gx = 0, gy = 0, hxx = 0, hxy = 0, hyy = 0;
  const double a = inverse_(0, 0), b = inverse_(0, 1), c = inverse_(1, 1);
  for (const Sample& s : samples_) {
    const double dx = px.x() - s.px.x(), dy = px.y() - s.px.y();
    const double qx = a * dx + b * dy, qy = b * dx + c * dy, square = dx * qx + dy * qy;
    if (square > kReachSigmas2) continue;
    const double light = s.light * std::exp(-0.5 * square);
    sum += light;
    gx -= light * qx;
    gy -= light * qy;
    hxx += light * (qx * qx - a);
    hxy += light * (qx * qy - b);
    hyy += light * (qy * qy - c);
  }
  LogLight log;
  log.value = sum;
  if (!(sum > 0)) return log;
  log.gradient = Point2(gx, gy) / sum;
  log.hessian << hxx, hxy, hxy, hyy;
  log.hessian = log.hessian / sum - log.gradient * log.gradient.transpose();
  return log;
}

ArcLight::Ridge ArcLight::ridgeBeside(const Point2& px) const {
  Ridge ridge;
  ridge.px = px;
  for (int step = 0; step < kNewtonSteps; ++step) {
    const LogLight log = at(ridge.px);
    if (!(log.value > 0)) return ridge;
    const double mean = (log.hessian(0, 0) + log.hessian(1, 1)) / 2, half = (log.hessian(0, 0) - log.hessian(1, 1)) / 2;
    const double mixed = log.hessian(0, 1), root = std::hypot(half, mixed);
    const double curvature = mean - root;  // across the line
    if (!(curvature < 0)) return ridge;
    ridge.normal = half > 0 ? Point2(-mixed, half + root) : Point2(root - half, -mixed);
    if (!(ridge.normal.squaredNorm() > 0)) return ridge;
    ridge.normal.normalize();
    ridge.variancePx2 = -1 / curvature;
    ridge.logLight = std::log(log.value);
    const double offset = -log.gradient.dot(ridge.normal) / curvature;
    if (!(std::abs(offset) < kLongestStepPx * 4)) return ridge;
    ridge.px += std::clamp(offset, -kLongestStepPx, kLongestStepPx) * ridge.normal;
    if (std::abs(offset) < 1e-5) break;
  }
  ridge.found = true;
  return ridge;
}

}  // namespace vignole
