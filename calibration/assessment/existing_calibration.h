#pragma once
// A calibration that is in use, judged on placements of its plate that it has not seen: is it still right?

#include <array>
#include <chrono>
#include <optional>
#include <vector>

#include "calibration/assessment/comparison.h"
#include "calibration/assessment/dimension_uncertainty.h"
#include "calibration/assessment/fold_checks.h"
#include "calibration/assessment/seam_check.h"
#include "engine/optics/calibration_age.h"

namespace vignole {

/// What new placements are adjusted with to be judged by: the calibration's intrinsics with their uncertainty, and its
/// pins as the plate, or a plate that is given. Error: neither.
[[nodiscard]] Expected<RigInputs> inputsFor(const RigCalibration& calibration,
                                            const std::optional<PinPlate>& plate = {});

struct ExistingCalibration {
  std::array<SpreadMm, kCameraCount> cd, rd, pd;  ///< Table IV by the calibration as it is, over the new placements
  std::vector<Fold> placements;                   ///< each laid onto the pins, 3 degrees of freedom
  std::vector<PairSeam> seams;
  Comparison withNew;  ///< it beside a calibration by the new placements alone
  std::vector<DimensionUncertainty> dimensions;
  CalibrationAge age;
  std::vector<Check> checks;
};

/// `adjustment`: of the new placements (inputs as adjustRig had them). It must not have been refused.
[[nodiscard]] Expected<ExistingCalibration> judgeExisting(const RigCalibration& calibration, const RigInputs& inputs,
                                                          const RigAdjustment& adjustment, const Section& section,
                                                          const DimensionParameters& parameters,
                                                          std::chrono::sys_seconds now);

/// The rig's covariance taken apart by camera: a part is what a camera's own uncertainty and its share of what all have
/// in common leave. "camera 3" ...
[[nodiscard]] std::vector<DimensionUncertainty> dimensionUncertaintyByCamera(const DimensionJacobian& jacobian,
                                                                             const RigCalibration& rig);

}  // namespace vignole
