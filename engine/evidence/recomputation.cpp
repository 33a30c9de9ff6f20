#include "engine/evidence/recomputation.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/inspection/profile_measurement.h"
#include "engine/measurement/verdict.h"

namespace vignole {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxFindings = 20;
/// What rounding the points to 10 nm may do to a value, as a share of its standard uncertainty (a few um of noise).
constexpr double kShareOfU = 0.05;
constexpr double kMaxMm = 1e9, kMaxPointMm = 1e5;

Json numberOrNull(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

std::optional<double> optionalFrom(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}

Verdict verdictFrom(const Json& json) {
  const auto word = json.get<std::string>();
  for (const Verdict v : {Verdict::Pass, Verdict::Near, Verdict::Fail, Verdict::NotMeasured, Verdict::NoLimit})
    if (word == name(v)) return v;
  throw Json::other_error::create(501, "\"" + word + "\" is no verdict", nullptr);
}

RailState stateFrom(const Json& json) {
  const auto word = json.get<std::string>();
  for (const RailState s : {RailState::Running, RailState::Finished, RailState::Interrupted})
    if (word == name(s)) return s;
  throw Json::other_error::create(501, "\"" + word + "\" is no state of a rail", nullptr);
}

Json toJson(const TriggerLedger& triggers) {
  Json reasons = Json::object();
  for (const auto& [reason, count] : triggers.reasons) reasons[reason] = count;
  return {{"seen", triggers.seen},
          {"measured", triggers.measured},
          {"incomplete", triggers.incomplete},
          {"lost", triggers.lost},
          {"reasons", reasons}};
}

Json toJson(const DimensionSummary& d) {
  Json exceptions = Json::array();
  for (const DimensionException& e : d.exceptions) exceptions.push_back({e.fromM, e.toM, e.worstMm});
  return {{"name", name(d.dimension)},
          {"nominal_mm", d.nominalMm},
          {"lower_mm", numberOrNull(d.lowerMm)},
          {"upper_mm", numberOrNull(d.upperMm)},
          {"measured", d.values.count()},
          {"not_measured", d.notMeasured},
          {"mean_mm", d.values.mean()},
          {"s_mm", d.values.sd()},
          {"min_mm", d.values.min()},
          {"max_mm", d.values.max()},
          {"u_mm", d.uMm},
          {"u_calibration_mm", d.uCalibrationMm},
          {"radius_mm", d.radius.empty() ? Json(nullptr) : Json(d.radius.radiusMm())},
          {"radius_u_mm", d.radius.empty() ? Json(nullptr) : Json(d.radius.uMm())},
          {"verdict", name(d.verdict)},
          {"reason", d.reason},
          {"exceptions_from_to_worst", exceptions}};
}

DimensionSummary dimensionFrom(const Json& json, Dimension dimension) {
  DimensionSummary d;
  d.dimension = dimension;
  d.nominalMm = json.at("nominal_mm").get<double>();
  d.lowerMm = optionalFrom(json.at("lower_mm"));
  d.upperMm = optionalFrom(json.at("upper_mm"));
  d.values = {json.at("measured").get<std::uint64_t>(), json.at("mean_mm").get<double>(), json.at("s_mm").get<double>(),
              json.at("min_mm").get<double>(), json.at("max_mm").get<double>()};
  d.notMeasured = json.at("not_measured").get<std::uint64_t>();
  d.uMm = json.at("u_mm").get<double>();
  d.uCalibrationMm = json.at("u_calibration_mm").get<double>();
  if (!json.at("radius_mm").is_null())
    d.radius = {json.at("radius_mm").get<double>(), json.at("radius_u_mm").get<double>()};
  d.verdict = verdictFrom(json.at("verdict"));
  d.reason = json.at("reason").get<std::string>();
  for (const Json& e : json.at("exceptions_from_to_worst"))
    d.exceptions.push_back({e.at(0).get<double>(), e.at(1).get<double>(), e.at(2).get<double>()});
  return d;
}

Json toJson(const DimensionResult& d) {
  return {numberOrNull(d.valueMm), d.uMm, d.uCalibrationMm, numberOrNull(d.secondMm), name(d.verdict), d.reason};
}

void add(std::vector<std::string>& findings, const std::string& what) {
  if (findings.size() < kMaxFindings)
    findings.push_back(what);
  else if (findings.size() == kMaxFindings)
    findings.emplace_back("and more");
}

/// Does what was measured again differ from what the archive had, by more than the archive rounds to?
void compareProfile(const ProfileRecord& was, const ProfileResult& is, std::uint64_t number, bool exact,
                    std::vector<std::string>& findings) {
  const std::string where = "profile " + std::to_string(number);
  if (was.registered != is.registration.valid) {
    add(findings, where + (was.registered ? ": cannot be registered: " + is.registration.reason
                                          : ": is registered, and was not: " + was.whyNotRegistered));
    return;
  }
  for (const Dimension d : kDimensions) {
    const DimensionResult &before = was.dimensions[index(d)], &now = is.measurement.dimensions[index(d)];
    const std::string dimension = where + ", " + std::string(name(d));
    if (before.valueMm.has_value() != now.valueMm.has_value()) {
      add(findings, dimension + (now.valueMm ? ": is measured, and was not" : ": is not measured: " + now.reason));
    } else if (now.valueMm) {
      const double allowed = kRecordStepMm + (exact ? 0 : kShareOfU * now.uMm), by = *now.valueMm - *before.valueMm;
      if (!(std::abs(by) <= allowed)) add(findings, dimension + ": differs by " + std::to_string(by) + " mm");
      if (exact && before.verdict != now.verdict)
        add(findings,
            dimension + ": " + std::string(name(now.verdict)) + ", and was " + std::string(name(before.verdict)));
    }
  }
}

/// A profile as the archive has it, its dimensions judged again.
void fromRecord(const ProfileRecord& record, const EvidenceContent& content, ProfileResult& result) {
  result.profile.positionMm = record.positionMm;
  result.registration = {};
  result.registration.valid = record.registered;
  result.registration.reason = record.whyNotRegistered;
  result.measurement.dimensions = record.dimensions;
  for (const Dimension d : kDimensions) {
    DimensionResult& dimension = result.measurement.dimensions[index(d)];
    dimension.nominalMm = content.rail.summary.dimensions[index(d)].nominalMm;
    judge(d, content.recipe.limits[index(d)], dimension);
  }
}

/// Every profile to the last bit: then so is the rail. Otherwise what the archive rounded shows.
void compareRail(const RailSummary& was, const RailSummary& is, bool everyBit, std::vector<std::string>& findings) {
  if (was.verdict != is.verdict)
    add(findings, "the rail: " + std::string(name(is.verdict)) + ", and was " + std::string(name(was.verdict)));
  for (const Dimension d : kDimensions) {
    const DimensionSummary &before = was.dimensions[index(d)], &now = is.dimensions[index(d)];
    const std::string where = "the rail, " + std::string(name(d));
    if (before.verdict != now.verdict)
      add(findings, where + ": " + std::string(name(now.verdict)) + ", and was " + std::string(name(before.verdict)));
    if (before.values.count() != now.values.count() || before.notMeasured != now.notMeasured ||
        before.exceptions.size() != now.exceptions.size())
      add(findings, where + ": other counts of profiles or exceptions");
    const double allowed = everyBit ? 0 : kRecordStepMm + 2 * kShareOfU * now.uMm;
    const auto differs = [&](double a, double b) { return !(std::abs(a - b) <= allowed); };
    if (differs(before.nominalMm, now.nominalMm) || differs(before.values.mean(), now.values.mean()) ||
        differs(before.values.min(), now.values.min()) || differs(before.values.max(), now.values.max()))
      add(findings, where + ": other values");
  }
}

bool within(double value, double limit) { return std::abs(value) <= limit; }  // false for NaN

std::string refusalOf(const Profile& profile) {
  if (!within(profile.positionMm, kMaxMm) || profile.positionMm < 0) return "lies nowhere on a rail";
  if (!within(profile.correlatedPoints, 1e6)) return "has errors that no points share";
  for (const ProfilePoint& p : profile.points)
    if (!within(p.x, kMaxPointMm) || !within(p.y, kMaxPointMm) || !within(p.nx, 2) || !within(p.ny, 2) ||
        !within(p.sigmaMm, kMaxPointMm) || !within(p.shiftMm, kMaxPointMm) || !within(p.ridgeSigmaMm, kMaxPointMm) ||
        !within(p.smoothingMm, kMaxPointMm) || p.sigmaMm < 0 || p.ridgeSigmaMm < 0)
      return "has points that are nowhere";
  std::uint64_t points = 0;
  for (const std::uint32_t n : profile.pointsOfCamera) points += n;
  if (points != profile.points.size()) return "has other points than its cameras gave";
  return {};
}

}  // namespace

nlohmann::ordered_json toJson(const RailSummary& summary) {
  Json dimensions = Json::array();
  for (const DimensionSummary& d : summary.dimensions) dimensions.push_back(toJson(d));
  return {{"length_m", summary.lengthM},
          {"profiles", summary.profiles},
          {"verdict", name(summary.verdict)},
          {"dimensions", dimensions}};
}

nlohmann::ordered_json toJson(const StoredRail& rail) {
  const RailSummary& s = rail.summary;
  const auto& other = s.looksLike;
  Json json = {{"uid", rail.uid},
               {"id", s.rail.id},
               {"heat", s.rail.heat},
               {"strand", rail.papers.strand},
               {"order", rail.papers.orderNumber},
               {"shift", rail.papers.shift},
               {"operator", rail.papers.operatorName},
               {"section", s.rail.sectionName},
               {"recipe", s.recipe},
               {"calibration", s.calibrationId},
               {"calibration_warning", s.calibrationWarning},
               {"state", name(rail.state)},
               {"began_us", rail.beganUs},
               {"ended_us", rail.endedUs},
               {"line", rail.place.line},
               {"source", rail.place.source},
               {"program", rail.place.program},
               {"machine", rail.place.machine},
               {"first_trigger", s.rail.firstTrigger},
               {"spacing_mm", s.rail.spacingMm},
               {"announced_mm", s.rail.lengthMm},
               {"speed_mm_per_s", s.rail.speedMmPerS},
               {"temperature_c", s.rail.temperatureC},
               {"temperature_u_c", s.rail.temperatureUncertaintyC},
               {"profiles_not_stored", rail.notStored},
               {"triggers", toJson(s.triggers)},
               {"looks_like", other ? Json({{"section", other->section},
                                            {"profiles", other->profiles},
                                            {"chi2", other->chi2},
                                            {"chi2_of_recipe", other->chi2OfRecipe}})
                                    : Json(nullptr)}};
  json.update(toJson(s));
  return json;
}

StoredRail railFromJson(const nlohmann::ordered_json& json) {
  const auto text = [&](const char* key) { return json.at(key).get<std::string>(); };
  const auto real = [&](const char* key) { return json.at(key).get<double>(); };
  StoredRail rail;
  RailSummary& s = rail.summary;
  rail.uid = text("uid");
  s.rail.id = text("id");
  s.rail.heat = text("heat");
  rail.papers = {text("strand"), text("order"), text("shift"), text("operator")};
  s.rail.sectionName = text("section");
  s.recipe = text("recipe");
  s.calibrationId = text("calibration");
  s.calibrationWarning = text("calibration_warning");
  rail.state = stateFrom(json.at("state"));
  rail.beganUs = json.at("began_us").get<TimeUs>();
  rail.endedUs = json.at("ended_us").get<TimeUs>();
  rail.place = {text("line"), text("source"), text("program"), text("machine")};
  s.rail.firstTrigger = json.at("first_trigger").get<std::uint64_t>();
  s.rail.spacingMm = real("spacing_mm");
  s.rail.lengthMm = real("announced_mm");
  s.rail.speedMmPerS = real("speed_mm_per_s");
  s.rail.temperatureC = real("temperature_c");
  s.rail.temperatureUncertaintyC = real("temperature_u_c");
  rail.notStored = json.at("profiles_not_stored").get<std::uint64_t>();
  const Json& triggers = json.at("triggers");
  s.triggers.seen = triggers.at("seen").get<std::uint64_t>();
  s.triggers.measured = triggers.at("measured").get<std::uint64_t>();
  s.triggers.incomplete = triggers.at("incomplete").get<std::uint64_t>();
  s.triggers.lost = triggers.at("lost").get<std::uint64_t>();
  for (const auto& [reason, count] : triggers.at("reasons").items())
    s.triggers.reasons[reason] = count.get<std::uint64_t>();
  if (const Json& other = json.at("looks_like"); !other.is_null())
    s.looksLike = OtherRail{other.at("section").get<std::string>(), other.at("profiles").get<std::uint64_t>(),
                            other.at("chi2").get<double>(), other.at("chi2_of_recipe").get<double>()};
  s.lengthM = real("length_m");
  s.profiles = json.at("profiles").get<std::uint64_t>();
  s.verdict = verdictFrom(json.at("verdict"));
  for (const Dimension d : kDimensions) s.dimensions[index(d)] = dimensionFrom(json.at("dimensions").at(index(d)), d);
  return rail;
}

std::string refusal(const EvidenceContent& content) {
  const RailBegin& rail = content.rail.summary.rail;
  if (!within(rail.spacingMm, kMaxMm) || rail.spacingMm < 1e-3) return "profiles at no distance that can be";
  if (!within(rail.lengthMm, kMaxMm) || rail.lengthMm < 0) return "a rail of no length that can be";
  if (!within(rail.temperatureC, 2000) || !within(rail.temperatureUncertaintyC, 2000))
    return "a temperature of no rail";
  if (content.rail.summary.profiles != content.profiles.size()) return "other profiles than the rail has";
  for (std::size_t i = 0; i < content.profiles.size(); ++i)
    if (const double at = content.profiles[i].positionMm; !within(at, kMaxMm) || at < 0)
      return "profile " + std::to_string(i) + " lies nowhere on a rail";
  for (const auto& [number, profile] : content.points) {
    const std::string where = "profile " + std::to_string(number);
    if (number >= content.profiles.size()) return where + " is none of the rail";
    if (const std::string why = refusalOf(profile); !why.empty()) return where + " " + why;
  }
  return {};
}

Recomputed recompute(const EvidenceContent& content, const std::function<void(double)>& progress) {
  Recomputed done;
  const RailBegin& begin = content.rail.summary.rail;
  ProfileMeasurement measurement(content.recipe, content.calibration);
  RailSummariser summariser(begin, content.recipe, content.rail.summary.calibrationId);
  ProfileResult result;
  Json profiles = Json::array();
  for (std::size_t i = 0; i < content.profiles.size(); ++i) {
    const ProfileRecord& record = content.profiles[i];
    const auto points = content.points.find(i);
    if (points != content.points.end()) {
      result.profile = points->second;
      measurement.measure(begin, result.profile, result.registration, result.measurement);
      compareProfile(record, result, i, content.exact, done.findings);
      const Registration& r = result.registration;
      Json dimensions = Json::array();
      for (const DimensionResult& d : result.measurement.dimensions) dimensions.push_back(toJson(d));
      profiles.push_back({{"profile", i},
                          {"registered", r.valid},
                          {"reason", r.reason},
                          {"pose", {r.worldFromSection.xMm, r.worldFromSection.yMm, r.worldFromSection.angleRad}},
                          {"rms_mm", r.rmsMm},
                          {"inliers", r.inliers},
                          {"value_u_ucalibration_second_verdict_reason", dimensions}});
      if (progress && profiles.size() % 16 == 0)
        progress(static_cast<double>(profiles.size()) / static_cast<double>(content.points.size()));
    }
    if (points == content.points.end() || !content.exact) fromRecord(record, content, result);
    summariser.add(result);
  }
  RailSummary summary = summariser.summary(content.rail.summary.triggers);
  // Without the points nothing tells that another section explains the profiles: that stays as it was found.
  if (content.rail.summary.looksLike && !summary.looksLike && summary.verdict != Verdict::Fail)
    summary.verdict = Verdict::NotMeasured;
  const bool everyBit = content.exact && content.points.size() == content.profiles.size();
  compareRail(content.rail.summary, summary, everyBit, done.findings);
  done.verdict = summary.verdict;
  done.measured = Json({{"profiles", std::move(profiles)}, {"rail", toJson(summary)}})
                      .dump(1, ' ', false, Json::error_handler_t::replace) +
                  "\n";
  return done;
}

}  // namespace vignole
