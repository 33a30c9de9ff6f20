// vignole-cli measure: registers and measures ready-made profiles.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/profile_overlay.h"
#include "engine/measurement/measurement.h"
#include "engine/profile/profile_file.h"
#include "engine/rail/catalogue.h"
#include "engine/registration/rail_matcher.h"

namespace vignole::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::vector<std::string> files;
  std::string rail;
  ProfileFormat format = ProfileFormat::Auto;
  double mmPerUnit = 1;
  double sigmaMm = 0.03;
  std::string json, overlay;
};

/// One file through registration and measurement.
struct MeasuredFile {
  std::string file;
  std::vector<ProfilePoint> points;
  AxisFlip flip;
  Registration registration;
  Measurement measurement;
  std::vector<RailMatch> matches;
};

Json numberOrNull(const std::optional<double>& value) { return value && std::isfinite(*value) ? Json(*value) : Json(); }

Json dimensionsJson(const Measurement& measurement) {
  Json list = Json::array();
  for (const Dimension d : kDimensions) {
    const DimensionResult& r = measurement.dimensions[index(d)];
    Json j = {{"name", name(d)}, {"value_mm", numberOrNull(r.valueMm)}, {"nominal_mm", r.nominalMm}};
    j["deviation_mm"] = r.valueMm ? Json(*r.valueMm - r.nominalMm) : Json();
    j["u_mm"] = r.valueMm ? Json(r.uMm) : Json();
    j["lower_mm"] = numberOrNull(r.lowerMm);
    j["upper_mm"] = numberOrNull(r.upperMm);
    j["points"] = r.points;
    j["verdict"] = name(r.verdict);
    j["reason"] = r.reason;
    if (r.leftMm) j["left_mm"] = *r.leftMm;
    if (r.rightMm) j["right_mm"] = *r.rightMm;
    if (r.secondMm) {
      j[d == Dimension::HF ? "min_mm" : "smallest_mm"] = *r.secondMm;
      j[d == Dimension::HF ? "u_min_mm" : "u_smallest_mm"] = r.secondUMm;
    }
    list.push_back(std::move(j));
  }
  return list;
}

Json poseJson(const Registration& r) {
  if (!r.valid) return {{"x_mm", nullptr}, {"y_mm", nullptr}, {"angle_deg", nullptr}};
  const Transform2& t = r.worldFromSection;
  return {{"x_mm", t.xMm}, {"y_mm", t.yMm}, {"angle_deg", t.angleRad * 180 / 3.14159265358979323846}};
}

Json registrationJson(const MeasuredFile& m, const Section& section) {
  const Registration& r = m.registration;
  const auto ifValid = [&](double value) { return r.valid ? Json(value) : Json(); };
  Json j = {{"rms_mm", ifValid(r.rmsMm)}, {"inliers", r.inliers}, {"points", r.points},
            {"iterations", r.iterations}, {"time_us", r.timeUs},  {"chi2", ifValid(r.chi2)}};
  Json matches = Json::array();
  for (const RailMatch& match : m.matches) matches.push_back({{"rail", match.rail}, {"chi2", match.chi2}});
  j["best_match"] = std::move(matches);
  if (!r.valid) j["reason"] = r.reason;
  if (r.looksLike) {
    Json differing = Json::array();
    for (const std::int16_t k : r.looksLike->primitives)
      differing.push_back(section.primitives[static_cast<std::size_t>(k)].name);
    j["looks_like"] = {{"section", r.looksLike->name},
                       {"chi2", r.looksLike->chi2},
                       {"chi2_of_rail", r.looksLike->chi2OfExpected},
                       {"primitives", std::move(differing)}};
  }
  return j;
}

Json fileJson(const MeasuredFile& m, const Section& section) {
  Json primitives = Json::array();
  for (std::size_t k = 0; k < m.registration.primitives.size(); ++k) {
    const PrimitiveResidual& p = m.registration.primitives[k];
    Json j = {{"name", section.primitives[k].name}, {"points", m.registration.valid ? p.points : 0}};
    const bool known = m.registration.valid && p.points > 0;
    j["rms_mm"] = known ? Json(p.rmsMm) : Json();
    j["mean_mm"] = known ? Json(p.meanMm) : Json();
    primitives.push_back(std::move(j));
  }
  const std::string axes = std::string(m.flip.x ? "x" : "") + (m.flip.y ? "y" : "");
  return {{"file", m.file},
          {"rail", section.name},
          {"flipped_axes", axes},
          {"pose", poseJson(m.registration)},
          {"registration", registrationJson(m, section)},
          {"dimensions", dimensionsJson(m.measurement)},
          {"verdict", name(m.measurement.verdict)},
          {"primitives", std::move(primitives)}};
}

std::string table(const MeasuredFile& m, const Section& section) {
  char line[256];
  const Registration& r = m.registration;
  std::string text = m.file + ": " + section.name;
  if (r.valid) {
    std::snprintf(line, sizeof line, ", %d of %d points within tolerance, rms %.4f mm, chi2 %.2f", r.inliers, r.points,
                  r.rmsMm, r.chi2);
    text += line;
  } else {
    text += ", not registered: " + r.reason;
  }
  if (m.flip.x || m.flip.y) text += std::string(", axes turned: ") + (m.flip.x ? "x" : "") + (m.flip.y ? "y" : "");
  if (!m.matches.empty()) {
    std::snprintf(line, sizeof line, "; best match %s (chi2 %.1f)", m.matches.front().rail.c_str(),
                  m.matches.front().chi2);
    text += line;
  }
  if (!r.valid) return text + "; no dimension is measured\n";
  std::snprintf(line, sizeof line, "\n%-6s %10s %10s %9s %8s %10s %10s %6s  %s\n", "", "value mm", "nominal",
                "deviation", "u", "lower", "upper", "points", "verdict");
  text += line;
  const auto cell = [](const std::optional<double>& v) {
    char number[32] = "-";
    if (v) std::snprintf(number, sizeof number, "%.3f", *v);
    return std::string(number);
  };
  for (const Dimension d : kDimensions) {
    const DimensionResult& x = m.measurement.dimensions[index(d)];
    const auto measured = [&](double v) { return x.valueMm ? std::optional(v) : std::nullopt; };
    std::snprintf(line, sizeof line, "%-6s %10s %10.3f %9s %8s %10s %10s %6d  ", std::string(name(d)).c_str(),
                  cell(x.valueMm).c_str(), x.nominalMm, cell(measured(x.valueMm.value_or(0) - x.nominalMm)).c_str(),
                  cell(measured(x.uMm)).c_str(), cell(x.lowerMm).c_str(), cell(x.upperMm).c_str(), x.points);
    text += line + std::string(name(x.verdict)) + (x.reason.empty() ? "" : ", because " + x.reason) + "\n";
  }
  return text;
}

/// With several profiles each gets its own picture: NAME.svg becomes NAME-profile.svg.
std::filesystem::path overlayPath(const Options& options, const std::string& file) {
  std::filesystem::path path = options.overlay;
  if (options.files.size() > 1)
    path.replace_filename(path.stem().string() + "-" + std::filesystem::path(file).stem().string() +
                          path.extension().string());
  return path;
}

Expected<void> writeOverlay(const Options& options, const Section& section, const MeasuredFile& m) {
  const std::filesystem::path path = overlayPath(options, m.file);
  if (path.extension() == ".svg")
    return writeResult(path.string(), overlaySvg(section, m.points, m.registration, m.measurement));
  const auto png = overlayPng(section, m.points, m.registration, m.measurement);
  if (!png) return tl::unexpected(png.error());
  return writeResult(path.string(), *png);
}

class Measuring {
 public:
  static Expected<Measuring> of(const Section& section) {
    Measuring m(section);
    m.parameters_ = defaultParameters(section);
    if (const auto nominal = nominalDimensions(section, m.parameters_); !nominal)
      return tl::unexpected(nominal.error());
    if (const auto limits = toleranceLimits(section, "X", "A")) m.limits_ = *limits;
    m.measurer_ = std::make_unique<Measurer>(section, m.parameters_, m.limits_, MeasurementSettings{});
    return m;
  }
  Expected<MeasuredFile> measure(const std::string& file, const Options& options) {
    auto points = readProfile(file, {options.format, options.mmPerUnit, options.sigmaMm});
    if (!points) return tl::unexpected(points.error());
    MeasuredFile m;
    m.file = file;
    m.points = std::move(*points);
    m.flip = registerEitherWay(m.points, section_, registrar_, m.registration);
    matcher_.check(m.points, 1, m.registration);
    Profile profile;
    profile.points = m.points;
    measurer_->measure(profile, m.registration, {}, m.measurement);
    m.matches = matcher_.bestMatch(m.points);
    return m;
  }

 private:
  explicit Measuring(const Section& section)
      : section_(section), registrar_(section, {}), matcher_(section, catalogueSections(), {}) {}
  Section section_;
  DimensionParameters parameters_;
  PerDimension<ToleranceLimits> limits_;
  Registrar registrar_;
  RailMatcher matcher_;
  std::unique_ptr<Measurer> measurer_;
};

int run(const Options& options) {
  if (!options.overlay.empty()) {
    const std::string extension = std::filesystem::path(options.overlay).extension().string();
    if (extension != ".svg" && extension != ".png")
      return fail({"--overlay", "'" + options.overlay + "' ends neither in .svg nor in .png"});
  }
  const auto section = findSection(options.rail);
  if (!section) return fail(section.error());
  auto measuring = Measuring::of(*section);
  if (!measuring) return fail(measuring.error());

  int code = kDone;
  Json document = {{"files", Json::array()}};
  for (const std::string& file : options.files) {
    const auto m = measuring->measure(file, options);
    if (!m) {
      code = std::max(code, fail(m.error()));  // the good ones are still done
      continue;
    }
    if (!m->registration.valid || m->measurement.verdict == Verdict::Fail)
      code = std::max(code, static_cast<int>(kVerdictFail));
    if (!options.overlay.empty())
      if (const auto ok = writeOverlay(options, *section, *m); !ok) code = std::max(code, fail(ok.error()));
    document["files"].push_back(fileJson(*m, *section));
    if (options.json.empty())
      if (const auto ok = writeResult("-", table(*m, *section)); !ok) return fail(ok.error());
  }
  if (!options.json.empty() && !document["files"].empty())  // of nothing good there is no result
    if (const auto ok = writeJson(options.json, document); !ok) return fail(ok.error());
  return code;
}

}  // namespace

void addMeasure(CLI::App& app, int& exitCode) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("measure", "Register and measure ready-made profiles (CSV, MiniProf)");
  command->footer(
      "Limits are those of class X, straightness A; u assumes independent points of --sigma.\n"
      "Example: vignole-cli measure head.ban profile.csv --rail 60E1 --json -");
  command->add_option("FILE", options->files, "profiles: two numeric columns, MiniProf .ban, SIMPACK .prr")->required();
  command->add_option("--rail", options->rail, "section of the catalogue, or a section file")->required();
  command
      ->add_option_function<std::string>(
          "--format",
          [options](const std::string& format) {
            options->format = format == "csv"        ? ProfileFormat::Csv
                              : format == "miniprof" ? ProfileFormat::MiniProf
                                                     : ProfileFormat::Auto;
          },
          "auto, csv or miniprof (default auto)")
      ->check(CLI::IsMember({"auto", "csv", "miniprof"}));
  command
      ->add_option_function<std::string>(
          "--units",
          [options](const std::string& unit) { options->mmPerUnit = unit == "m"    ? 1000
                                                                    : unit == "in" ? 25.4
                                                                                   : 1; },
          "mm, m or in (default mm)")
      ->check(CLI::IsMember({"mm", "m", "in"}));
  command->add_option("--sigma", options->sigmaMm, "standard uncertainty of a point, mm (default 0.03)")
      ->check(CLI::Range(1e-5, 10.0));
  command->add_option("--json", options->json, "JSON to a file, or - for stdout");
  command->add_option("--overlay", options->overlay,
                      "picture of points, fitted primitives and dimensions: .svg or .png");
  command->callback([options, &exitCode] { exitCode = run(*options); });
}

}  // namespace vignole::cli
