#include "calibration/range_finders/arc_light.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/optics/camera_model.h"
#include "engine/optics/nominal_rig.h"

namespace vignole {

namespace {

constexpr double kStepPx = 0.45;  // between samples: for smoothing by 1.5 px and more the sum is the integral
constexpr double kReachSigmas2 = 36;
constexpr double kFarthestPx = 3;  // from the middle of a pixel to the ridge: beyond, it is another's

Point2 pixel(const RangeFinderCalibration& finder, const Lens<double>& camera, const Point2& world, double z) {
  return project<double>(camera, finder.cameraFromWorld.rotation, finder.cameraFromWorld.translationMm,
                         {world.x(), world.y(), z});
}

/// The pixel that a point was found from: it lies on the point's normal.
std::pair<double, double> pixelOf(const Point2& px, const Point2& normal) {
  std::pair<double, double> best{std::round(px.x()), std::round(px.y())};
  double least = 1e9;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const double x = std::round(px.x()) + dx, y = std::round(px.y()) + dy;
      const double aside = std::abs((px.x() - x) * normal.y() - (px.y() - y) * normal.x());
      if (aside < least) {
        least = aside;
        best = {x, y};
      }
    }
  return best;
}

}  // namespace

PinLight pinLight(const ArcScene& scene, double angleRad) {
  const Point2 normal(std::cos(angleRad), std::sin(angleRad));
  const Point2 at = scene.centreMm + scene.radiusMm * normal;
  const Point3 camera = cameraCentre(scene.finder->cameraFromWorld);
  const Point3 toCamera = (camera - Point3(at.x(), at.y(), 0)).normalized();
  const double seen = std::max(0.0, normal.dot(toCamera.head<2>()));
  const auto lit = [&](const Point2& laser) {
    const Point2 toLaser = laser - at;
    return seen * std::max(0.0, normal.dot(toLaser)) / toLaser.squaredNorm();
  };
  PinLight light;
  light.own = lit(scene.laserMm);
  for (const Point2& other : scene.othersMm) light.others += lit(other);
  light.all = light.own + scene.otherShare * light.others;
  return light;
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
    const double light = pinLight(scene, angle).all;
    if (light > 0) samples_.push_back({pixel(finder, camera, onPin(angle), 0), light * lengthRad / count});
  }
}

double ArcLight::smoothingPx(const Point2& direction) const {
  return std::sqrt(direction.dot(covariance_ * direction));
}

std::array<double, 9> ArcLight::smoothedAround(double column, double row) const {
  const double a = inverse_(0, 0), b = inverse_(0, 1), c = inverse_(1, 1);
  // exp(-(d + o)' Q (d + o) / 2) for steps o of one pixel: the middle's, times what each step adds.
  const double stepX = std::exp(-a / 2), stepY = std::exp(-c / 2), same = std::exp(-b), opposite = 1 / same;
  std::array<double, 9> sums{};
  for (const Sample& s : samples_) {
    const double dx = column - s.px.x(), dy = row - s.px.y();
    const double qx = a * dx + b * dy, qy = b * dx + c * dy, square = dx * qx + dy * qy;
    if (square > kReachSigmas2) continue;
    const double light = s.light * std::exp(-0.5 * square);
    const double perX = std::exp(qx), perY = std::exp(qy);
    const double right = stepX / perX, left = stepX * perX, below = stepY / perY, above = stepY * perY;
    sums[0] += light * left * above * same;
    sums[1] += light * above;
    sums[2] += light * right * above * opposite;
    sums[3] += light * left;
    sums[4] += light;
    sums[5] += light * right;
    sums[6] += light * left * below * opposite;
    sums[7] += light * below;
    sums[8] += light * right * below * same;
  }
  return sums;
}

// The logarithmic parabola of the extraction (engine/stripe: line_kernels.cpp): the smoothed line is
// L exp(a u - w^2 / 2 v), u along it, w across.
ArcLight::Ridge ArcLight::ridgeBeside(const Point2& px, const Point2& normal) const {
  Ridge ridge;
  const auto [column, row] = pixelOf(px, normal);
  const std::array<double, 9> s = smoothedAround(column, row);
  if (!(s[4] > 0)) return ridge;
  const double dx = (s[5] - s[3]) / (2 * s[4]), dy = (s[7] - s[1]) / (2 * s[4]);
  const double dxx = (s[5] + s[3]) / s[4] - 2, dyy = (s[7] + s[1]) / s[4] - 2;
  const double dxy = (s[8] - s[6] - s[2] + s[0]) / (4 * s[4]);
  const double nx = normal.x(), ny = normal.y(), across = dx * nx + dy * ny;
  const double logCurved = across * across - (dxx * nx * nx + 2 * dxy * nx * ny + dyy * ny * ny);
  if (!(logCurved > 0)) return ridge;
  // Differences instead of derivatives: the variance comes out too large by (1 + p) / 4, the offset short by
  // (1 - 5 p) / (4 v).
  const double slanted = nx * nx * ny * ny;
  ridge.variancePx2 = 1 / logCurved - 0.25 * (1 + slanted);
  const double offset = across / logCurved * (1 + 0.25 * (1 - 5 * slanted) / std::max(ridge.variancePx2, 0.5));
  ridge.px = Point2(column, row) + offset * normal;
  ridge.logLight = std::log(s[4]);
  ridge.found = std::abs(offset) < kFarthestPx;
  return ridge;
}

}  // namespace vignole
