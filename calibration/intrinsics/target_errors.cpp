#include "calibration/intrinsics/target_errors.h"

#include <Eigen/LU>
#include <cmath>

namespace vignole {

namespace {

/// What is seen of one point of the target over all views, in its plane.
struct PointSums {
  double count = 0;
  Point2 sum{0, 0};
  double squares = 0;
};

}  // namespace

double targetErrorMm(const TargetObservations& observations, const TargetFit& fit) {
  constexpr double kMinViews = 3;
  constexpr double kChance = 1.5;  // of the ratio of variances; below it is not worth the unknowns
  std::vector<PointSums> points(observations.points.size());
  for (std::size_t v = 0; v < observations.views.size(); ++v)
    for (const Observation& o : observations.views[v]) {
      const auto index = static_cast<std::size_t>(o.point);
      Reprojection r;
      if (!reproject(fit.intrinsics, fit.cameraFromTarget[v], fit.points[index], observations.radiusMm, r)) continue;
      const Point2 inPlane = r.byPoint.leftCols<2>().inverse() * (o.px - r.px);
      points[index].count += 1;
      points[index].sum += inPlane;
      points[index].squares += inPlane.squaredNorm();
    }
  double within = 0, withinFreedom = 0, between = 0, betweenCount = 0, inverseViews = 0;
  for (const PointSums& p : points) {
    if (p.count < kMinViews) continue;
    const double mean2 = (p.sum / p.count).squaredNorm();
    within += p.squares - p.count * mean2;
    withinFreedom += 2 * (p.count - 1);
    between += mean2 / 2;
    inverseViews += 1 / p.count;
    betweenCount += 1;
  }
  if (betweenCount < 1 || withinFreedom < 1) return 0;
  const double ofChance = within / withinFreedom * inverseViews / betweenCount;  // of a mean over the views of a point
  const double ofMeans = between / betweenCount;
  return ofMeans > kChance * ofChance ? std::sqrt(ofMeans - ofChance) : 0;
}

double effectiveParameters(const TargetObservations& observations, const TargetFit& fit, double pointSigmaMm) {
  if (!(pointSigmaMm > 0)) return 0;
  std::vector<Eigen::Matrix2d> information(observations.points.size(), Eigen::Matrix2d::Zero());
  for (std::size_t v = 0; v < observations.views.size(); ++v)
    for (const Observation& o : observations.views[v]) {
      const auto index = static_cast<std::size_t>(o.point);
      Reprojection r;
      if (!reproject(fit.intrinsics, fit.cameraFromTarget[v], fit.points[index], observations.radiusMm, r)) continue;
      const Eigen::Matrix2d byPoint = r.byPoint.leftCols<2>() / o.sigmaPx;
      information[index] += byPoint.transpose() * byPoint;
    }
  constexpr double kGauge = 4;  // a shift, a turn and a scale of all points are the poses' already
  double sum = 0;
  for (const Eigen::Matrix2d& i : information)
    sum += (i * (i + Eigen::Matrix2d::Identity() / (pointSigmaMm * pointSigmaMm)).inverse()).trace();
  return std::max(0.0, sum - kGauge);
}

}  // namespace vignole
