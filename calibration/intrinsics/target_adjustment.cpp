#include "calibration/intrinsics/target_adjustment.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <ceres/loss_function.h>
#include <ceres/manifold.h>
#include <ceres/problem.h>
#include <ceres/sized_cost_function.h>
#include <ceres/solver.h>
#include <memory>

#include "calibration/intrinsics/quiet_ceres.h"

namespace vignole {

namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
constexpr double kCauchySigmas = 2;

/// How exp([w]x) turns when w changes: the left Jacobian of the rotation group.
Eigen::Matrix3d turnByVector(const Eigen::Vector3d& w) {
  Eigen::Matrix3d cross;
  cross << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
  const double angle = w.norm();
  constexpr double kSmall = 1e-4;  // below, the series is exact
  if (angle < kSmall) return Eigen::Matrix3d::Identity() + cross / 2 + cross * cross / 6;
  const double a2 = angle * angle;
  return Eigen::Matrix3d::Identity() + (1 - std::cos(angle)) / a2 * cross +
         (angle - std::sin(angle)) / (a2 * angle) * cross * cross;
}

/// Row by row, as Ceres wants it.
template <int Columns>
void put(const Eigen::Matrix<double, 2, Columns>& derivatives, double* memory) {
  Eigen::Map<Eigen::Matrix<double, 2, Columns, Eigen::RowMajor>> target(memory);
  target = derivatives;
}

/// One observed point: unknowns are the intrinsics, the change of the view's pose, the point.
class PointResidual : public ceres::SizedCostFunction<2, kIntrinsicParameters, 6, 3> {
 public:
  PointResidual(const Observation& observation, const Intrinsics& like, const Extrinsics& start, double radiusMm)
      : observation_(observation), like_(like), start_(start), radiusMm_(radiusMm) {}

  bool Evaluate(const double* const* parameters, double* residual, double** jacobians) const override {
    const Intrinsics in = fromVector(Eigen::Map<const IntrinsicVector>(parameters[0]), like_);
    const Eigen::Map<const Vector6> change(parameters[1]);
    const Eigen::Vector3d point = Eigen::Map<const Eigen::Vector3d>(parameters[2]);
    const Extrinsics pose = moved(start_, change);
    const double weight = 1 / observation_.sigmaPx;
    Eigen::Map<Eigen::Vector2d> error(residual);
    if (jacobians == nullptr) {
      error = weight * (reprojected(in, pose, point, radiusMm_) - observation_.px);
      return error.allFinite();
    }
    Reprojection r;
    if (!reproject(in, pose, point, radiusMm_, r)) return false;
    error = weight * (r.px - observation_.px);
    if (jacobians[0] != nullptr) put<kIntrinsicParameters>(weight * r.byIntrinsics, jacobians[0]);
    if (jacobians[1] != nullptr) {
      r.byPose.leftCols<3>() *= turnByVector(change.head<3>());
      put<6>(weight * r.byPose, jacobians[1]);
    }
    if (jacobians[2] != nullptr) put<3>(weight * r.byPoint, jacobians[2]);
    return true;
  }

 private:
  Observation observation_;
  const Intrinsics& like_;
  const Extrinsics& start_;
  double radiusMm_;
};

/// What is known of a point of the target beforehand.
class PointPrior : public ceres::SizedCostFunction<3, 3> {
 public:
  PointPrior(const Eigen::Vector3d& stated, const TargetPrior& prior)
      : stated_(stated),
        weights_(1 / prior.inPlaneMm, 1 / prior.inPlaneMm, prior.outOfPlaneMm > 0 ? 1 / prior.outOfPlaneMm : 0) {}
  bool Evaluate(const double* const* parameters, double* residual, double** jacobians) const override {
    for (int i = 0; i < 3; ++i) residual[i] = (parameters[0][i] - stated_[i]) * weights_[i];
    if (jacobians == nullptr || jacobians[0] == nullptr) return true;
    Eigen::Map<Eigen::Matrix3d> derivatives(jacobians[0]);
    derivatives = weights_.asDiagonal();
    return true;
  }

 private:
  Eigen::Vector3d stated_, weights_;
};

std::vector<int> fixedIntrinsics(const LensVariant& variant) {
  std::vector<int> fixed;
  const auto free = freeParameters(variant);
  for (int i = 0; i < kIntrinsicParameters; ++i)
    if (std::find(free.begin(), free.end(), static_cast<CameraParameter>(i)) == free.end()) fixed.push_back(i);
  return fixed;
}

/// The unknowns, in memory that does not move while Ceres holds pointers to it.
class Adjustment {
 public:
  Adjustment(const TargetObservations& observations, const LensVariant& variant, const TargetFit& start,
             const AdjustmentSettings& settings)
      : start_(start), settings_(settings), intrinsics_(toVector(start.intrinsics)), points_(start.points) {
    changes_.assign(start.cameraFromTarget.size(), Vector6::Zero());
    addViews(observations);
    if (settings.posesOnly)
      problem_.SetParameterBlockConstant(intrinsics_.data());
    else
      problem_.SetManifold(intrinsics_.data(),
                           new ceres::SubsetManifold(kIntrinsicParameters, fixedIntrinsics(variant)));
    holdPoints(observations);
  }

  TargetFit solve() {
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_SCHUR;
    options.linear_solver_ordering = eliminationOrder();
    options.max_num_iterations = settings_.maxIterations;
    options.function_tolerance = 1e-10;  // a change of 1e-3 standard deviations, and less
    options.gradient_tolerance = 1e-12;
    options.parameter_tolerance = 1e-12;
    options.num_threads = 1;  // the same numbers whatever the machine
    options.logging_type = ceres::SILENT;
    silenceCeres();
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem_, &summary);

    TargetFit fit;
    fit.intrinsics = fromVector(intrinsics_, start_.intrinsics);
    for (std::size_t v = 0; v < changes_.size(); ++v)
      fit.cameraFromTarget.push_back(moved(start_.cameraFromTarget[v], changes_[v]));
    fit.points = std::move(points_);
    fit.converged = summary.IsSolutionUsable() && summary.termination_type == ceres::CONVERGENCE;
    return fit;
  }

 private:
  /// Points of the target first where they are unknowns, since there are many; otherwise the poses.
  std::shared_ptr<ceres::ParameterBlockOrdering> eliminationOrder() {
    auto order = std::make_shared<ceres::ParameterBlockOrdering>();
    const auto add = [&](double* block, int group) {
      if (problem_.HasParameterBlock(block)) order->AddElementToGroup(block, group);
    };
    const bool points = settings_.target.free() && !settings_.posesOnly;
    for (Eigen::Vector3d& point : points_) add(point.data(), points ? 0 : 1);
    for (Vector6& change : changes_) add(change.data(), points ? 1 : 0);
    add(intrinsics_.data(), 1);
    return order;
  }

  void addViews(const TargetObservations& observations) {
    ceres::LossFunction* loss = settings_.robust ? &cauchy_ : nullptr;
    for (std::size_t v = 0; v < observations.views.size(); ++v)
      for (const Observation& o : observations.views[v])
        problem_.AddResidualBlock(
            new PointResidual(o, start_.intrinsics, start_.cameraFromTarget[v], observations.radiusMm), loss,
            intrinsics_.data(), changes_[v].data(), points_[static_cast<std::size_t>(o.point)].data());
  }

  void holdPoints(const TargetObservations& observations) {
    const bool free = settings_.target.free() && !settings_.posesOnly;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      double* point = points_[i].data();
      if (!problem_.HasParameterBlock(point)) continue;
      if (!free) {
        problem_.SetParameterBlockConstant(point);
        continue;
      }
      if (!(settings_.target.outOfPlaneMm > 0)) problem_.SetManifold(point, new ceres::SubsetManifold(3, {2}));
      problem_.AddResidualBlock(new PointPrior(observations.points[i], settings_.target), nullptr, point);
    }
  }

  static ceres::Problem::Options keepingLoss() {
    ceres::Problem::Options options;
    options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    return options;
  }

  const TargetFit& start_;
  AdjustmentSettings settings_;
  IntrinsicVector intrinsics_;
  std::vector<Vector6> changes_;
  std::vector<Eigen::Vector3d> points_;
  ceres::CauchyLoss cauchy_{kCauchySigmas};
  ceres::Problem problem_{keepingLoss()};
};

bool everythingIsSeen(const TargetObservations& observations, const TargetFit& fit) {
  for (const auto& view : residuals(observations, fit))
    for (const Point2& r : view)
      if (!r.allFinite()) return false;
  return true;
}

}  // namespace

TargetFit adjust(const TargetObservations& observations, const LensVariant& variant, const TargetFit& start,
                 const AdjustmentSettings& settings) {
  if (!everythingIsSeen(observations, start)) {  // Ceres would complain on stderr
    TargetFit unchanged = start;
    unchanged.converged = false;
    return unchanged;
  }
  return Adjustment(observations, variant, start, settings).solve();
}

std::vector<std::vector<Point2>> residuals(const TargetObservations& observations, const TargetFit& fit) {
  std::vector<std::vector<Point2>> all(observations.views.size());
  for (std::size_t v = 0; v < observations.views.size(); ++v)
    for (const Observation& o : observations.views[v])
      all[v].push_back(reprojected(fit.intrinsics, fit.cameraFromTarget[v],
                                   fit.points[static_cast<std::size_t>(o.point)], observations.radiusMm) -
                       o.px);
  return all;
}

}  // namespace vignole
