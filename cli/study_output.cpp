#include "cli/study_output.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace vignole::cli {
namespace {

using Json = nlohmann::ordered_json;

[[gnu::format(printf, 1, 2)]] std::string printed(const char* format, ...) {
  std::array<char, 512> buffer{};
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(buffer.data(), buffer.size(), format, arguments);
  va_end(arguments);
  return buffer.data();
}

Json levelJson(const FactorLevel& level) {
  if (const auto* number = std::get_if<double>(&level)) return *number;
  return std::get<std::string>(level);
}

const FactorLevel& levelOf(const ParameterStudy& study, int factor, int level) {
  return study.design.factors[static_cast<std::size_t>(factor)].levels[static_cast<std::size_t>(level)];
}

Json settingJson(const ParameterStudy& study, const Combination& combination) {
  Json json = Json::object();
  for (std::size_t f = 0; f < combination.size(); ++f)
    json[study.design.factors[f].name] = levelJson(levelOf(study, static_cast<int>(f), combination[f]));
  return json;
}

Json lineJson(const VarianceLine& line) {
  return {{"source", line.name}, {"ss", line.squares}, {"df", line.dof},     {"ms", line.meanSquare},
          {"f", line.f},         {"p", line.p},        {"eta2", line.share}, {"partial_eta2", line.partialShare}};
}

Json scaledJson(const ScaledMean& mean) { return {{"mean", mean.mean}, {"low", mean.low}, {"high", mean.high}}; }

Json effectJson(const ParameterStudy& study, const ResponseStudy& response, const Effect& effect) {
  Json names = Json::array(), means = Json::array();
  for (const int f : effect.factors) names.push_back(study.design.factors[static_cast<std::size_t>(f)].name);
  for (const EffectMean& mean : effect.means) {
    Json levels = Json::array();
    for (std::size_t i = 0; i < mean.levels.size(); ++i)
      levels.push_back(levelJson(levelOf(study, effect.factors[i], mean.levels[i])));
    Json json{{"levels", levels}};
    json.update(scaledJson(response.scaled(mean.mean, mean.standardError)));
    json["n"] = mean.count;
    json["raw_mean"] = response.scaled(mean.rawMean, 0).mean;
    means.push_back(json);
  }
  return {{"factors", names},
          {"means", means},
          {"range", effect.range},
          {"contrast", effect.contrast},
          {"contrast_se", effect.contrastError}};
}

Json bestJson(const ParameterStudy& study, const BestSetting& best) {
  Json ties = Json::array();
  for (const Combination& tie : best.ties) ties.push_back(settingJson(study, tie));
  return {{"setting", settingJson(study, best.combination)},
          {"predicted", scaledJson(best.predicted)},
          {"foretold_by_others", scaledJson(best.foretold)},
          {"observed", best.observed},
          {"observations", best.observations},
          {"confirmed", best.confirmed},
          {"remark", best.remark},
          {"within_one_standard_error", ties}};
}

Json responseJson(const ParameterStudy& study, const ResponseStudy& response) {
  Json json{{"name", name(response.response)},
            {"what", longName(response.response)},
            {"scale", response.logarithmic ? "log" : "linear"},
            {"larger_is_better", largerIsBetter(response.response)},
            {"observations", response.observations}};
  if (!response.analysis) {
    json["why_not"] = response.whyNot;
    return json;
  }
  const VarianceAnalysis& a = *response.analysis;
  Json lines = Json::array(), ranking = Json::array(), main = Json::array(), interactions = Json::array();
  if (a.blocks.dof > 0) lines.push_back(lineJson(a.blocks));
  for (const VarianceLine& line : a.terms) lines.push_back(lineJson(line));
  lines.push_back(lineJson(a.error));
  lines.push_back(lineJson(a.total));
  for (const int i : a.ranking) ranking.push_back(a.terms[static_cast<std::size_t>(i)].name);
  for (const Effect& effect : a.effects)
    (effect.factors.size() == 1 ? main : interactions).push_back(effectJson(study, response, effect));
  json["mean"] = response.scaled(a.mean, 0).mean;
  json["anova"] = {{"type", "II"}, {"balanced", a.balanced}, {"order", a.order}, {"lines", lines}};
  json["ranking"] = ranking;
  json["main_effects"] = main;
  json["interactions"] = interactions;
  json["best"] = response.best ? bestJson(study, *response.best) : Json(nullptr);
  json["remarks"] = a.remarks;
  return json;
}

/// Mean over the units of a run that observed it; null without any.
Json runMeans(const StudyRun& run) {
  Json json = Json::object();
  for (const Response response : kResponses) {
    double sum = 0;
    int n = 0;
    for (const StudyUnit& unit : run.units)
      if (const double value = unit.values[static_cast<std::size_t>(response)]; std::isfinite(value)) {
        sum += value;
        ++n;
      }
    json[std::string(name(response))] = n > 0 ? Json(sum / n) : Json(nullptr);
  }
  return json;
}

Json runsJson(const ParameterStudy& study) {
  Json runs = Json::array();
  for (std::size_t i = 0; i < study.runs.size(); ++i) {
    const StudyRun& run = study.runs[i];
    Json failures = Json::array();
    for (const StudyUnit& unit : run.units)
      if (!unit.failure.empty())
        failures.push_back({{"camera", unit.camera + 1}, {"placement", unit.placement + 1}, {"reason", unit.failure}});
    runs.push_back({{"run", i + 1},
                    {"setting", settingJson(study, run.combination)},
                    {"refusal", run.refusal},
                    {"confirmation", run.confirmation},
                    {"same_as_run", run.sameAs < 0 ? Json(nullptr) : Json(run.sameAs + 1)},
                    {"failures", failures},
                    {"means", runMeans(run)}});
  }
  return runs;
}

std::string pText(double p) {
  if (!std::isfinite(p)) return "-";
  return p < 1e-4 ? "<0.0001" : printed("%.4f", p);
}

std::string rankingTable(const VarianceAnalysis& a) {
  std::string text = printed("  %-34s %8s %5s %10s %9s\n", "influence", "eta^2", "dof", "F", "p");
  for (const int i : a.ranking) {
    const VarianceLine& line = a.terms[static_cast<std::size_t>(i)];
    text += printed("  %-34s %7.1f%% %5d %10.2f %9s\n", line.name.c_str(), 100 * line.share, line.dof, line.f,
                    pText(line.p).c_str());
  }
  if (a.error.dof > 0) text += printed("  %-34s %8s %5d\n", "error", "", a.error.dof);
  return text;
}

std::string levelText(const ResponseStudy& response, const EffectMean& mean) {
  if (!std::isfinite(mean.mean))  // some combination has failed altogether
    return mean.count == 0 ? "-" : printed("%.4g*", response.scaled(mean.rawMean, 0).mean);
  const ScaledMean m = response.scaled(mean.mean, mean.standardError);
  return printed("%.4g (%.4g..%.4g)", m.mean, m.low, m.high);
}

std::string mainEffects(const ParameterStudy& study, const ResponseStudy& response) {
  std::string text;
  bool raw = false;
  for (const Effect& effect : response.analysis->effects) {
    if (effect.factors.size() != 1) continue;
    text += printed("  %-16s", effect.name.c_str());
    for (const EffectMean& mean : effect.means) {
      text += "  " + words(levelOf(study, effect.factors[0], mean.levels[0])) + ": " + levelText(response, mean);
      raw = raw || !std::isfinite(mean.mean);
    }
    text += "\n";
  }
  if (raw) text += "  * mean of what there is: combinations that failed altogether leave no balanced one\n";
  return text;
}

std::string bestText(const ParameterStudy& study, const ResponseStudy& response) {
  if (!response.best) return "  no best setting: no run yields a prediction\n";
  const BestSetting& b = *response.best;
  return printed("  best setting: %s\n", words(study.design.factors, b.combination).c_str()) +
         printed("    predicted %.4g (%.4g..%.4g); the other runs foretell %.4g, its own run yields %.4g: %s\n",
                 b.predicted.mean, b.predicted.low, b.predicted.high, b.foretold.mean, b.observed,
                 b.confirmed ? "confirmed" : b.remark.c_str()) +
         printed("    settings within one standard error: %zu\n", b.ties.size());
}

}  // namespace

Json toJson(const ParameterStudy& study, const StudyPlan& plan) {
  Json factors = Json::array(), responses = Json::array(), fixed = Json::object();
  for (const Factor& factor : study.design.factors) {
    Json levels = Json::array();
    for (const FactorLevel& level : factor.levels) levels.push_back(levelJson(level));
    factors.push_back({{"name", factor.name}, {"levels", levels}});
  }
  for (const auto& [factor, level] : plan.fixed) fixed[factor] = levelJson(level);
  for (const ResponseStudy& response : study.responses) responses.push_back(responseJson(study, response));
  return {{"version", VIGNOLE_VERSION},
          {"design",
           {{"factors", factors},
            {"fixed", fixed},
            {"runs", study.design.runs.size()},
            {"full_runs", study.design.fullRuns},
            {"efficiency", study.design.efficiency}}},
          {"primary", name(study.primary)},
          {"cameras_tried", study.unitsTried},
          {"cameras_failed", study.unitsFailed},
          {"runs_refused", study.runsRefused},
          {"failures", study.failures},
          {"responses", responses},
          {"runs", runsJson(study)},
          {"remarks", study.remarks}};
}

std::string toTable(const ParameterStudy& study) {
  std::string text =
      printed("%zu runs of %zu; %d of %d cameras in placements failed, %d runs refused\n", study.design.runs.size(),
              study.design.fullRuns, study.unitsFailed, study.unitsTried, study.runsRefused);
  for (const auto& [reason, times] : study.failures) text += printed("  %5d x %s\n", times, reason.c_str());
  for (const ResponseStudy& response : study.responses) {
    text += "\n" + std::string(longName(response.response)) +
            (response.response == study.primary ? " (the best setting is taken by this)" : "") + "\n";
    if (!response.analysis) {
      text += "  not analysed: " + response.whyNot + "\n";
      continue;
    }
    text += printed("  %d observations, %s %.4g\n", response.observations,
                    response.logarithmic ? "geometric mean" : "mean", response.scaled(response.analysis->mean, 0).mean);
    text += rankingTable(*response.analysis) + mainEffects(study, response) + bestText(study, response);
    for (const std::string& remark : response.analysis->remarks) text += "  " + remark + "\n";
  }
  for (const std::string& remark : study.remarks) text += remark + "\n";
  return text;
}

}  // namespace vignole::cli
