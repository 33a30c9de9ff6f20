#pragma once
// What `vignole-cli calibrate exposure` tells: a table for people, JSON for programs.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "calibration/parameter_study/exposure_adviser.h"

namespace vignole::cli {

[[nodiscard]] nlohmann::ordered_json toJson(const ExposureAdvice& advice);
[[nodiscard]] std::string toTable(const ExposureAdvice& advice);

}  // namespace vignole::cli
