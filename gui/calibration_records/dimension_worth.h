#pragma once
// What calibrations are worth for each dimension, beside what the tolerances leave room for.

#include <optional>
#include <string>
#include <vector>

#include "calibration/assessment/dimension_uncertainty.h"
#include "engine/recipe/recipe.h"

namespace vignole {

struct DimensionWorth {
  Dimension dimension = Dimension::RH;
  std::optional<double> inForceMm;  ///< U, k = 2, by the calibration alone; empty: that calibration states none
  std::optional<double> newMm;      ///< empty: there is none yet
  std::optional<double> allowedMm;  ///< empty: no limits
  std::string largest;              ///< contribution to the new one

  [[nodiscard]] bool tooLarge() const { return newMm && allowedMm && *newMm > *allowedMm; }
};

/// U that makes 15 % of the tolerance, Q_MS of VDA 5: 2 U / T; T with one limit: from nominal to the limit.
[[nodiscard]] std::optional<double> allowedUMm(const ToleranceLimits& limits);

/// Of every dimension that the section has. `fresh`: of the new one; null: none yet. Slow: not in the window's thread.
[[nodiscard]] std::vector<DimensionWorth> dimensionWorth(const Recipe& recipe, const RigCalibration& inForce,
                                                         const std::vector<DimensionUncertainty>* fresh);

}  // namespace vignole
