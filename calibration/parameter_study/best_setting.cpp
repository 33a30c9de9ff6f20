#include "calibration/parameter_study/best_setting.h"

#include <algorithm>
#include <cmath>

#include "engine/quality/running_statistics.h"

namespace vignole {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Cameras in placements that failed, by setting; of settings that were run.
std::map<Combination, int> failuresOf(const ParameterStudy& study) {
  std::map<Combination, int> failures;
  for (const StudyRun& run : study.runs) {
    if (run.confirmation) continue;
    int& failed = failures[run.combination];
    for (const StudyUnit& unit : run.units)
      failed += unit.values[static_cast<std::size_t>(Response::Success)] == 0 ? 1 : 0;
  }
  return failures;
}

/// In ascending order of levels, so that the first is the preferred one. With a full design: those that were run and
/// failed least; with a fraction those that were not run may do as well and are among them.
std::vector<Combination> candidatesOf(const ParameterStudy& study) {
  const auto failures = failuresOf(study);
  int least = std::numeric_limits<int>::max();
  for (const auto& [combination, failed] : failures) least = std::min(least, failed);
  std::vector<Combination> candidates;
  for (const Combination& combination : allCombinations(study.design.factors)) {
    const auto run = failures.find(combination);
    if (run == failures.end() ? !study.design.full() : run->second == least) candidates.push_back(combination);
  }
  return candidates;
}

void compare(BestSetting& best, const ParameterStudy& study, const ResponseStudy& response,
             const std::vector<Observation>& observations) {
  std::vector<Observation> others, own;
  for (const Observation& o : observations) (o.combination == best.combination ? own : others).push_back(o);
  const Prediction foretold =
      predict(study.design.factors, others, {best.combination}, response.analysis->order).front();
  best.foretold = response.scaled(foretold.value, foretold.standardError);
  double sum = 0;
  for (const Observation& o : own) sum += o.value;
  best.observations = static_cast<int>(own.size());
  for (const StudyRun& run : study.runs)  // a fraction's best setting is run for this alone
    if (run.confirmation && run.combination == best.combination)
      for (const StudyUnit& unit : run.units)
        if (const double v = unit.values[static_cast<std::size_t>(response.response)]; std::isfinite(v)) {
          sum += response.logarithmic ? std::log(v) : v;
          ++best.observations;
        }
  if (best.observations == 0) {
    best.observed = kNone;
    best.remark = "not confirmed: the run with this setting yields no value";
    return;
  }
  const double mean = sum / best.observations;
  best.observed = response.scaled(mean, 0).mean;
  const VarianceLine& error = response.analysis->error;
  if (!std::isfinite(foretold.value) || error.dof == 0) {
    best.remark = "not confirmed: the other runs do not determine what to expect";
    return;
  }
  const double u = std::sqrt(foretold.standardError * foretold.standardError + error.meanSquare / best.observations);
  best.confirmed = std::abs(mean - foretold.value) <= studentQuantile(0.975, error.dof) * u;
  if (!best.confirmed)
    best.remark =
        "not confirmed: the run itself lies outside the 95 % interval of what the other runs foretell; "
        "effects of three factors together, or chance";
}

}  // namespace

std::optional<BestSetting> bestSetting(const ParameterStudy& study, const ResponseStudy& response,
                                       const std::vector<Observation>& observations) {
  const std::vector<Combination> candidates = candidatesOf(study);
  const std::vector<Prediction> predictions =
      predict(study.design.factors, observations, candidates, response.analysis->order);
  const double sign = largerIsBetter(response.response) ? -1 : 1;
  std::size_t top = candidates.size();
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (std::isfinite(predictions[i].value) &&
        (top == candidates.size() || sign * predictions[i].value < sign * predictions[top].value))
      top = i;
  if (top == candidates.size()) return {};
  const double u = std::isfinite(predictions[top].standardError) ? predictions[top].standardError : 0;
  BestSetting best;
  std::size_t first = candidates.size();
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (!(sign * (predictions[i].value - predictions[top].value) <= u)) continue;
    best.ties.push_back(candidates[i]);
    first = std::min(first, i);
  }
  best.combination = candidates[first];
  best.predicted = response.scaled(predictions[first].value, predictions[first].standardError);
  compare(best, study, response, observations);
  return best;
}

}  // namespace vignole
