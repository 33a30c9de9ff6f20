#pragma once
// Recipes and calibrations that rails were measured with, kept once each. Throw DatabaseFailure; for this room alone.

#include "engine/archive/rail_record.h"
#include "engine/database/database.h"

namespace vignole {

/// The key of this recipe, put in (as one that was measured with, not approved here) if it is not there yet.
[[nodiscard]] std::int64_t keepRecipe(Database& database, const Recipe& recipe, TimeUs now);
[[nodiscard]] std::int64_t keepCalibration(Database& database, const RigCalibration& calibration, TimeUs now,
                                           const std::string& user, const std::string& reason);

}  // namespace vignole
