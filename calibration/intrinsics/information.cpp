#include "calibration/intrinsics/information.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "calibration/intrinsics/target_errors.h"

namespace vignole {

namespace {

/// Units differ by orders of magnitude, so it is inverted with about ones on its diagonal: divided by the square roots
/// of `diagonal`. Directions without information get next to none.
Eigen::MatrixXd inverse(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& diagonal) {
  constexpr double kNothing = 1e-15;
  const Eigen::VectorXd scale = diagonal.unaryExpr([](double d) { return d > 0 ? 1 / std::sqrt(d) : 1.0; });
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scale.asDiagonal() * matrix * scale.asDiagonal());
  const Eigen::VectorXd inverted = solver.eigenvalues().cwiseMax(kNothing).cwiseInverse();
  return scale.asDiagonal() * solver.eigenvectors() * inverted.asDiagonal() * solver.eigenvectors().transpose() *
         scale.asDiagonal();
}

}  // namespace

Information::Information(const LensVariant& variant, std::size_t freePoints) {
  for (const CameraParameter p : freeParameters(variant)) free_.push_back(static_cast<int>(p));
  const auto size = static_cast<Eigen::Index>(free_.size() + 3 * freePoints);
  matrix_ = Eigen::MatrixXd::Zero(size, size);
}

Information::Information(const LensVariant& variant,
                         const Eigen::Matrix<double, kIntrinsicParameters, kIntrinsicParameters>& covariance)
    : Information(variant, 0) {
  for (Eigen::Index i = 0; i < matrix_.rows(); ++i)
    for (Eigen::Index j = 0; j < matrix_.cols(); ++j)
      matrix_(i, j) = covariance(free_[static_cast<std::size_t>(i)], free_[static_cast<std::size_t>(j)]);
  matrix_ = inverse(matrix_, matrix_.diagonal());
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
    const Eigen::Index at = n + 3 * o.point;
    matrix_.block<3, 3>(at, at) += weight * r.byPoint.transpose() * r.byPoint;
    const Eigen::MatrixXd mixed = weight * r.byPoint.transpose() * byFree;
    matrix_.block(at, 0, 3, n) += mixed;
    matrix_.block(0, at, n, 3) += mixed.transpose();
    byPose.middleRows<3>(at) += weight * r.byPoint.transpose() * r.byPose;
  }
  const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> factor(pose);
  if (factor.info() == Eigen::Success && factor.isPositive()) matrix_ -= byPose * factor.solve(byPose.transpose());
}

void Information::add(const TargetPrior& prior) {
  const Eigen::Vector3d weights = priorWeights(prior);
  for (auto at = static_cast<Eigen::Index>(free_.size()); at < matrix_.rows(); at += 3)
    matrix_.diagonal().segment<3>(at) += weights;
}

Eigen::Matrix<double, kIntrinsicParameters, kIntrinsicParameters> Information::covariance() const {
  Eigen::Matrix<double, kIntrinsicParameters, kIntrinsicParameters> covariance;
  covariance.setZero();
  const auto n = static_cast<Eigen::Index>(free_.size());
  Eigen::MatrixXd reduced = matrix_.topLeftCorner(n, n);
  if (const Eigen::Index points = matrix_.rows() - n; points > 0) {
    const Eigen::LDLT<Eigen::MatrixXd> factor(matrix_.bottomRightCorner(points, points));
    reduced -= matrix_.topRightCorner(n, points) * factor.solve(matrix_.bottomLeftCorner(points, n));
  }
  const Eigen::MatrixXd dense = inverse(reduced, matrix_.diagonal().head(n));
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      covariance(free_[static_cast<std::size_t>(i)], free_[static_cast<std::size_t>(j)]) =
          (dense(i, j) + dense(j, i)) / 2;
  return covariance;
}

Information informationOf(const TargetObservations& observations, const LensVariant& variant, const TargetFit& fit,
                          const TargetPrior& prior) {
  Information information(variant, prior.free() ? fit.points.size() : 0);
  for (std::size_t v = 0; v < observations.views.size(); ++v)
    information.add(fit.intrinsics, fit.cameraFromTarget[v], fit.points, observations.radiusMm, observations.views[v]);
  if (prior.free()) information.add(prior);
  return information;
}

}  // namespace vignole
