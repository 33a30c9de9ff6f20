#include "calibration/intrinsics/target_adjustment.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <ceres/evaluation_callback.h>
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

/// The unknowns, in memory that does not move while Ceres holds pointers to it, and what all points of a view share,
/// worked out once for each place that Ceres tries.
class Unknowns : public ceres::EvaluationCallback {
 public:
  explicit Unknowns(const TargetFit& from)
      : start(from),
        intrinsics(toVector(from.intrinsics)),
        changes(from.cameraFromTarget.size(), Vector6::Zero()),
        points(from.points),
        camera(from.intrinsics),
        poses(from.cameraFromTarget),
        turnsByChange(changes.size(), Eigen::Matrix3d::Identity()) {}

  void PrepareForEvaluation(bool withDerivatives, bool newPlace) override {
    if (newPlace) {
      camera = fromVector(intrinsics, start.intrinsics);
      for (std::size_t v = 0; v < changes.size(); ++v) poses[v] = moved(start.cameraFromTarget[v], changes[v]);
    }
    if (withDerivatives)
      for (std::size_t v = 0; v < changes.size(); ++v) turnsByChange[v] = turnByVector(changes[v].head<3>());
  }

  const TargetFit& start;
  IntrinsicVector intrinsics;
  std::vector<Vector6> changes;  ///< of the poses
  std::vector<Eigen::Vector3d> points;

  Intrinsics camera;
  std::vector<Extrinsics> poses;
  std::vector<Eigen::Matrix3d> turnsByChange;
};

/// One observed point: unknowns are the intrinsics, the change of the view's pose, the point.
class PointResidual : public ceres::SizedCostFunction<2, kIntrinsicParameters, 6, 3> {
 public:
  PointResidual(const Observation& observation, const Unknowns& unknowns, std::size_t view, double radiusMm)
      : observation_(observation), unknowns_(unknowns), view_(view), radiusMm_(radiusMm) {}

  bool Evaluate(const double* const* parameters, double* residual, double** jacobians) const override {
    const Eigen::Vector3d point = Eigen::Map<const Eigen::Vector3d>(parameters[2]);
    const Extrinsics& pose = unknowns_.poses[view_];
    const double weight = 1 / observation_.sigmaPx;
    Eigen::Map<Eigen::Vector2d> error(residual);
    if (jacobians == nullptr) {
      error = weight * (reprojected(unknowns_.camera, pose, point, radiusMm_) - observation_.px);
      return error.allFinite();
    }
    Reprojection r;
    if (!reproject(unknowns_.camera, pose, point, radiusMm_, r)) return false;
    error = weight * (r.px - observation_.px);
    if (jacobians[0] != nullptr) put<kIntrinsicParameters>(weight * r.byIntrinsics, jacobians[0]);
    if (jacobians[1] != nullptr) {
      r.byPose.leftCols<3>() *= unknowns_.turnsByChange[view_];
      put<6>(weight * r.byPose, jacobians[1]);
    }
    if (jacobians[2] != nullptr) put<3>(weight * r.byPoint, jacobians[2]);
    return true;
  }

 private:
  Observation observation_;
  const Unknowns& unknowns_;
  std::size_t view_;
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

class Adjustment {
 public:
  Adjustment(const TargetObservations& observations, const LensVariant& variant, const TargetFit& start,
             const AdjustmentSettings& settings)
      : settings_(settings), unknowns_(start), problem_(optionsWith(unknowns_)) {
    addViews(observations);
    if (settings.posesOnly)
      problem_.SetParameterBlockConstant(unknowns_.intrinsics.data());
    else
      problem_.SetManifold(unknowns_.intrinsics.data(),
                           new ceres::SubsetManifold(kIntrinsicParameters, fixedIntrinsics(variant)));
    holdPoints(observations);
  }

  TargetFit solve() {
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_SCHUR;
    options.linear_solver_ordering = eliminationOrder();
    options.max_num_iterations = settings_.maxIterations;
    options.function_tolerance = settings_.tolerance;
    options.gradient_tolerance = 1e-12;
    options.parameter_tolerance = 1e-12;
    options.num_threads = 1;  // the same numbers whatever the machine
    options.logging_type = ceres::SILENT;
    silenceCeres();
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem_, &summary);

    TargetFit fit;
    fit.intrinsics = fromVector(unknowns_.intrinsics, unknowns_.start.intrinsics);
    for (std::size_t v = 0; v < unknowns_.changes.size(); ++v)
      fit.cameraFromTarget.push_back(moved(unknowns_.start.cameraFromTarget[v], unknowns_.changes[v]));
    fit.points = std::move(unknowns_.points);
    fit.converged = summary.IsSolutionUsable() && summary.termination_type == ceres::CONVERGENCE;
    return fit;
  }

 private:
  [[nodiscard]] bool pointsAreFree() const { return settings_.target.free() && !settings_.posesOnly; }

  /// Points of the target first where they are unknowns, since there are many; otherwise the poses.
  std::shared_ptr<ceres::ParameterBlockOrdering> eliminationOrder() {
    auto order = std::make_shared<ceres::ParameterBlockOrdering>();
    const auto add = [&](double* block, int group) {
      if (problem_.HasParameterBlock(block)) order->AddElementToGroup(block, group);
    };
    for (Eigen::Vector3d& point : unknowns_.points) add(point.data(), pointsAreFree() ? 0 : 1);
    for (Vector6& change : unknowns_.changes) add(change.data(), pointsAreFree() ? 1 : 0);
    add(unknowns_.intrinsics.data(), 1);
    return order;
  }

  void addViews(const TargetObservations& observations) {
    ceres::LossFunction* loss = settings_.robust ? &cauchy_ : nullptr;
    for (std::size_t v = 0; v < observations.views.size(); ++v)
      for (const Observation& o : observations.views[v])
        problem_.AddResidualBlock(new PointResidual(o, unknowns_, v, observations.radiusMm), loss,
                                  unknowns_.intrinsics.data(), unknowns_.changes[v].data(),
                                  unknowns_.points[static_cast<std::size_t>(o.point)].data());
  }

  void holdPoints(const TargetObservations& observations) {
    for (std::size_t i = 0; i < unknowns_.points.size(); ++i) {
      double* point = unknowns_.points[i].data();
      if (!problem_.HasParameterBlock(point)) continue;
      if (!pointsAreFree()) {
        problem_.SetParameterBlockConstant(point);
        continue;
      }
      if (!(settings_.target.outOfPlaneMm > 0)) problem_.SetManifold(point, new ceres::SubsetManifold(3, {2}));
      problem_.AddResidualBlock(new PointPrior(observations.points[i], settings_.target), nullptr, point);
    }
  }

  static ceres::Problem::Options optionsWith(Unknowns& unknowns) {
    ceres::Problem::Options options;
    options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    options.evaluation_callback = &unknowns;
    return options;
  }

  AdjustmentSettings settings_;
  Unknowns unknowns_;
  ceres::CauchyLoss cauchy_{kCauchySigmas};
  ceres::Problem problem_;
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
