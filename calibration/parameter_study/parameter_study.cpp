#include "calibration/parameter_study/parameter_study.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "calibration/parameter_study/best_setting.h"

namespace vignole {
namespace {

struct ResponseWords {
  std::string_view name, longName;
  bool largerIsBetter, logarithmic;
};
constexpr std::array<ResponseWords, kResponseCount> kWords{
    {{"success", "Cameras calibrated", true, false},
     {"association", "Pins associated and used, of those of the plate", true, false},
     {"cd_mm", "CD: centre distance, mm", false, true},
     {"rd_mm", "RD: radius difference, mm", false, true},
     {"pd_mm", "PD: point distance, mm", false, true},
     {"pd_nominal_mm", "PD about the stated centres, mm", false, true},
     {"reprojection_px", "Reprojection, px", false, true},
     {"dimension_u_mm", "Uncertainty of dimensions, mm", false, true},
     {"time_s", "Time, s", false, true}}};
const ResponseWords& wordsOf(Response response) { return kWords[static_cast<std::size_t>(response)]; }

double valueOf(const StudyUnit& unit, Response response) { return unit.values[static_cast<std::size_t>(response)]; }

/// Blocks: cameras and placements; which of them a run observes does not depend on its settings.
std::vector<Observation> observationsOf(const std::vector<StudyRun>& runs, Response response, bool logarithmic) {
  std::map<std::pair<int, int>, int> blocks;
  for (const StudyRun& run : runs)
    for (const StudyUnit& unit : run.units) blocks.emplace(std::pair(unit.camera, unit.placement), 0);
  int next = 0;
  for (auto& [unit, index] : blocks) index = next++;
  std::vector<Observation> observations;
  for (const StudyRun& run : runs) {
    if (run.confirmation) continue;
    for (const StudyUnit& unit : run.units)
      if (const double value = valueOf(unit, response); std::isfinite(value))
        observations.push_back(
            {run.combination, blocks.at({unit.camera, unit.placement}), logarithmic ? std::log(value) : value});
  }
  return observations;
}

bool allPositive(const std::vector<StudyRun>& runs, Response response) {
  for (const StudyRun& run : runs)
    for (const StudyUnit& unit : run.units)
      if (valueOf(unit, response) <= 0) return false;
  return true;
}

ResponseStudy studyOf(Response response, const ParameterStudy& study, int order) {
  ResponseStudy result;
  result.response = response;
  result.logarithmic = isLogarithmic(response) && allPositive(study.runs, response);
  const std::vector<Observation> observations = observationsOf(study.runs, response, result.logarithmic);
  result.observations = static_cast<int>(observations.size());
  auto analysis = analyseVariance(study.design.factors, observations, order);
  if (!analysis) {
    result.whyNot = analysis.error().what;
    return result;
  }
  result.analysis = *std::move(analysis);
  result.best = bestSetting(study, result, observations);
  return result;
}

void count(ParameterStudy& study) {
  for (const StudyRun& run : study.runs) {
    if (run.confirmation) continue;
    study.runsRefused += run.refusal.empty() ? 0 : 1;
    for (const StudyUnit& unit : run.units) {
      if (!std::isfinite(valueOf(unit, Response::Success))) continue;
      ++study.unitsTried;
      if (unit.failure.empty()) continue;
      ++study.unitsFailed;
      ++study.failures[unit.failure];
    }
  }
}

void addRemarks(ParameterStudy& study) {
  if (!study.design.full())
    study.remarks.push_back("a fraction of " + std::to_string(study.design.runs.size()) + " of " +
                            std::to_string(study.design.fullRuns) + " runs, chosen D-optimal: each tells " +
                            std::to_string(std::lround(100 * study.design.efficiency)) +
                            " % of what a run of the full design would");
  if (study.unitsFailed > 0)
    study.remarks.push_back(std::to_string(study.unitsFailed) + " of " + std::to_string(study.unitsTried) +
                            " cameras in placements failed; they count in \"success\" and \"association\" and are "
                            "missing from the other responses");
  const auto repeated =
      std::count_if(study.runs.begin(), study.runs.end(), [](const StudyRun& r) { return r.sameAs >= 0; });
  if (repeated > 0)
    study.remarks.push_back(std::to_string(repeated) +
                            " runs differ from another in nothing that acts (factors of the method paper under another "
                            "method): they repeat its numbers, so p values are too small; study such factors with one "
                            "method");
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
  return result + "\"";
}

std::string numberOrNothing(double value) { return std::isfinite(value) ? words(FactorLevel(value)) : std::string(); }

}  // namespace

std::string_view name(Response response) { return wordsOf(response).name; }
std::string_view longName(Response response) { return wordsOf(response).longName; }
bool largerIsBetter(Response response) { return wordsOf(response).largerIsBetter; }
bool isLogarithmic(Response response) { return wordsOf(response).logarithmic; }

std::optional<Response> responseNamed(std::string_view wanted) {
  for (const Response response : kResponses)
    if (name(response) == wanted) return response;
  return {};
}

ResponseValues noResponses() {
  ResponseValues values;
  values.fill(std::numeric_limits<double>::quiet_NaN());
  return values;
}

ScaledMean ResponseStudy::scaled(double mean, double standardError) const {
  const auto back = [this](double v) { return logarithmic ? std::exp(v) : v; };
  return {back(mean), back(mean - standardError), back(mean + standardError)};
}

const ResponseStudy* ParameterStudy::of(Response response) const {
  for (const ResponseStudy& study : responses)
    if (study.response == response) return &study;
  return nullptr;
}

ParameterStudy analyseStudy(const FactorialDesign& design, std::vector<StudyRun> runs, const StudySettings& settings) {
  ParameterStudy study;
  study.design = design;
  study.runs = std::move(runs);
  study.primary = settings.primary;
  count(study);
  for (const Response response : kResponses) {
    ResponseStudy result = studyOf(response, study, settings.order);
    if (result.observations > 0) study.responses.push_back(std::move(result));
  }
  addRemarks(study);
  return study;
}

Expected<ParameterStudy> runParameterStudy(const FactorialDesign& design, const StudyTrial& trial,
                                           const StudySettings& settings, const Job& job) {
  std::vector<StudyRun> runs;
  const auto steps = static_cast<double>(design.runs.size() + (design.full() ? 0 : 1));
  const auto doOne = [&](const Combination& combination) -> Expected<void> {
    if (job.cancelled()) return cancelledError();
    const double done = static_cast<double>(runs.size()) / steps;
    const std::string what = "run " + std::to_string(runs.size() + 1) + ": " + words(design.factors, combination);
    job.report(done, what);
    const Job inner{[&](double share, std::string_view doing) {
                      job.report(done + share / steps, what + ": " + std::string(doing));
                    },
                    job.stop};
    auto run = trial(combination, inner);
    if (!run) return tl::unexpected(run.error());
    run->combination = combination;
    runs.push_back(*std::move(run));
    return {};
  };
  for (const Combination& combination : design.runs)
    if (auto done = doOne(combination); !done) return tl::unexpected(done.error());
  ParameterStudy study = analyseStudy(design, runs, settings);
  const ResponseStudy* primary = study.of(settings.primary);
  if (primary == nullptr || !primary->best) return study;
  const Combination best = primary->best->combination;
  if (std::find(design.runs.begin(), design.runs.end(), best) != design.runs.end()) return study;
  if (auto done = doOne(best); !done) return tl::unexpected(done.error());
  runs.back().confirmation = true;
  return analyseStudy(design, std::move(runs), settings);
}

std::string toCsv(const ParameterStudy& study) {
  std::string csv = "run,";
  for (const Factor& factor : study.design.factors) csv += quoted(factor.name) + ",";
  csv += "camera,placement,confirmation,same_as_run,refusal,failure";
  for (const Response response : kResponses) csv += "," + std::string(name(response));
  csv += "\n";
  for (std::size_t i = 0; i < study.runs.size(); ++i) {
    const StudyRun& run = study.runs[i];
    std::string head = std::to_string(i + 1) + ",";
    for (std::size_t f = 0; f < study.design.factors.size(); ++f)
      head += quoted(words(study.design.factors[f].levels[static_cast<std::size_t>(run.combination[f])])) + ",";
    for (const StudyUnit& unit : run.units) {
      csv += head + (unit.camera < 0 ? "all" : std::to_string(unit.camera + 1)) + "," +
             (unit.placement < 0 ? "all" : std::to_string(unit.placement + 1)) + "," +
             (run.confirmation ? "yes" : "no") + "," + (run.sameAs < 0 ? "" : std::to_string(run.sameAs + 1)) + "," +
             quoted(run.refusal) + "," + quoted(unit.failure);
      for (const double value : unit.values) csv += "," + numberOrNothing(value);
      csv += "\n";
    }
  }
  return csv;
}

}  // namespace vignole
