#include "calibration/intrinsics/target_errors.h"

#include <Eigen/LU>
#include <cmath>

namespace vignole {

namespace {

/// What all views tell of one point: normal equations of its place.
struct PointEquations {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  int views = 0;
};

std::vector<PointEquations> pointEquations(const TargetObservations& observations, const TargetFit& fit) {
  std::vector<PointEquations> points(observations.points.size());
  for (std::size_t v = 0; v < observations.views.size(); ++v)
    for (const Observation& o : observations.views[v]) {
      const auto index = static_cast<std::size_t>(o.point);
      Reprojection r;
      if (!reproject(fit.intrinsics, fit.cameraFromTarget[v], fit.points[index], observations.radiusMm, r)) continue;
      const double weight = 1 / (o.sigmaPx * o.sigmaPx);
      points[index].matrix += weight * r.byPoint.transpose() * r.byPoint;
      points[index].right += weight * r.byPoint.transpose() * (o.px - r.px);
      points[index].views += 1;
    }
  return points;
}

/// Mean of what squares are larger than chance makes them, weighted by how well each is known.
class VarianceComponent {
 public:
  void add(double square, double ofChance) {
    const double weight = 1 / (ofChance * ofChance);
    excess_ += weight * (square - ofChance);
    squaredWeights_ += weight * weight * 2 * ofChance * ofChance;
    weights_ += weight;
  }
  /// Standard deviation; 0 below three standard errors of the excess, were there none.
  [[nodiscard]] double sigma() const {
    constexpr double kChance = 3;
    if (!(weights_ > 0) || !(excess_ > kChance * std::sqrt(squaredWeights_))) return 0;
    return std::sqrt(excess_ / weights_);
  }

 private:
  double excess_ = 0, squaredWeights_ = 0, weights_ = 0;
};

}  // namespace

TargetPrior suspectedErrors(const TargetObservations& observations, const TargetFit& fit) {
  constexpr int kMinViews = 3;
  VarianceComponent inPlane, outOfPlane;
  for (const PointEquations& p : pointEquations(observations, fit)) {
    if (p.views < kMinViews) continue;
    // In the plane as of a flat target: a height that the views leave open shall not blur it.
    const Eigen::Matrix2d covariance2 = p.matrix.topLeftCorner<2, 2>().inverse();
    const Eigen::Vector2d place2 = covariance2 * p.right.head<2>();
    for (int i = 0; i < 2; ++i) inPlane.add(place2[i] * place2[i], covariance2(i, i));
    const Eigen::Matrix3d covariance3 = p.matrix.inverse();
    const double height = covariance3.row(2) * p.right;
    if (covariance3(2, 2) > 0 && std::isfinite(height)) outOfPlane.add(height * height, covariance3(2, 2));
  }
  return {inPlane.sigma(), outOfPlane.sigma()};
}

Eigen::Vector3d priorWeights(const TargetPrior& prior) {
  constexpr double kAsGoodAsFlatMm = 1e-6;
  const double height = std::max(prior.outOfPlaneMm, kAsGoodAsFlatMm);
  return {1 / (prior.inPlaneMm * prior.inPlaneMm), 1 / (prior.inPlaneMm * prior.inPlaneMm), 1 / (height * height)};
}

double effectiveParameters(const TargetObservations& observations, const TargetFit& fit, const TargetPrior& prior) {
  if (!prior.free()) return 0;
  // A shift, a turn and a scale of all points, and two tilts and a shift out of the plane, are the poses' already.
  const double gauge = prior.outOfPlaneMm > 0 ? 7 : 4;
  double sum = 0;
  for (const PointEquations& p : pointEquations(observations, fit)) {
    Eigen::Matrix3d total = p.matrix;
    total.diagonal() += priorWeights(prior);
    sum += (total.inverse() * p.matrix).trace();
  }
  return std::max(0.0, sum - gauge);
}

}  // namespace vignole
