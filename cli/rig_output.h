#pragma once
// The calibration of a rig, and what it is worth, as JSON and as text.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "calibration/assessment/dimension_uncertainty.h"
#include "calibration/assessment/rig_checks.h"
#include "calibration/range_finders/rig_adjustment.h"

namespace vignole::cli {

/// What is told of one calibration of a rig.
struct RigResult {
  const RigInputs* inputs = nullptr;
  RigAdjustment adjustment;
  std::string section;
  std::vector<DimensionUncertainty> dimensions;  ///< empty: refused before
  RigChecks checks;
  std::vector<std::string> refusals;  ///< the adjustment's and the checks'
};

[[nodiscard]] nlohmann::ordered_json toJson(const RigResult& result);
[[nodiscard]] std::string toTable(const RigResult& result);
/// For assess and rig alike.
[[nodiscard]] nlohmann::ordered_json toJson(const Check& check);
[[nodiscard]] nlohmann::ordered_json toJson(const std::vector<DimensionUncertainty>& dimensions);

}  // namespace vignole::cli
