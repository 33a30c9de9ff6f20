#pragma once
// The calibration of the four range finders as a report: what was seen (the paper's Fig. 8 b-d), Table IV, the
// parameters by name, what it is worth in mm for every dimension, and the proofs.

#include <array>
#include <string>
#include <vector>

#include "calibration/assessment/check.h"
#include "calibration/assessment/dimension_uncertainty.h"
#include "calibration/range_finders/rig_adjustment.h"
#include "engine/acquisition/picture_file.h"
#include "report/document.h"

namespace vignole {

struct RigCalibrationReport {
  const RigAdjustment* adjustment = nullptr;
  const RigInputs* inputs = nullptr;
  std::array<const Picture*, kCameraCount> pictures{};  ///< of the first placement; null: none
  std::string section;                                  ///< for which the uncertainties below hold
  std::vector<DimensionUncertainty> dimensions;
  std::vector<Check> checks;
  std::vector<std::string> refusals;  ///< the adjustment's and the checks'
  bool simulation = false;
};

/// Fig. 8d: the pins as found and the points of the first placement, in the world.
[[nodiscard]] Plot pinsInWorld(const RigAdjustment& adjustment);
[[nodiscard]] Document rigCalibrationDocument(const RigCalibrationReport& report);

}  // namespace vignole
