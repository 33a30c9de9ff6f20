#include "calibration/assessment/pin_centres.h"

#include <Eigen/LU>
#include <cmath>

#include "engine/optics/nominal_rig.h"

namespace vignole {

Point2 pixelOf(const RangeFinderCalibration& finder, const Point2& mm) {
  const LightPlane& plane = finder.lightPlane;
  const double z = (plane.distanceMm - plane.normal.head<2>().dot(mm)) / plane.normal.z();
  return project<double>(lens(finder.intrinsics), finder.cameraFromWorld.rotation, finder.cameraFromWorld.translationMm,
                         {mm.x(), mm.y(), z});
}

std::vector<PinPixels> pinPixels(const RigAdjustment& adjustment) {
  std::vector<PinPixels> all;
  for (const PinView& view : adjustment.pins) {
    if (!view.used || view.pointsInWorld.size() < 3) continue;
    const auto c = static_cast<std::size_t>(view.camera);
    PinPixels arc{view.pin,
                  view.camera,
                  view.placement,
                  {},
                  adjustment.finders[c].noisePx,
                  adjustment.finders[c].correlatedPoints,
                  view.arcDeg};
    for (const Point2& p : view.pointsInWorld) arc.px.push_back(pixelOf(adjustment.calibration.rangeFinders[c], p));
    all.push_back(std::move(arc));
  }
  return all;
}

namespace {

constexpr std::size_t kFewestPoints = 8;

/// A radius behind the middle of the arc: what a camera sees of a pin bulges towards it.
Point2 roughCentre(const std::vector<PlanePoint>& points, double radiusMm, const Point2& camera) {
  const PlanePoint &a = points.front(), &m = points[points.size() / 2], &b = points.back();
  const Point2 middle(m.x, m.y), chord(b.x - a.x, b.y - a.y);
  const Point2 across = Point2(-chord.y(), chord.x()).normalized();
  return middle - std::copysign(radiusMm, across.dot(camera - middle)) * across;
}

}  // namespace

namespace {

/// Of A^-1 sum(w g e), the errors e of points k apart correlated by exp(-k^2 / 4 s^2): as a Gaussian filter leaves
/// them.
template <int N>
Eigen::Matrix<double, N, N> covarianceOf(const Eigen::Matrix<double, N, N>& inverse,
                                         const std::vector<Eigen::Matrix<double, N, 1>>& gradients,
                                         double correlatedPoints) {
  const double s = std::max(correlatedPoints, 1.0) / 3.5449;  // s = c / (2 sqrt(pi))
  const auto reach = static_cast<std::size_t>(std::ceil(5 * s));
  Eigen::Matrix<double, N, N> shared = Eigen::Matrix<double, N, N>::Zero();
  for (std::size_t i = 0; i < gradients.size(); ++i)
    for (std::size_t j = i; j < std::min(gradients.size(), i + reach + 1); ++j) {
      const auto apart = static_cast<double>(j - i);
      const double r = correlatedPoints > 1 ? std::exp(-apart * apart / (4 * s * s)) : (j == i ? 1.0 : 0.0);
      const Eigen::Matrix<double, N, N> product = r * gradients[i] * gradients[j].transpose();
      shared += product;
      if (j != i) shared += product.transpose();
    }
  return inverse * shared * inverse;
}

}  // namespace

PinCentre centreOf(const PinPixels& arc, const RangeFinderCalibration& finder, double radiusMm) {
  const PlaneMap map(finder);
  constexpr int kSteps = 20;
  constexpr double kSettledMm = 1e-7;
  std::vector<PlanePoint> points;
  for (const Point2& px : arc.px) points.push_back(map(px.x(), px.y()));
  if (points.size() < kFewestPoints) return {};
  const Point2 camera = cameraCentre(finder.cameraFromWorld).head<2>();
  PinCentre centre{false, roughCentre(points, radiusMm, camera), Eigen::Matrix2d::Zero()};
  for (int step = 0; step < kSteps; ++step) {
    Eigen::Matrix2d a = Eigen::Matrix2d::Zero();
    Point2 b(0, 0);
    std::vector<Point2> gradients;  // over the standard uncertainty of each point
    for (const PlanePoint& p : points) {
      const Point2 from = Point2(p.x, p.y) - centre.mm;
      const double distance = from.norm();
      if (!(distance > 0)) return {};
      const Point2 n = from / distance;
      // A step of 1 px along the normal is this many mm of the radius.
      const double gx = p.dxdc * n.x() + p.dydc * n.y(), gy = p.dxdr * n.x() + p.dydr * n.y();
      const double sigma = std::max(arc.sigmaPx, 1e-4) * std::hypot(gx, gy), weight = 1 / (sigma * sigma);
      a += weight * n * n.transpose();
      gradients.emplace_back(n / sigma);
      b += weight * (distance - radiusMm) * n;
    }
    if (!(a.determinant() > 1e-9 * a.trace() * a.trace())) return {};
    const Point2 change = a.inverse() * b;
    if (!change.allFinite()) return {};
    centre.mm += change;
    if (change.norm() < kSettledMm) {
      centre.covariance = covarianceOf<2>(a.inverse(), gradients, arc.correlatedPoints);
      centre.valid = true;
      return centre;
    }
  }
  return {};
}

PinRadius radiusOf(const PinPixels& arc, const RangeFinderCalibration& finder, double statedMm) {
  constexpr int kSteps = 30;
  constexpr double kSettledMm = 1e-7;
  const PinCentre start = centreOf(arc, finder, statedMm);
  if (!start.valid) return {};
  const PlaneMap map(finder);
  Eigen::Vector3d circle(start.mm.x(), start.mm.y(), statedMm);
  for (int step = 0; step < kSteps; ++step) {
    Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    std::vector<Eigen::Vector3d> gradients;
    for (const Point2& px : arc.px) {
      const PlanePoint p = map(px.x(), px.y());
      const Point2 from = Point2(p.x, p.y) - circle.head<2>();
      const double distance = from.norm();
      if (!(distance > 0)) return {};
      const Point2 n = from / distance;
      const double sigma =
          std::max(arc.sigmaPx, 1e-4) * std::hypot(p.dxdc * n.x() + p.dydc * n.y(), p.dxdr * n.x() + p.dydr * n.y());
      const Eigen::Vector3d gradient = Eigen::Vector3d(n.x(), n.y(), 1) / sigma;
      a += gradient * gradient.transpose();
      b += gradient * (distance - circle.z()) / sigma;
      gradients.push_back(gradient);
    }
    const Eigen::Matrix3d inverse = a.inverse();
    const Eigen::Vector3d change = inverse * b;
    if (!change.allFinite() || change.norm() > statedMm) return {};
    circle += change;
    if (change.norm() < kSettledMm)
      return {true, circle.z(), std::sqrt(covarianceOf<3>(inverse, gradients, arc.correlatedPoints)(2, 2))};
  }
  return {};
}

void PinMisfit::add(const Point2& differenceMm, const Eigen::Matrix2d& covariance) {
  const Eigen::Matrix2d information = covariance.inverse();
  chi2_ += differenceMm.dot(information * differenceMm);
  information_ += information.trace();
  ++count_;
}
double PinMisfit::rmsMm() const { return information_ > 0 ? std::sqrt(chi2_ / information_) : 0; }
double PinMisfit::expectedMm() const { return information_ > 0 ? std::sqrt(2 * count_ / information_) : 0; }
PinMisfit& PinMisfit::operator+=(const PinMisfit& other) {
  chi2_ += other.chi2_;
  information_ += other.information_;
  count_ += other.count_;
  return *this;
}

Eigen::Matrix<double, 2, kCameraParameters> placeJacobian(const RangeFinderCalibration& finder, const Point2& px) {
  // Steps that move a place by about a micrometre.
  constexpr std::array<double, kCameraParameters> kSteps = {1e-4, 1e-7, 1e-2, 1e-2, 1e-7, 1e-7, 1e-8, 1e-9,
                                                            1e-7, 1e-7, 1e-5, 1e-5, 1e-5, 1e-3, 1e-3, 1e-3};
  Eigen::Matrix<double, 2, kCameraParameters> jacobian;
  for (int k = 0; k < kCameraParameters; ++k) {
    std::array<Point2, 2> places;
    for (const int side : {0, 1}) {
      CameraChange change = CameraChange::Zero();
      change[k] = (side == 0 ? -1 : 1) * kSteps[static_cast<std::size_t>(k)];
      RangeFinderCalibration moved = finder;
      apply(change, moved);
      const PlanePoint p = PlaneMap(moved)(px.x(), px.y());
      places[static_cast<std::size_t>(side)] = {p.x, p.y};
    }
    jacobian.col(k) = (places[1] - places[0]) / (2 * kSteps[static_cast<std::size_t>(k)]);
  }
  return jacobian;
}

}  // namespace vignole
