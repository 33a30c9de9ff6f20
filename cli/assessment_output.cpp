#include "cli/assessment_output.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace vignole::cli {

namespace {

using Json = nlohmann::ordered_json;

Json spreadJson(const SpreadMm& s) { return {{"mean", s.mean}, {"std", s.std}, {"max", s.max}}; }

/// printf into a string.
[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...) {
  std::array<char, 512> buffer{};
  va_list arguments;
  va_start(arguments, pattern);
  const int length = std::vsnprintf(buffer.data(), buffer.size(), pattern, arguments);
  va_end(arguments);
  return length < 0 ? std::string() : std::string(buffer.data());
}

std::string comparisonText(const char* title, const Comparison& comparison) {
  std::string text = format("\n%s\n%-6s %10s %9s\n", title, "mm", "difference", "u");
  for (const Dimension d : kDimensions)
    if (std::isfinite(comparison.differenceMm[index(d)]))
      text += format("%-6s %+10.4f %9.4f\n", std::string(name(d)).c_str(), comparison.differenceMm[index(d)],
                     comparison.uMm[index(d)]);
  for (std::size_t c = 0; c < kCameraCount; ++c) {
    const CameraMovement& m = comparison.cameras[c];
    text += format("camera %zu has moved by x %+.4f mm, y %+.4f mm, %+.4f deg in the light plane\n", c + 1, m.xMm,
                   m.yMm, m.turnDeg);
  }
  return text;
}

}  // namespace

Json checksJson(const std::vector<Check>& checks) {
  Json list = Json::array();
  for (const Check& c : checks)
    list.push_back({{"name", c.name},
                    {"value", c.done ? Json(c.value) : Json(nullptr)},
                    {"limit", c.done ? Json(c.limit) : Json(nullptr)},
                    {"unit", c.unit},
                    {"pass", c.done ? Json(c.pass()) : Json(nullptr)},
                    {"refuses", c.refuses},
                    {"words", c.words},
                    {"remedy", c.remedy}});
  return list;
}

Json uncertaintyJson(const std::vector<DimensionUncertainty>& dimensions, std::size_t most) {
  Json list = Json::array();
  for (const DimensionUncertainty& d : dimensions) {
    Json contributors = Json::array();
    for (std::size_t k = 0; k < std::min(most, d.contributions.size()); ++k)
      contributors.push_back({{"source", d.contributions[k].source}, {"u_mm", d.contributions[k].uMm}});
    list.push_back({{"name", name(d.dimension)}, {"u_mm", d.uMm}, {"contributors", contributors}});
  }
  return list;
}

Json comparisonJson(const Comparison& comparison) {
  Json dimensions = Json::array(), cameras = Json::array();
  for (const Dimension d : kDimensions)
    if (std::isfinite(comparison.differenceMm[index(d)]))
      dimensions.push_back({{"name", name(d)},
                            {"difference_mm", comparison.differenceMm[index(d)]},
                            {"u_mm", comparison.uMm[index(d)]}});
  for (std::size_t c = 0; c < kCameraCount; ++c) {
    const CameraMovement& m = comparison.cameras[c];
    cameras.push_back({{"camera", c + 1},
                       {"x_mm", m.xMm},
                       {"y_mm", m.yMm},
                       {"turn_deg", m.turnDeg},
                       {"centre_mm", m.centreMm},
                       {"pose_deg", m.poseDeg}});
  }
  return {{"dimensions", dimensions}, {"cameras", cameras}};
}

Json seamsJson(const std::vector<PairSeam>& seams) {
  Json list = Json::array();
  for (const PairSeam& s : seams)
    list.push_back({{"cameras", {s.first + 1, s.second + 1}},
                    {"pins", s.pins},
                    {"rms_mm", s.rmsMm},
                    {"expected_mm", s.expectedMm},
                    {"mean_x_mm", s.meanMm.x()},
                    {"mean_y_mm", s.meanMm.y()},
                    {"u_mean_mm", s.uMeanMm}});
  return list;
}

Json foldsJson(const std::vector<Fold>& folds) {
  Json list = Json::array();
  for (const Fold& f : folds)
    list.push_back({{"left_out", f.leftOut},
                    {"views", f.misfit.count()},
                    {"rms_mm", f.misfit.rmsMm()},
                    {"expected_mm", f.misfit.expectedMm()},
                    {"cd_mm", f.cdMm}});
  return list;
}

Json assessmentJson(const RigCalibration& calibration, const ExistingCalibration& judged,
                    const std::optional<Comparison>& withPrevious, const Section& section) {
  const std::vector<std::string> refusals = refusalsOf(judged.checks);
  Json json = {{"version", VIGNOLE_VERSION},
               {"calibration",
                {{"id", calibration.id},
                 {"method", calibration.method},
                 {"created", calibration.created},
                 {"age_days", judged.age.days ? Json(std::round(100 * *judged.age.days) / 100) : Json(nullptr)},
                 {"interval_days", calibration.intervalDays > 0 ? Json(calibration.intervalDays) : Json(nullptr)},
                 {"overdue", judged.age.overdue},
                 {"plate", calibration.plate.empty() ? Json(nullptr) : Json(calibration.plate)}}},
               {"valid", refusals.empty()},
               {"refusals", refusals},
               {"checks", checksJson(judged.checks)}};
  json["cameras"] = Json::array();
  for (std::size_t c = 0; c < kCameraCount; ++c)
    json["cameras"].push_back({{"camera", c + 1},
                               {"cd", spreadJson(judged.cd[c])},
                               {"rd", spreadJson(judged.rd[c])},
                               {"pd", spreadJson(judged.pd[c])}});
  json["seams"] = seamsJson(judged.seams);
  json["placements"] = Json::array();
  for (const Fold& f : judged.placements)
    json["placements"].push_back({{"folder", f.leftOut},
                                  {"pins", f.misfit.count()},
                                  {"rms_mm", f.misfit.rmsMm()},
                                  {"expected_mm", f.misfit.expectedMm()}});
  json["section"] = section.name;
  json["dimension_uncertainty"] = uncertaintyJson(judged.dimensions);
  json["beside_new_calibration"] = comparisonJson(judged.withNew);
  if (withPrevious) json["beside_previous"] = comparisonJson(*withPrevious);
  return json;
}

std::string assessmentText(const RigCalibration& calibration, const ExistingCalibration& judged,
                           const std::optional<Comparison>& withPrevious) {
  std::string text = format("Calibration %s (%s) of %s", calibration.id.c_str(), calibration.method.c_str(),
                            calibration.created.c_str());
  if (judged.age.days) text += format(", %.1f days old", *judged.age.days);
  text += format("\n\n%-8s %8s %8s %8s %8s %8s %8s\n", "mm", "CD mean", "max", "RD mean", "max", "PD mean", "max");
  for (std::size_t c = 0; c < kCameraCount; ++c)
    text += format("camera %zu %8.4f %8.4f %8.4f %8.4f %8.4f %8.4f\n", c + 1, judged.cd[c].mean, judged.cd[c].max,
                   judged.rd[c].mean, judged.rd[c].max, judged.pd[c].mean, judged.pd[c].max);
  text += format("\n%-16s %10s %10s %-5s %s\n", "check", "value", "limit", "", "");
  for (const Check& c : judged.checks) {
    if (c.done)
      text += format("%-16s %10.4f %10.4f %-5s %s", c.name.c_str(), c.value, c.limit, c.unit.c_str(),
                     c.pass() ? "pass  " : "FAIL  ");
    else
      text += format("%-16s %10s %10s %-5s %s", c.name.c_str(), "-", "-", "", "-     ");
    text += c.words + "\n";
  }
  text += format("\n%-6s %9s  %s\n", "mm", "u", "by camera");
  for (const DimensionUncertainty& d : judged.dimensions) {
    text += format("%-6s %9.4f ", std::string(name(d.dimension)).c_str(), d.uMm);
    for (const Contribution& part : d.contributions) text += format(" %s %.4f", part.source.c_str(), part.uMm);
    text += "\n";
  }
  text += comparisonText("Beside a calibration by these placements alone", judged.withNew);
  if (withPrevious) text += comparisonText("The previous calibration beside this one", *withPrevious);
  return text;
}

}  // namespace vignole::cli
