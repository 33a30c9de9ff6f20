#pragma once
// What `vignole-cli calibrate study` tells: a table for people, JSON for programs.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "calibration/parameter_study/study_factors.h"

namespace vignole::cli {

[[nodiscard]] nlohmann::ordered_json toJson(const ParameterStudy& study, const StudyPlan& plan);
[[nodiscard]] std::string toTable(const ParameterStudy& study);

}  // namespace vignole::cli
