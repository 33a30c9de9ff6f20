#include "gui/calibration_records/dimension_worth.h"

#include <algorithm>
#include <cmath>

#include "engine/measurement/measurement.h"

namespace vignole {

namespace {
constexpr double kQms = 0.15, kCoverage = 2;
}

std::optional<double> allowedUMm(const ToleranceLimits& limits) {
  if (!limits.lowerMm && !limits.upperMm) return {};
  const double width = limits.lowerMm && limits.upperMm ? *limits.upperMm - *limits.lowerMm
                                                        : std::abs(limits.upperMm ? *limits.upperMm : *limits.lowerMm);
  return kQms * width / 2;
}

std::vector<DimensionWorth> dimensionWorth(const Recipe& recipe, const RigCalibration& inForce,
                                           const std::vector<DimensionUncertainty>* fresh) {
  std::vector<DimensionWorth> all;
  const auto nominal = nominalDimensions(recipe.section, recipe.parameters);
  if (!nominal) return all;
  std::optional<PerDimension<double>> stated;
  if (inForce.covariance.size() > 0)
    if (const auto u = calibrationUncertainty(recipe.section, recipe.parameters, inForce)) stated = *u;
  for (const Dimension d : kDimensions) {
    if (!(*nominal)[index(d)]) continue;
    DimensionWorth worth;
    worth.dimension = d;
    worth.allowedMm = allowedUMm(recipe.limits[index(d)]);
    if (stated) worth.inForceMm = kCoverage * (*stated)[index(d)];
    if (fresh != nullptr) {
      const auto of = std::find_if(fresh->begin(), fresh->end(), [d](const auto& u) { return u.dimension == d; });
      if (of != fresh->end()) {
        worth.newMm = kCoverage * of->uMm;
        if (!of->contributions.empty()) worth.largest = of->contributions.front().source;
      }
    }
    all.push_back(std::move(worth));
  }
  return all;
}

}  // namespace vignole
