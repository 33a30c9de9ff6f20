#pragma once
// The results of a study for people: every figure, then formulas, options and constants.

#include <string>

#include "cli/study.h"

namespace vignole::cli {

[[nodiscard]] std::string studyText(const std::string& study, const StudyOutcome& outcome);

}  // namespace vignole::cli
