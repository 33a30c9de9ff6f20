#include "cli/inspect_output.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "cli/live_line.h"

namespace vignole::cli {

namespace {

using Json = nlohmann::ordered_json;

Json numberOrNull(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json toJson(const DimensionSummary& d) {
  const bool measured = d.values.count() > 0;
  const auto ifMeasured = [measured](double value) { return measured ? Json(value) : Json(nullptr); };
  Json json = {{"name", name(d.dimension)},
               {"nominal_mm", d.nominalMm},
               {"mean_mm", ifMeasured(d.meanMm())},
               {"min_mm", ifMeasured(d.values.min())},
               {"max_mm", ifMeasured(d.values.max())},
               {"s_mm", ifMeasured(d.values.sd())},
               {"u_mm", ifMeasured(d.uMm)},
               {"u_mean_mm", ifMeasured(d.uOfMeanMm())},
               {"u_calibration_mm", ifMeasured(d.uCalibrationMm)},
               {"lower_mm", numberOrNull(d.lowerMm)},
               {"upper_mm", numberOrNull(d.upperMm)},
               {"verdict", name(d.verdict)},
               {"exceptions", Json::array()},
               {"measured", d.values.count()},
               {"not_measured", d.notMeasured}};
  if (d.notMeasured > 0) json["reason"] = d.reason;
  for (const DimensionException& e : d.exceptions)
    json["exceptions"].push_back({{"from_m", e.fromM}, {"to_m", e.toM}, {"worst_mm", e.worstMm}});
  return json;
}

Json toJson(const TriggerLedger& ledger) {
  Json reasons = Json::object();
  for (const auto& [reason, count] : ledger.reasons) reasons[reason] = count;
  return {{"seen", ledger.seen},
          {"measured", ledger.measured},
          {"incomplete", ledger.incomplete},
          {"lost", ledger.lost},
          {"reasons", reasons}};
}

Json toJson(const Accuracy& accuracy) {
  Json dimensions = Json::array();
  for (const Dimension d : kDimensions) {
    const DimensionAccuracy& a = accuracy.of(d);
    if (a.count() == 0) continue;
    dimensions.push_back({{"name", name(d)},
                          {"bias_mm", a.biasMm()},
                          {"rms_mm", a.rmsMm()},
                          {"max_mm", a.maxMm()},
                          {"mean_sq_error_over_u", numberOrNull(a.meanSquareErrorOverU())},
                          {"n", a.count()}});
  }
  return {{"dimensions", dimensions}};
}

Json toJson(const RigCalibration& c, const CalibrationAge& age) {
  return {{"id", c.id},
          {"method", c.method},
          {"created", c.created},
          {"age_days", age.days ? Json(std::round(100 * *age.days) / 100) : Json(nullptr)},
          {"interval_days", c.intervalDays > 0 ? Json(c.intervalDays) : Json(nullptr)},
          {"overdue", age.overdue},
          {"plate", c.plate.empty() ? Json(nullptr) : Json(c.plate)}};
}

Json toJson(const DriftIndicators& drift, const std::optional<std::uint64_t>& firstRail) {
  Json cameras = Json::array();
  for (const CameraDrift& c : drift.cameras) {
    const auto known = [&](double value) { return drift.learning ? Json(nullptr) : Json(value); };
    cameras.push_back({{"camera", c.camera + 1},
                       {"value_mm", known(c.valueMm)},
                       {"u_mm", known(c.uMm)},
                       {"limit_mm", known(c.limitMm)},
                       {"x_mm", known(c.xMm)},
                       {"y_mm", known(c.yMm)},
                       {"turn_deg", known(c.turnDeg)},
                       {"alarm", c.alarm},
                       {"words", c.words}});
  }
  return {{"rails", drift.rails},
          {"learning", drift.learning},
          {"alarm", drift.alarm()},
          {"first_alarm_rail", firstRail ? Json(*firstRail) : Json(nullptr)},
          {"unexplained_chi2", drift.learning ? Json(nullptr) : Json(drift.unexplained)},
          {"cameras", cameras}};
}

Json toJson(const RecorderState& r) {
  return {{"path", r.path.string()},       {"mb", r.megabytes},
          {"triggers", r.triggers},        {"frames", r.frames},
          {"whole_frames", r.wholeFrames}, {"dropped_triggers", r.dropped},
          {"kept_share", r.keptShare},     {"cpu_ms_per_frame", r.packCpuMs},
          {"files_kept", r.filesKept},     {"files_discarded", r.filesDiscarded}};
}

double rateOf(const InspectionOutcome& outcome) {
  return outcome.wallS > 0 ? static_cast<double>(outcome.profiles) / outcome.wallS : 0;
}

/// printf into a string.
[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...) {
  std::array<char, 512> buffer{};
  va_list arguments;
  va_start(arguments, pattern);
  const int length = std::vsnprintf(buffer.data(), buffer.size(), pattern, arguments);
  va_end(arguments);
  return length < 0 ? std::string() : std::string(buffer.data());
}

std::string fixedOrDash(const std::optional<double>& value) { return value ? format("%.3f", *value) : "-"; }

void appendNumber(std::string& text, double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  text.append(buffer.data(), end.ptr);
}

/// A field that may hold a comma or a quote.
std::string csvField(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string flagsOf(const ProfileResult& result) {
  std::string flags;
  const auto add = [&flags](const std::string& word) { flags += (flags.empty() ? "" : "|") + word; };
  for (std::size_t c = 0; c < kCameraCount; ++c) {
    const std::string camera = "camera " + std::to_string(c + 1) + ": ";
    if (!result.profile.missing[c].empty()) add(camera + result.profile.missing[c]);
    if (result.profile.overloaded[c]) add(camera + "overloaded");
  }
  if (!result.registration.valid) add("not registered: " + result.registration.reason);
  return flags;
}

}  // namespace

nlohmann::ordered_json toJson(const InspectedRail& rail) {
  const RailSummary& s = rail.summary;
  Json dimensions = Json::array();
  for (const DimensionSummary& d : s.dimensions) dimensions.push_back(toJson(d));
  Json json = {{"id", s.rail.id},
               {"heat", s.rail.heat},
               {"section", rail.section},
               {"recipe", s.recipe},
               {"length_m", s.lengthM},
               {"profiles", s.profiles},
               {"verdict", name(s.verdict)},
               {"dimensions", dimensions},
               {"triggers", toJson(s.triggers)}};
  if (s.looksLike)
    json["looks_like"] = {{"section", s.looksLike->section},
                          {"chi2", s.looksLike->chi2},
                          {"chi2_of_recipe", s.looksLike->chi2OfRecipe},
                          {"profiles", s.looksLike->profiles}};
  return json;
}

nlohmann::ordered_json toJson(const StageStatistics& s) {
  return {{"name", s.name},
          {"count", s.count},
          {"mean_ms", s.meanMs},
          {"sd_ms", s.sdMs},
          {"ucl99_ms", s.ucl99Ms},
          {"max_ms", s.maxMs},
          {"queue_capacity", s.queueCapacity},
          {"queue_high_water", s.queueHighWater},
          {"overflows", s.overflows},
          {"cpu_ms", s.cpuMs}};
}

std::string toTable(const InspectedRail& rail) {
  const RailSummary& s = rail.summary;
  std::string text = format("Rail %s  %s  %s  %.3f m  %llu profiles  verdict: %s\n", s.rail.id.c_str(),
                            rail.section.c_str(), s.recipe.c_str(), s.lengthM,
                            static_cast<unsigned long long>(s.profiles), std::string(name(s.verdict)).c_str());
  text += format("%-6s %9s %9s %9s %9s %8s %8s %8s %8s %9s %9s  %-12s %s\n", "mm", "nominal", "mean", "min", "max", "s",
                 "u", "u(cal)", "u(mean)", "lower", "upper", "verdict", "exceptions");
  for (const DimensionSummary& d : s.dimensions) {
    const std::string word(name(d.verdict)), label(name(d.dimension));
    if (d.values.count() == 0) {
      text += format("%-6s %9.3f %9s %9s %9s %8s %8s %8s %8s %9s %9s  %-12s %s\n", label.c_str(), d.nominalMm, "-", "-",
                     "-", "-", "-", "-", "-", fixedOrDash(d.lowerMm).c_str(), fixedOrDash(d.upperMm).c_str(),
                     "not measured", d.reason.c_str());
      continue;
    }
    text += format("%-6s %9.3f %9.3f %9.3f %9.3f %8.4f %8.4f %8.4f %8.4f %9s %9s  %-12s", label.c_str(), d.nominalMm,
                   d.meanMm(), d.values.min(), d.values.max(), d.values.sd(), d.uMm, d.uCalibrationMm, d.uOfMeanMm(),
                   fixedOrDash(d.lowerMm).c_str(), fixedOrDash(d.upperMm).c_str(), word.c_str());
    if (!d.exceptions.empty()) {
      const DimensionException& first = d.exceptions.front();
      text += format(" %zu (%.3f-%.3f m, worst %.3f)", d.exceptions.size(), first.fromM, first.toM, first.worstMm);
    }
    text += "\n";
  }
  if (s.looksLike)
    text += format("This rail looks like %s (chi2 %.1f) rather than %s (chi2 %.1f): is it the right recipe?\n",
                   s.looksLike->section.c_str(), s.looksLike->chi2, rail.section.c_str(), s.looksLike->chi2OfRecipe);
  return text;
}

nlohmann::ordered_json toJson(const InspectionOutcome& outcome) {
  Json json = {{"version", VIGNOLE_VERSION}};
  json["rails"] = Json::array();
  for (const InspectedRail& rail : outcome.rails) json["rails"].push_back(toJson(rail));
  json["triggers"] = toJson(outcome.triggers);
  json["stages"] = Json::array();
  for (const StageStatistics& stage : outcome.stages) json["stages"].push_back(toJson(stage));
  json["profiles_per_s"] = rateOf(outcome);
  json["wall_s"] = outcome.wallS;
  json["calibration"] = toJson(outcome.calibration, outcome.calibrationAge);
  json["drift"] = toJson(outcome.drift, outcome.firstDriftRail);
  json["effects"] = Json::object();
  for (const auto& [effect, value] : outcome.effects) json["effects"][effect] = value;
  if (outcome.accuracy != nullptr) json["truth"] = toJson(*outcome.accuracy);
  if (outcome.recorded) json["recorded"] = toJson(*outcome.recorded);
  if (!outcome.cameras.empty()) {
    json["cameras"] = Json::array();
    for (const CameraReport& camera : outcome.cameras) json["cameras"].push_back(cli::toJson(camera));
    json["line"] = cli::toJson(outcome.line);
    json["cpu"] = cli::toJson(outcome.reception, outcome.cameras);
  }
  return json;
}

std::string toTable(const InspectionOutcome& outcome) {
  std::string text;
  for (const InspectedRail& rail : outcome.rails) text += toTable(rail) + "\n";
  if (outcome.accuracy != nullptr) {
    text += "Against the truth of the virtual rig, single profiles\n";
    text += format("%-6s %9s %9s %9s %12s\n", "mm", "bias", "rms", "max", "mean(e/u)^2");
    for (const Dimension d : kDimensions) {
      const DimensionAccuracy& a = outcome.accuracy->of(d);
      if (a.count() > 0)
        text += format("%-6s %9.4f %9.4f %9.4f %12.3f\n", std::string(name(d)).c_str(), a.biasMm(), a.rmsMm(),
                       a.maxMm(), a.meanSquareErrorOverU().value_or(0));
    }
    text += "\n";
  }
  text += format("%-12s %8s %9s %9s %9s %9s %12s %9s\n", "Stage (ms)", "count", "mean", "SD", "99% UCL", "max", "queue",
                 "overflows");
  for (const StageStatistics& s : outcome.stages) {
    const std::string queue =
        s.queueCapacity == 0 ? "-" : std::to_string(s.queueHighWater) + "/" + std::to_string(s.queueCapacity);
    text += format("%-12s %8llu %9.3f %9.3f %9.3f %9.3f %12s %9llu\n", s.name.c_str(),
                   static_cast<unsigned long long>(s.count), s.meanMs, s.sdMs, s.ucl99Ms, s.maxMs, queue.c_str(),
                   static_cast<unsigned long long>(s.overflows));
  }
  const TriggerLedger& t = outcome.triggers;
  text += format("\nTriggers: %llu seen = %llu measured + %llu incomplete + %llu lost\n",
                 static_cast<unsigned long long>(t.seen), static_cast<unsigned long long>(t.measured),
                 static_cast<unsigned long long>(t.incomplete), static_cast<unsigned long long>(t.lost));
  for (const auto& [reason, count] : t.reasons)
    text += format("  %8llu  %s\n", static_cast<unsigned long long>(count), reason.c_str());
  text += toTable(outcome.cameras);
  for (const CameraDrift& c : outcome.drift.cameras)
    if (c.alarm) text += "Drift: " + c.words + "\n";
  if (const auto& r = outcome.recorded)
    text += format("Recorded: %.1f MB, %llu triggers, %.1f %% of the pixels, %llu dropped, in %s\n", r->megabytes,
                   static_cast<unsigned long long>(r->triggers), 100 * r->keptShare,
                   static_cast<unsigned long long>(r->dropped), r->path.string().c_str());
  text += format("%.1f profiles/s, %.2f s, calibration %s (%s)\n", rateOf(outcome), outcome.wallS,
                 outcome.calibration.id.c_str(), outcome.calibration.method.c_str());
  return text;
}

std::string csvHeader() {
  std::string text = "rail,profile,position_m,trigger";
  for (const Dimension d : kDimensions) text += "," + std::string(name(d));
  for (const Dimension d : kDimensions) text += ",u_" + std::string(name(d));
  return text + ",rms_mm,inliers,flags\n";
}

std::string csvRow(const ProfileResult& result, std::uint64_t profile) {
  std::string text = csvField(result.rail->id) + "," + std::to_string(profile) + ",";
  appendNumber(text, result.profile.positionMm / 1000);
  text += "," + std::to_string(result.profile.trigger);
  for (const DimensionResult& d : result.measurement.dimensions) {
    text += ",";
    if (d.valueMm) appendNumber(text, *d.valueMm);
  }
  for (const DimensionResult& d : result.measurement.dimensions) {
    text += ",";
    if (d.valueMm) appendNumber(text, d.uMm);
  }
  text += ",";
  if (result.registration.valid) appendNumber(text, result.registration.rmsMm);
  text += "," + std::to_string(result.registration.inliers) + "," + csvField(flagsOf(result)) + "\n";
  return text;
}

}  // namespace vignole::cli
