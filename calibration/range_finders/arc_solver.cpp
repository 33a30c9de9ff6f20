#include "calibration/range_finders/arc_solver.h"

#include <ceres/cost_function.h>
#include <ceres/iteration_callback.h>
#include <ceres/problem.h>
#include <ceres/sized_cost_function.h>
#include <ceres/solver.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace vignole {

namespace {

constexpr double kExactMm = 1e-4;  // a pin stated without uncertainty

/// Points of the arc that count.
std::vector<std::size_t> counted(const ArcObservation& arc) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < arc.inside.size(); ++i)
    if (arc.inside[i] != 0 && arc.weight[i] > 0) indices.push_back(i);
  return indices;
}

std::vector<ArcCostPoint> costPoints(const ArcObservation& arc, const CameraLight& light,
                                     const std::vector<std::size_t>& indices) {
  std::vector<ArcCostPoint> points;
  points.reserve(indices.size());
  for (const std::size_t i : indices) {
    const double sigmaMm = light.noise * arc.sigmaPx[i] * arc.mmPerPx[i];
    points.push_back({arc.line->points[i].px, arc.pullMm[i],
                      std::sqrt(arc.weight[i] / arc.correlatedPoints(light)) / sigmaMm});
  }
  return points;
}

/// Unknowns near what is known of them: (x - known) / u.
template <int kCount>
class Prior : public ceres::SizedCostFunction<kCount, kCount> {
 public:
  Prior(std::array<double, kCount> known, std::array<double, kCount> u) : known_(known), u_(u) {}
  bool Evaluate(double const* const* unknowns, double* residuals, double** jacobians) const override {
    for (std::size_t i = 0; i < kCount; ++i) residuals[i] = (unknowns[0][i] - known_[i]) / u_[i];
    if (jacobians != nullptr && jacobians[0] != nullptr)
      for (std::size_t i = 0; i < kCount * kCount; ++i)
        jacobians[0][i] = i % (kCount + 1) == 0 ? 1 / u_[i / (kCount + 1)] : 0;
    return true;
  }

 private:
  std::array<double, kCount> known_, u_;
};

class Watch : public ceres::IterationCallback {
 public:
  explicit Watch(const Job& job) : job_(job) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    return job_.cancelled() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
  }

 private:
  const Job& job_;
};

}  // namespace

bool solveArcs(const std::vector<ArcObservation>& arcs, const std::array<CameraLight, kCameraCount>& lights,
               const std::array<CameraBase, kCameraCount>& base, const PinPlate& plate, const ArcFreedom& freedom,
               int referencePlacement, int maxSteps, ArcUnknowns& unknowns, const Job& job) {
  ceres::Problem problem;
  std::array<bool, kCameraCount> cameras{};
  std::vector<bool> pins(unknowns.pins.size()), placements(unknowns.placements.size());
  for (const ArcObservation& arc : arcs) {
    if (!arc.used()) continue;
    const auto camera = static_cast<std::size_t>(arc.camera), pin = static_cast<std::size_t>(arc.pin),
               placement = static_cast<std::size_t>(arc.placement);
    const std::vector<std::size_t> indices = counted(arc);
    if (indices.empty()) continue;
    problem.AddResidualBlock(arcCost(base[camera], costPoints(arc, lights[camera], indices)).release(), nullptr,
                             unknowns.intrinsics[camera].data(), unknowns.pose[camera].data(),
                             unknowns.pins[pin].data(), unknowns.placements[placement].data());
    cameras[camera] = pins[pin] = placements[placement] = true;
  }
  for (std::size_t c = 0; c < kCameraCount; ++c) {
    if (!cameras[c]) continue;
    double* block = unknowns.intrinsics[c].data();
    if (!freedom.intrinsics) {
      problem.SetParameterBlockConstant(block);
      continue;
    }
    std::array<double, kIntrinsicsUnknowns> ones{};
    ones.fill(1);
    problem.AddResidualBlock(new Prior<kIntrinsicsUnknowns>({}, ones), nullptr, block);
  }
  for (std::size_t p = 0; p < pins.size(); ++p) {
    if (!pins[p]) continue;
    double* block = unknowns.pins[p].data();
    if (!freedom.pins) {
      problem.SetParameterBlockConstant(block);
      continue;
    }
    const Pin& pin = plate.pins[p];
    const double u = std::max(pin.uCentreMm, kExactMm), uRadius = std::max(pin.uRadiusMm, kExactMm);
    problem.AddResidualBlock(
        new Prior<kPinUnknowns>({pin.centreMm.x(), pin.centreMm.y(), pin.radiusMm}, {u, u, uRadius}), nullptr, block);
  }
  if (placements[static_cast<std::size_t>(referencePlacement)])
    problem.SetParameterBlockConstant(unknowns.placements[static_cast<std::size_t>(referencePlacement)].data());

  Watch watch(job);
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  options.max_num_iterations = maxSteps;
  options.function_tolerance = 1e-10;
  options.parameter_tolerance = 1e-11;
  options.gradient_tolerance = 1e-12;
  options.logging_type = ceres::SILENT;
  options.callbacks.push_back(&watch);
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return summary.termination_type != ceres::USER_FAILURE;
}

ArcNormals normalsOf(const std::vector<ArcObservation>& arcs, const std::array<CameraLight, kCameraCount>& lights,
                     const std::array<CameraBase, kCameraCount>& base, const ArcUnknowns& unknowns) {
  const UnknownOrder order(unknowns.pins.size(), unknowns.placements.size());
  ArcNormals normals;
  for (std::size_t c = 0; c < kCameraCount; ++c)
    normals.information[c] = normals.noise[c] = Eigen::MatrixXd::Zero(order.size(), order.size());
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  for (const ArcObservation& arc : arcs) {
    if (!arc.used()) continue;
    const auto camera = static_cast<std::size_t>(arc.camera);
    const std::vector<std::size_t> indices = counted(arc);
    if (indices.empty()) continue;
    const auto cost = arcCost(base[camera], costPoints(arc, lights[camera], indices));
    const auto count = static_cast<Eigen::Index>(indices.size());
    const std::array<const double*, 4> blocks = {
        unknowns.intrinsics[camera].data(), unknowns.pose[camera].data(),
        unknowns.pins[static_cast<std::size_t>(arc.pin)].data(),
        unknowns.placements[static_cast<std::size_t>(arc.placement)].data()};
    constexpr std::array<int, 4> kSizes = {kIntrinsicsUnknowns, kPoseUnknowns, kPinUnknowns, kPlacementUnknowns};
    std::array<RowMajor, 4> parts;
    std::array<double*, 4> pointers{};
    for (std::size_t b = 0; b < 4; ++b) {
      parts[b].resize(count, kSizes[b]);
      pointers[b] = parts[b].data();
    }
    Eigen::VectorXd residuals(count);
    cost->Evaluate(blocks.data(), residuals.data(), pointers.data());
    Eigen::MatrixXd jacobian(count, kArcUnknowns);
    jacobian << parts[0], parts[1], parts[2], parts[3];

    // A residual's own standard deviation is that of its point: 1 / sqrt(neighbours that share its error), times the
    // square root of its robust weight.
    Eigen::MatrixXd correlated(count, count);
    const double reachPx2 = 4 * arc.correlationPx2(lights[camera]), shared = arc.correlatedPoints(lights[camera]);
    for (Eigen::Index i = 0; i < count; ++i)
      for (Eigen::Index k = 0; k <= i; ++k) {
        const auto a = indices[static_cast<std::size_t>(i)], b = indices[static_cast<std::size_t>(k)];
        const double d = arc.arcPx[a] - arc.arcPx[b];
        correlated(i, k) = correlated(k, i) = std::exp(-d * d / reachPx2) *
                                              std::sqrt(arc.weight[a] * arc.weight[b]) / shared;
      }
    const Eigen::MatrixXd information = jacobian.transpose() * jacobian;
    const Eigen::MatrixXd noise = jacobian.transpose() * correlated * jacobian;
    const std::array<Eigen::Index, 4> at = {order.intrinsics(arc.camera), order.pose(arc.camera), order.pin(arc.pin),
                                            order.placement(arc.placement)};
    Eigen::Index row = 0;
    for (std::size_t a = 0; a < 4; row += kSizes[a], ++a) {
      Eigen::Index column = 0;
      for (std::size_t b = 0; b < 4; column += kSizes[b], ++b) {
        normals.information[camera].block(at[a], at[b], kSizes[a], kSizes[b]) +=
            information.block(row, column, kSizes[a], kSizes[b]);
        normals.noise[camera].block(at[a], at[b], kSizes[a], kSizes[b]) +=
            noise.block(row, column, kSizes[a], kSizes[b]);
      }
    }
  }
  return normals;
}

}  // namespace vignole
