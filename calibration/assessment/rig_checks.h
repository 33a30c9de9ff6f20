#pragma once
// All checks that the adjustment of a rig must stand before it is used.

#include <optional>

#include "calibration/assessment/comparison.h"
#include "calibration/assessment/fold_checks.h"
#include "calibration/assessment/residual_checks.h"
#include "calibration/assessment/seam_check.h"

namespace vignole {

struct RigCheckSettings {
  int pinFolds = 4;        ///< 0: none
  bool placements = true;  ///< leave each placement out once
  bool reversal = true;    ///< solve both ways round by themselves
  std::optional<RigCalibration> previous;
};

struct RigChecks {
  std::vector<Check> checks;
  std::array<ResidualStatistics, kCameraCount> residuals;
  std::vector<Fold> pinFolds, placementFolds;
  Reversal reversal;
  std::vector<PairSeam> seams;
  std::optional<Comparison> comparison;
};
/// `inputs` and `settings` as the adjustment had them. An adjustment that was refused is not checked further: no
/// checks. Error: cancelled.
[[nodiscard]] Expected<RigChecks> checkRig(const RigInputs& inputs, const RigAdjustmentSettings& settings,
                                           const RigAdjustment& adjustment, const Section& section,
                                           const DimensionParameters& parameters, const RigCheckSettings& what,
                                           const Job& job);

}  // namespace vignole
