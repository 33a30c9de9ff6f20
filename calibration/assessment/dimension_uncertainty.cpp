#include "calibration/assessment/dimension_uncertainty.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/quality/running_statistics.h"

namespace vignole {

std::vector<DimensionUncertainty> dimensionUncertainty(const DimensionJacobian& jacobian,
                                                       std::span<const ErrorSource> sources) {
  std::vector<DimensionUncertainty> all;
  for (const Dimension d : kDimensions) {
    const auto row = jacobian.row(static_cast<int>(index(d)));
    if (!row.allFinite()) continue;
    DimensionUncertainty one{d, 0, {}};
    double variance = 0;
    for (const ErrorSource& source : sources) {
      const double part = source.effects.cols() == 0 ? 0 : (row * source.effects).squaredNorm();
      variance += part;
      one.contributions.push_back({source.name, std::sqrt(part)});
    }
    one.uMm = std::sqrt(variance);
    std::stable_sort(one.contributions.begin(), one.contributions.end(),
                     [](const Contribution& a, const Contribution& b) { return a.uMm > b.uMm; });
    all.push_back(std::move(one));
  }
  return all;
}

namespace {

RigChange drawnChange(std::span<const ErrorSource> sources, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  RigChange change = RigChange::Zero();
  for (const ErrorSource& source : sources)
    for (Eigen::Index k = 0; k < source.effects.cols(); ++k) change += normal(random) * source.effects.col(k);
  return change;
}

}  // namespace

Expected<std::vector<MonteCarloDimension>> monteCarlo(const Section& section, const DimensionParameters& parameters,
                                                      const RigCalibration& rig, std::span<const ErrorSource> sources,
                                                      int draws, std::uint64_t seed, const Job& job) {
  const auto jacobian = dimensionJacobian(section, parameters, rig);
  if (!jacobian) return tl::unexpected(jacobian.error());
  auto before = SectionBeforeRig::create(section, parameters, rig);
  if (!before) return tl::unexpected(before.error());
  std::mt19937_64 random(seed);
  PerDimension<RunningStatistics> errors;
  for (int k = 0; k < draws; ++k) {
    if (job.cancelled()) return cancelledError();
    if (k % 100 == 0) job.report(static_cast<double>(k) / draws, "drawing errors of the calibration");
    RigCalibration drawn = rig;
    apply(drawnChange(sources, random), drawn);
    const auto measured = before->measuredBy(drawn);
    if (!measured) return tl::unexpected(measured.error());
    for (std::size_t d = 0; d < kDimensionCount; ++d)
      if (before->nominal()[d] && std::isfinite(measured->mm[d]))
        errors[d].add(measured->mm[d] - *before->nominal()[d]);
  }
  std::vector<MonteCarloDimension> all;
  for (const DimensionUncertainty& propagated : dimensionUncertainty(*jacobian, sources)) {
    const RunningStatistics& e = errors[index(propagated.dimension)];
    if (e.count() < 2) continue;
    const double sd = propagated.dimension == Dimension::HF ? std::hypot(e.sd(), e.mean()) : e.sd();
    all.push_back(
        {propagated.dimension, propagated.uMm, sd, e.mean(), 1 / std::sqrt(2.0 * static_cast<double>(e.count() - 1))});
  }
  return all;
}

}  // namespace vignole
