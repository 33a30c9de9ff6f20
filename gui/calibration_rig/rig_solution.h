#pragma once
// From the placements of the plate to a calibration, and what it is worth beside the one in force.

#include <memory>

#include "calibration/assessment/rig_checks.h"
#include "gui/calibration_records/dimension_worth.h"
#include "report/rig_calibration_report.h"

namespace vignole {

struct RigSolution {
  std::shared_ptr<const RigInputs> inputs;
  RigAdjustment adjustment;
  std::vector<DimensionUncertainty> dimensions;  ///< empty: refused before
  RigChecks checks;
  std::vector<std::string> refusals;  ///< each with its remedy; empty: may be put in force
  std::vector<DimensionWorth> worth;
  [[nodiscard]] bool mayBeUsed() const { return refusals.empty(); }
};

struct RigSolveSettings {
  RigCalibration inForce;
  Recipe recipe;  ///< whose section's dimensions are judged
  int intervalDays = 0;
};

/// `inputs` as the placements were found, associated. Error: cancelled, or what the library refuses as input.
[[nodiscard]] Expected<RigSolution> solveRig(RigInputs inputs, const RigSolveSettings& settings, const Job& job);

/// `pictures`: of the first placement.
[[nodiscard]] Document documentOf(const RigSolution& solution, const std::array<Picture, kCameraCount>& pictures,
                                  const std::string& section, bool simulation);

}  // namespace vignole
