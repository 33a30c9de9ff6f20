#include "calibration/intrinsics/information.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace vignole {

Information::Information(const LensVariant& variant, std::size_t freePoints) {
  for (const CameraParameter p : freeParameters(variant)) free_.push_back(static_cast<int>(p));
  const auto size = static_cast<Eigen::Index>(free_.size() + 2 * freePoints);
  matrix_ = Eigen::MatrixXd::Zero(size, size);
}

void Information::add(const Intrinsics& in, const Extrinsics& cameraFromTarget,
                      const std::vector<Eigen::Vector3d>& points, double radiusMm, const ObservedView& view) {
  const auto n = static_cast<Eigen::Index>(free_.size());
  const bool pointsAreFree = matrix_.rows() > n;
  Eigen::MatrixXd byPose = Eigen::MatrixXd::Zero(matrix_.rows(), 6);
  Eigen::Matrix<double, 6, 6> pose = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 2, Eigen::Dynamic> byFree(2, n);
  for (const Observation& o : view) {
    Reprojection r;
    if (!reproject(in, cameraFromTarget, points[static_cast<std::size_t>(o.point)], radiusMm, r)) continue;
    const double weight = 1 / (o.sigmaPx * o.sigmaPx);
    for (Eigen::Index i = 0; i < n; ++i) byFree.col(i) = r.byIntrinsics.col(free_[static_cast<std::size_t>(i)]);
    matrix_.topLeftCorner(n, n) += weight * byFree.transpose() * byFree;
    byPose.topRows(n) += weight * byFree.transpose() * r.byPose;
    pose += weight * r.byPose.transpose() * r.byPose;
    if (!pointsAreFree) continue;
    const Eigen::Index at = n + 2 * o.point;
    const Eigen::Matrix2d byPoint = r.byPoint.leftCols<2>();
    matrix_.block<2, 2>(at, at) += weight * byPoint.transpose() * byPoint;
    const Eigen::MatrixXd mixed = weight * byPoint.transpose() * byFree;
    matrix_.block(at, 0, 2, n) += mixed;
    matrix_.block(0, at, n, 2) += mixed.transpose();
    byPose.middleRows<2>(at) += weight * byPoint.transpose() * r.byPose;
  }
  const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> factor(pose);
  if (factor.info() == Eigen::Success && factor.isPositive()) matrix_ -= byPose * factor.solve(byPose.transpose());
}

void Information::addPointPriors(double sigmaMm) {
  const auto n = static_cast<Eigen::Index>(free_.size());
  matrix_.diagonal().tail(matrix_.rows() - n).array() += 1 / (sigmaMm * sigmaMm);
}

Eigen::Matrix<double, kIntrinsicParameters, kIntrinsicParameters> Information::covariance() const {
  Eigen::Matrix<double, kIntrinsicParameters, kIntrinsicParameters> covariance;
  covariance.setZero();
  const auto n = static_cast<Eigen::Index>(free_.size());
  // Points first: they are many and well determined. Then the units, which differ by orders of magnitude.
  Eigen::MatrixXd reduced = matrix_.topLeftCorner(n, n);
  if (const Eigen::Index points = matrix_.rows() - n; points > 0) {
    const Eigen::LDLT<Eigen::MatrixXd> factor(matrix_.bottomRightCorner(points, points));
    reduced -= matrix_.topRightCorner(n, points) * factor.solve(matrix_.bottomLeftCorner(points, n));
  }
  const Eigen::VectorXd scale =
      matrix_.diagonal().head(n).unaryExpr([](double d) { return d > 0 ? 1 / std::sqrt(d) : 1.0; });
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scale.asDiagonal() * reduced * scale.asDiagonal());
  constexpr double kNothing = 1e-15;  // of what a parameter would be known by if all others were
  const Eigen::VectorXd inverse = solver.eigenvalues().cwiseMax(kNothing).cwiseInverse();
  const Eigen::MatrixXd dense = scale.asDiagonal() * solver.eigenvectors() * inverse.asDiagonal() *
                                solver.eigenvectors().transpose() * scale.asDiagonal();
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      covariance(free_[static_cast<std::size_t>(i)], free_[static_cast<std::size_t>(j)]) =
          (dense(i, j) + dense(j, i)) / 2;
  return covariance;
}

Information informationOf(const TargetObservations& observations, const LensVariant& variant, const TargetFit& fit,
                          double pointSigmaMm) {
  const bool free = pointSigmaMm > 0;
  Information information(variant, free ? fit.points.size() : 0);
  for (std::size_t v = 0; v < observations.views.size(); ++v)
    information.add(fit.intrinsics, fit.cameraFromTarget[v], fit.points, observations.radiusMm, observations.views[v]);
  if (free) information.addPointPriors(pointSigmaMm);
  return information;
}

}  // namespace vignole
