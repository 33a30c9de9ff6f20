#include "engine/measurement/foot_bottom_fit.h"

#include <cmath>

namespace vignole {

double FootBottomFit::round(const FitPoints& points, const Weighting& weighting) {
  ParabolaSums sums;
  solution_.scatter = {};
  for (const FitPoints::Run& run : points.runs) {
    const ResidualSums before = sums.residuals;
    addParabola(points, run, c_, kScaleMm, weighting, sums);
    addTo(solution_.scatter, run.camera, sums.residuals.since(before));
  }
  const double kept = sums.residuals.count;
  if (kept < 4) return -1;
  solution_.meanSquareMm2 = sums.residuals.squares / kept;
  UnknownMatrix a{};
  UnknownVector b{};
  for (std::size_t i = 0; i < 3; ++i) {
    b[i] = sums.vector[i];
    for (std::size_t j = 0; j <= i; ++j) a[i][j] = sums.powers[i + j];
  }
  if (!solution_.normal.decompose(a, 3)) return -1;
  const UnknownVector step = solution_.normal.solve(b);
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    c_[i] += step[i];
    size += std::abs(step[i]);
  }
  return std::isfinite(size) ? size : -1;
}

void FootBottomFit::solve(const FitPoints& points, double correlatedPoints) {
  c_ = {};
  solution_ = {};
  solution_.unknowns = 3;
  const auto residual = [&](const FitPoints& p, std::size_t i) {
    const double u = static_cast<double>(p.x[i]) / kScaleMm;
    return static_cast<double>(p.y[i]) - (c_[0] + u * (c_[1] + u * c_[2]));
  };
  solution_.valid = rounds_.run(
      points, residual, [&](const FitPoints& p, const Weighting& weighting, bool) { return round(p, weighting); });
  if (!solution_.valid) return;
  SharedErrors errors(solution_.unknowns, correlatedPoints);
  for (const FitPoints::Run& run : points.runs)
    errors.addRun(run.from, run.to, [&](std::size_t i) -> UnknownVector {
      const double u = static_cast<double>(points.x[i]) / kScaleMm,
                   w = std::sqrt(static_cast<double>(points.weight[i]));
      return {w, w * u, w * u * u};
    });
  solution_.setShared(errors);
}

}  // namespace vignole
