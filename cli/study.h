#pragma once
// What the studies of `vignole-cli study` share: options, outcome, reading of columns.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/console.h"
#include "cli/study_plot.h"
#include "engine/files/csv_table.h"
#include "engine/quality/conformity.h"
#include "engine/quality/sample.h"

namespace CLI {
class App;
}

namespace vignole::cli {

using Json = nlohmann::ordered_json;

/// Options of all studies; each adds those that it understands.
struct StudyOptions {
  std::vector<std::string> files;
  std::string method, rules, constants = "table", limits = "asymptotic", model, measurand = "l";
  double alpha = 0.05;
  std::optional<double> k, h, sigmas, reference, sigma, variation, processMean, processSd;
  double lambda = 0.3, sectionM = 10, windowM = 0.5;
  std::size_t trials = 1000000;
  std::uint64_t seed = 1;
  bool evenIfUnstable = false, quiet = false;
  std::vector<std::string> dimensions;
  ToleranceZone tolerance;
  std::string json, plot;
};

/// What a study came to; `refused` makes exit code 1 and says why.
struct StudyOutcome {
  Json options = Json::object(), results = Json::object();
  StudyNotes notes;
  std::vector<Chart> charts;
  std::string refused;
};

Expected<StudyOutcome> studyRepeatability(const StudyOptions& options);
Expected<StudyOutcome> studyAccuracy(const StudyOptions& options);
Expected<StudyOutcome> studyPrecision(const StudyOptions& options);
Expected<StudyOutcome> studyType1(const StudyOptions& options);
Expected<StudyOutcome> studyLinearity(const StudyOptions& options);
Expected<StudyOutcome> studyGrr(const StudyOptions& options);
Expected<StudyOutcome> studyAgreement(const StudyOptions& options);
Expected<StudyOutcome> studyControlChart(const StudyOptions& options);
Expected<StudyOutcome> studyCapability(const StudyOptions& options);
Expected<StudyOutcome> studyUncertainty(const StudyOptions& options);
Expected<StudyOutcome> studyConformity(const StudyOptions& options);

/// null where there is no finite number.
[[nodiscard]] Json numberOrNull(double value);
[[nodiscard]] Json numberOrNull(const std::optional<double>& value);
/// [low, high].
[[nodiscard]] Json rangeJson(const ValueRange& range);
/// LO,HI with T = HI - LO where both are there.
[[nodiscard]] std::optional<double> toleranceWidth(const ToleranceZone& tolerance);
[[nodiscard]] Json toleranceJson(const ToleranceZone& tolerance);
/// "20", "0.5": a number as people write it.
[[nodiscard]] std::string shortNumber(double value);
/// An error of the statistics' own, with the file in front.
[[nodiscard]] tl::unexpected<Error> inFile(const std::string& file, const Error& error);

}  // namespace vignole::cli
