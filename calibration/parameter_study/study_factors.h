#pragma once
// The settings of a rig's calibration that a study can vary, and the file that says which (resources/studies).

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "calibration/parameter_study/factorial_design.h"
#include "calibration/parameter_study/parameter_study.h"
#include "calibration/range_finders/association.h"
#include "calibration/range_finders/rig_adjustment.h"

namespace vignole {

/// The settings of one calibration.
struct TrialSettings {
  std::optional<double> exposureMs;  ///< placements taken at it; none: those that tell no other
  PinLineSettings lines;
  AssociationSettings association;
  RigAdjustmentSettings adjustment;
};

/// One line each for people: name, levels, what it is.
[[nodiscard]] std::vector<std::string> studyFactorWords();

/// Sets what the factor stands for. Refuses a name that is none, with the list of names, and a level out of range.
[[nodiscard]] Expected<void> applyFactor(TrialSettings& settings, std::string_view factor, const FactorLevel& level);
/// Factors that do nothing under these settings: those of the paper's method under another one and the reverse.
[[nodiscard]] bool isInert(std::string_view factor, const TrialSettings& settings);

struct StudyPlan {
  std::vector<Factor> factors;
  std::vector<std::pair<std::string, FactorLevel>> fixed;  ///< what is not varied but differs from the defaults
  DesignSettings design;
  StudySettings analysis;
};

/// TOML, format = 1: [[factor]] with name and levels; [fixed] NAME = LEVEL; [design] max_runs, runs;
/// [analysis] response, interactions. Factors of the paper's method fix that method if the file says nothing of it.
/// Refuses unknown keys and names, levels out of range, too many runs.
[[nodiscard]] Expected<StudyPlan> parseStudyPlan(std::string_view text, const std::string& nameInErrors);
[[nodiscard]] Expected<StudyPlan> loadStudyPlan(const std::filesystem::path& file);

/// `fixed`, then the levels of a combination.
[[nodiscard]] Expected<TrialSettings> trialSettings(const StudyPlan& plan, const Combination& combination);

}  // namespace vignole
