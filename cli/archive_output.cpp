#include "cli/archive_output.h"

#include <array>
#include <cstdarg>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "cli/inspect_output.h"

namespace vignole::cli {

namespace {

using Json = nlohmann::ordered_json;

/// printf into a string; longer texts than it holds are cut.
[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...) {
  std::array<char, 1024> buffer{};
  va_list arguments;
  va_start(arguments, pattern);
  const int length = std::vsnprintf(buffer.data(), buffer.size(), pattern, arguments);
  va_end(arguments);
  return length < 0 ? std::string() : std::string(buffer.data());
}

/// To the second.
std::string shortTime(TimeUs time) { return isoTime(time).substr(0, 19) + "Z"; }

unsigned long long number(std::uint64_t value) { return value; }

}  // namespace

nlohmann::ordered_json toJson(const std::vector<RailLine>& rails) {
  Json list = Json::array();
  for (const RailLine& r : rails)
    list.push_back(
        {{"key", r.key},
         {"id", r.id},
         {"heat", r.heat},
         {"section", r.section},
         {"recipe", r.recipe},
         {"line", r.line},
         {"began", isoTime(r.beganUs)},
         {"ended", isoTime(r.endedUs)},
         {"length_m", r.lengthM},
         {"profiles", r.profiles},
         {"verdict", name(r.verdict)},
         {"state", name(r.state)},
         {"worst", r.worst ? Json({{"name", name(*r.worst)}, {"excess_mm", r.worstExcessMm}}) : Json(nullptr)}});
  return {{"rails", list}};
}

std::string toTable(const std::vector<RailLine>& rails) {
  std::string text =
      format("%-8s %-20s %-16s %-12s %-8s %-16s %9s %8s  %-12s %-11s %s\n", "key", "began (UTC)", "rail", "heat",
             "section", "recipe", "length_m", "profiles", "verdict", "state", "worst (beyond limit, mm)");
  for (const RailLine& r : rails) {
    const std::string worst =
        r.worst ? format("%s %+.3f", std::string(name(*r.worst)).c_str(), r.worstExcessMm) : std::string("-");
    text += format("%-8lld %-20s %-16s %-12s %-8s %-16s %9.3f %8llu  %-12s %-11s %s\n", static_cast<long long>(r.key),
                   shortTime(r.beganUs).c_str(), r.id.c_str(), r.heat.c_str(), r.section.c_str(), r.recipe.c_str(),
                   r.lengthM, number(r.profiles), std::string(name(r.verdict)).c_str(),
                   std::string(name(r.state)).c_str(), worst.c_str());
  }
  return text;
}

nlohmann::ordered_json toJson(const StoredRail& rail, std::optional<std::size_t> withPoints) {
  Json json = {{"key", rail.key},
               {"uid", rail.uid},
               {"state", name(rail.state)},
               {"began", isoTime(rail.beganUs)},
               {"ended", isoTime(rail.endedUs)},
               {"line", rail.place.line},
               {"source", rail.place.source},
               {"program", rail.place.program},
               {"machine", rail.place.machine},
               {"strand", rail.papers.strand},
               {"order", rail.papers.orderNumber},
               {"shift", rail.papers.shift},
               {"operator", rail.papers.operatorName},
               {"temperature_c", rail.summary.rail.temperatureC},
               {"calibration", rail.summary.calibrationId},
               {"calibration_warning", rail.summary.calibrationWarning},
               {"profiles_not_stored", rail.notStored}};
  if (withPoints) json["profiles_with_points"] = *withPoints;
  json.update(toJson(InspectedRail{rail.summary, rail.summary.rail.sectionName}));
  for (std::size_t d = 0; d < kDimensionCount; ++d)
    json["dimensions"][d]["excess_mm"] = rail.excessMm[d] ? Json(*rail.excessMm[d]) : Json(nullptr);
  json["stages"] = Json::array();
  for (const StageStatistics& stage : rail.stages) json["stages"].push_back(toJson(stage));
  return json;
}

std::string toTable(const StoredRail& rail, std::size_t withPoints) {
  const RailSummary& s = rail.summary;
  std::string text = toTable(InspectedRail{s, s.rail.sectionName});
  text +=
      format("\n%s %s to %s UTC on %s (%s), heat %s, %.1f degrees C, calibration %s%s%s\n",
             std::string(name(rail.state)).c_str(), shortTime(rail.beganUs).c_str(), shortTime(rail.endedUs).c_str(),
             rail.place.line.c_str(), rail.place.source.c_str(), s.rail.heat.empty() ? "-" : s.rail.heat.c_str(),
             s.rail.temperatureC, s.calibrationId.empty() ? "-" : s.calibrationId.c_str(),
             s.calibrationWarning.empty() ? "" : ": ", s.calibrationWarning.c_str());
  text += format("Triggers: %llu seen = %llu measured + %llu incomplete + %llu lost; points of %llu profiles kept\n",
                 number(s.triggers.seen), number(s.triggers.measured), number(s.triggers.incomplete),
                 number(s.triggers.lost), number(withPoints));
  for (const auto& [reason, count] : s.triggers.reasons) text += format("  %8llu  %s\n", number(count), reason.c_str());
  if (rail.notStored > 0) text += format("%llu profiles were measured but not stored\n", number(rail.notStored));
  return text;
}

nlohmann::ordered_json toJson(const ArchiveCheck& check) {
  Json findings = Json::array();
  for (const ArchiveFinding& f : check.findings) findings.push_back({{"where", f.where}, {"what", f.what}});
  return {{"whole", check.findings.empty()},
          {"findings", findings},
          {"rails", check.rails},
          {"profiles", check.profiles},
          {"profiles_with_points", check.points},
          {"audit", {{"entries", check.auditEntries}, {"head", check.auditHead}, {"digest", check.auditHeadDigest}}}};
}

std::string toTable(const ArchiveCheck& check) {
  std::string text;
  for (const ArchiveFinding& f : check.findings) text += f.where + ": " + f.what + "\n";
  text += format("%s: %llu rails, %llu profiles (%llu with points), %llu entries of the audit trail\n",
                 check.findings.empty() ? "whole" : "NOT WHOLE", number(check.rails), number(check.profiles),
                 number(check.points), number(check.auditEntries));
  if (check.auditEntries > 0) text += "last audit entry: " + check.auditHeadDigest + "\n";
  return text;
}

std::string profilesCsv(const StoredRail& rail, const std::vector<ProfileRecord>& profiles) {
  std::string text = csvHeader();
  ProfileResult result;
  result.rail = std::make_shared<const RailBegin>(rail.summary.rail);
  for (std::size_t i = 0; i < profiles.size(); ++i) {
    const ProfileRecord& p = profiles[i];
    result.profile.trigger = p.trigger;
    result.profile.positionMm = p.positionMm;
    result.profile.missing = p.missing;
    result.profile.overloaded = p.overloaded;
    result.registration.valid = p.registered;
    result.registration.reason = p.whyNotRegistered;
    result.registration.rmsMm = p.rmsMm;
    result.registration.inliers = p.inliers;
    result.measurement.dimensions = p.dimensions;
    text += csvRow(result, i);
  }
  return text;
}

std::string pointsCsv(const Profile& profile) {
  std::string text = "x_mm,y_mm\n";
  for (const ProfilePoint& p : profile.points) text += format("%.6f,%.6f\n", p.x, p.y);
  return text;
}

}  // namespace vignole::cli
