#include "calibration/range_finders/line_noise.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace vignole {

namespace {

constexpr double kLeast = 0.2, kMost = 20;  // of the noise expected by the picture: beyond, something else is wrong

struct Scatter {
  double square = 0;    // of residuals in their standard uncertainties
  double expected = 0;  // for a noise of 1
};

/// Residuals about the arc's own circle. Nothing where it is too short to have scatter left.
Scatter aboutOwnCircle(const ArcObservation& arc) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < arc.inside.size(); ++i)
    if (arc.inside[i] != 0 && arc.weight[i] > 0.99) indices.push_back(i);
  const auto count = static_cast<Eigen::Index>(indices.size());
  if (count < 8) return {};
  Eigen::MatrixXd design(count, 3), correlation(count, count);
  Eigen::VectorXd residuals(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const std::size_t a = indices[static_cast<std::size_t>(i)];
    const double perSigma = 1 / arc.sigmaPx[a];
    residuals[i] = arc.residualPx[a] * perSigma;
    design.row(i) = Eigen::RowVector3d(1, std::cos(arc.angleRad[a]), std::sin(arc.angleRad[a])) * perSigma /
                    arc.mmPerPx[a];
    for (Eigen::Index k = 0; k <= i; ++k) {
      const double d = arc.arcPx[a] - arc.arcPx[indices[static_cast<std::size_t>(k)]];
      correlation(i, k) = correlation(k, i) = std::exp(-d * d / (4 * arc.correlationPx2));
    }
  }
  const Eigen::Matrix3d inverse = (design.transpose() * design).inverse();
  const Eigen::VectorXd left = residuals - design * (inverse * (design.transpose() * residuals));
  const double expected = static_cast<double>(count) - (inverse * (design.transpose() * correlation * design)).trace();
  if (!(expected > 0.05 * static_cast<double>(count))) return {};
  return {left.squaredNorm(), expected};
}

Scatter allResiduals(const ArcObservation& arc) {
  Scatter scatter;
  for (std::size_t i = 0; i < arc.inside.size(); ++i) {
    if (arc.inside[i] == 0) continue;
    scatter.square += arc.weight[i] * std::pow(arc.residualPx[i] / arc.sigmaPx[i], 2);
    scatter.expected += arc.weight[i];
  }
  return scatter;
}

}  // namespace

void refineNoise(ArcAdjustment& adjustment, std::span<const int> cameras, const ArcFreedom& freedom,
                 const PinPlate& plate, const std::vector<ArcObservation>& arcs) {
  const bool all = freedom.pins && adjustment.normals.information[static_cast<std::size_t>(cameras.front())].size() > 0;
  Influence answers;
  if (all) answers = influence(adjustment, plate, cameras, freedom);
  for (const int camera : cameras) {
    Scatter sum;
    double shared = 1;
    for (const ArcObservation& arc : arcs) {
      if (arc.camera != camera || !arc.used()) continue;
      const Scatter own = all ? allResiduals(arc) : aboutOwnCircle(arc);
      sum.square += own.square;
      sum.expected += own.expected;
      shared = arc.correlatedPoints;
    }
    if (all) sum.expected -= shared * answers.parameters[static_cast<std::size_t>(camera)];
    if (!(sum.expected > 10)) continue;
    adjustment.lights[static_cast<std::size_t>(camera)].noise =
        std::clamp(std::sqrt(sum.square / sum.expected), kLeast, kMost);
  }
}

}  // namespace vignole
