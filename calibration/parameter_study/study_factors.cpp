#include "calibration/parameter_study/study_factors.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/files/atomic_file.h"
#include "engine/files/toml_reader.h"
#include "engine/stripe/stripe_extractor.h"

namespace vignole {
namespace {

enum class Acts { Always, InPaper, InAdjustment };

/// A factor whose levels are numbers from `min` to `max`.
struct NumberFactor {
  std::string_view name, what;
  double min, max;
  bool whole;
  Acts acts;
  void (*set)(TrialSettings&, double);
};

/// A factor whose levels are words.
struct WordFactor {
  std::string_view name, what;
  std::vector<std::pair<std::string_view, void (*)(TrialSettings&)>> levels;
  Acts acts;
};

const std::vector<NumberFactor>& numberFactors() {
  static const std::vector<NumberFactor> factors{
      {"exposure_ms", "t: exposure of the pictures, ms (placements in folders exposure<NUMBER>ms)", 1e-3, 1e5, false,
       Acts::Always, [](TrialSettings& s, double v) { s.exposureMs = v; }},
      {"sigma_px", "sigma: standard deviation of the Gaussian, px", 1, 8, false, Acts::Always,
       [](TrialSettings& s, double v) { s.lines.stripe.sigma = v; }},
      {"low_dn", "t_l: weaker points are rejected, DN of line contrast", 0.1, 255, false, Acts::Always,
       [](TrialSettings& s, double v) { s.lines.stripe.low = v; }},
      {"high_dn", "t_h: stronger points are accepted, DN of line contrast", 0.1, 255, false, Acts::Always,
       [](TrialSettings& s, double v) { s.lines.stripe.high = v; }},
      {"t_ec", "distance limit for matching an ellipse to a pin, in the paper's coordinates from -1 to 1", 0.01, 2,
       false, Acts::InPaper, [](TrialSettings& s, double v) { s.adjustment.paper.matchDistance = v; }},
      {"max_ellipses", "most ellipses that the pose is computed from", 3, 100, true, Acts::InPaper,
       [](TrialSettings& s, double v) { s.adjustment.paper.maxEllipses = static_cast<int>(v); }},
      {"min_arc_share", "length of a line over the perimeter of its ellipse, at least", 0, 1, false, Acts::InPaper,
       [](TrialSettings& s, double v) { s.adjustment.paper.minArcShare = v; }},
      {"min_axis_ratio", "minor over major axis of an ellipse, at least", 0, 1, false, Acts::InPaper,
       [](TrialSettings& s, double v) { s.adjustment.paper.minAxisRatio = v; }},
      {"end_margin_sigmas", "points closer to an end of a line are left out, in sigmas of the smoothed light", 0, 20,
       false, Acts::InAdjustment, [](TrialSettings& s, double v) { s.adjustment.endMarginSigmas = v; }}};
  return factors;
}

template <EllipseFitVariant variant>
void setFit(TrialSettings& s) {
  s.adjustment.paper.fit = variant;
}
template <RigMethod method>
void setMethod(TrialSettings& s) {
  s.adjustment.method = method;
}
template <IntrinsicsUse use>
void setIntrinsics(TrialSettings& s) {
  s.adjustment.intrinsics = use;
}
template <Centermost centermost>
void setCentermost(TrialSettings& s) {
  s.adjustment.paper.centermost = centermost;
}
template <bool on>
void setFourSteps(TrialSettings& s) {
  s.adjustment.paper.fourSteps = on;
}
template <bool on>
void setUndistort(TrialSettings& s) {
  s.adjustment.paper.undistort = on;
}

const std::vector<WordFactor>& wordFactors() {
  static const std::vector<WordFactor> factors{
      {"fit",
       "variant of the direct least-squares fit of ellipses",
       {{"direct", setFit<EllipseFitVariant::Fitzgibbon>},
        {"stable", setFit<EllipseFitVariant::HalirFlusser>},
        {"normalised", setFit<EllipseFitVariant::Normalised>}},
       Acts::InPaper},
      {"method",
       "how the rig is calibrated",
       {{"paper", setMethod<RigMethod::Paper>},
        {"joint", setMethod<RigMethod::Joint>},
        {"per-camera", setMethod<RigMethod::PerCamera>}},
       Acts::Always},
      {"intrinsics",
       "whether the plate may improve the intrinsic parameters",
       {{"decide", setIntrinsics<IntrinsicsUse::Decide>},
        {"held", setIntrinsics<IntrinsicsUse::Held>},
        {"freed", setIntrinsics<IntrinsicsUse::Freed>}},
       Acts::InAdjustment},
      {"centermost",
       "which ellipse is the centermost: next to the mean of all, or to the middle of the picture",
       {{"mean", setCentermost<Centermost::Mean>}, {"image-centre", setCentermost<Centermost::ImageCentre>}},
       Acts::InPaper},
      {"association",
       "how an ellipse finds its pin: by the paper's four steps, or by the drawing of the rig",
       {{"four-step", setFourSteps<true>}, {"robust", setFourSteps<false>}},
       Acts::InPaper},
      {"undistort",
       "whether points are freed of distortion before ellipses are fitted to them",
       {{"on", setUndistort<true>}, {"off", setUndistort<false>}},
       Acts::InPaper}};
  return factors;
}

template <typename Known>
const Known* find(const std::vector<Known>& known, std::string_view name) {
  const auto at = std::find_if(known.begin(), known.end(), [&](const Known& k) { return k.name == name; });
  return at == known.end() ? nullptr : &*at;
}

std::string number(double value) { return words(FactorLevel(value)); }

std::string range(const NumberFactor& factor) {
  return (factor.whole ? "a whole number from " : "a number from ") + number(factor.min) + " to " + number(factor.max);
}

std::string oneOf(const WordFactor& factor) {
  std::string all;
  for (const auto& [level, set] : factor.levels) all += (all.empty() ? "\"" : ", \"") + std::string(level) + "\"";
  return "one of " + all;
}

std::string knownNames() {
  std::string all;
  for (const NumberFactor& factor : numberFactors()) all += std::string(factor.name) + ", ";
  for (const WordFactor& factor : wordFactors())
    all += std::string(factor.name) + (&factor == &wordFactors().back() ? "" : ", ");
  return all;
}

Expected<void> applyNumber(TrialSettings& settings, const NumberFactor& factor, const FactorLevel& level) {
  const auto* value = std::get_if<double>(&level);
  if (value == nullptr || !(*value >= factor.min && *value <= factor.max) ||
      (factor.whole && *value != std::floor(*value)))
    return inputError(std::string(factor.name), "is " + words(level) + "; give " + range(factor));
  factor.set(settings, *value);
  return {};
}

Expected<void> applyWord(TrialSettings& settings, const WordFactor& factor, const FactorLevel& level) {
  if (const auto* wanted = std::get_if<std::string>(&level))
    for (const auto& [name, set] : factor.levels)
      if (name == *wanted) {
        set(settings);
        return {};
      }
  return inputError(std::string(factor.name), "is " + words(level) + "; give " + oneOf(factor));
}

/// A level as the file has it: text or number by what the factor is.
FactorLevel readLevel(TomlReader& toml, const std::string& key, std::string_view factor) {
  if (const NumberFactor* known = find(numberFactors(), factor))
    return known->whole ? FactorLevel(static_cast<double>(
                              toml.integer(key, static_cast<int>(known->min), static_cast<int>(known->max))))
                        : FactorLevel(toml.number(key, known->min, known->max));
  std::string text = toml.text(key);
  if (const WordFactor* known = find(wordFactors(), factor)) {
    TrialSettings scratch;
    if (!applyWord(scratch, *known, text)) toml.refuse(key, "is " + text + "; give " + oneOf(*known));
  }
  return text;
}

bool isKnown(std::string_view name) {
  return find(numberFactors(), name) != nullptr || find(wordFactors(), name) != nullptr;
}

void refuseUnknown(TomlReader& toml, const std::string& key, std::string_view name) {
  if (!isKnown(name)) toml.refuse(key, "names no factor: " + std::string(name) + "; known are " + knownNames());
}

Factor readFactor(TomlReader& toml, const std::string& at) {
  Factor factor;
  factor.name = toml.text(at + ".name");
  refuseUnknown(toml, at + ".name", factor.name);
  const std::size_t levels = toml.listSize(at + ".levels");
  for (std::size_t i = 0; i < levels; ++i)
    factor.levels.push_back(readLevel(toml, at + ".levels." + std::to_string(i), factor.name));
  return factor;
}

}  // namespace

std::vector<std::string> studyFactorWords() {
  std::vector<std::string> lines;
  for (const NumberFactor& factor : numberFactors())
    lines.push_back(std::string(factor.name) + " (" + range(factor) + "): " + std::string(factor.what));
  for (const WordFactor& factor : wordFactors())
    lines.push_back(std::string(factor.name) + " (" + oneOf(factor) + "): " + std::string(factor.what));
  return lines;
}

Expected<void> applyFactor(TrialSettings& settings, std::string_view factor, const FactorLevel& level) {
  if (const NumberFactor* known = find(numberFactors(), factor)) return applyNumber(settings, *known, level);
  if (const WordFactor* known = find(wordFactors(), factor)) return applyWord(settings, *known, level);
  return inputError(std::string(factor), "is no factor; known are " + knownNames());
}

bool isInert(std::string_view factor, const TrialSettings& settings) {
  const NumberFactor* number = find(numberFactors(), factor);
  const WordFactor* word = find(wordFactors(), factor);
  const Acts acts = number != nullptr ? number->acts : word != nullptr ? word->acts : Acts::Always;
  const bool paper = settings.adjustment.method == RigMethod::Paper;
  return (acts == Acts::InPaper && !paper) || (acts == Acts::InAdjustment && paper);
}

Expected<StudyPlan> parseStudyPlan(std::string_view text, const std::string& nameInErrors) {
  auto toml = TomlReader::parse(text, nameInErrors);
  if (!toml) return tl::unexpected(toml.error());
  StudyPlan plan;
  const std::size_t factors = toml->size("factor");
  if (factors == 0) toml->refuse("factor", "is missing; give a [[factor]] with name and levels");
  for (std::size_t i = 0; i < factors; ++i) plan.factors.push_back(readFactor(*toml, "factor." + std::to_string(i)));
  for (const std::string& name : toml->has("fixed") ? toml->keys("fixed") : std::vector<std::string>()) {
    refuseUnknown(*toml, "fixed." + name, name);
    const auto varied = [&](const Factor& factor) { return factor.name == name; };
    if (std::any_of(plan.factors.begin(), plan.factors.end(), varied))
      toml->refuse("fixed." + name, "is a factor too; leave one of them out");
    plan.fixed.emplace_back(name, readLevel(*toml, "fixed." + name, name));
  }
  plan.design.maxRuns = toml->integer("design.max_runs", 2, 20000, plan.design.maxRuns);
  if (toml->has("design.runs")) plan.design.runs = toml->integer("design.runs", 2, 20000);
  const std::string response = toml->text("analysis.response", std::string(name(plan.analysis.primary)));
  if (const auto named = responseNamed(response)) {
    plan.analysis.primary = *named;
  } else {
    std::string known;
    for (const Response r : kResponses) known += (known.empty() ? "" : ", ") + std::string(name(r));
    toml->refuse("analysis.response", "is " + response + "; give one of " + known);
  }
  plan.analysis.order = toml->boolean("analysis.interactions", true) ? 2 : 1;
  if (auto done = toml->finish(); !done) return tl::unexpected(done.error());
  if (auto design = factorialDesign(plan.factors, plan.design); !design)
    return inputError(nameInErrors, design.error().message());
  return plan;
}

Expected<StudyPlan> loadStudyPlan(const std::filesystem::path& file) {
  const auto text = readFile(file);
  if (!text) return tl::unexpected(text.error());
  return parseStudyPlan(*text, file.string());
}

Expected<TrialSettings> trialSettings(const StudyPlan& plan, const Combination& combination) {
  TrialSettings settings;
  for (const auto& [factor, level] : plan.fixed)
    if (auto done = applyFactor(settings, factor, level); !done) return tl::unexpected(done.error());
  for (std::size_t f = 0; f < plan.factors.size(); ++f) {
    const Factor& factor = plan.factors[f];
    const FactorLevel& level = factor.levels[static_cast<std::size_t>(combination[f])];
    if (auto done = applyFactor(settings, factor.name, level); !done) return tl::unexpected(done.error());
  }
  if (auto stripe = checked(settings.lines.stripe); !stripe)
    return inputError(words(plan.factors, combination), stripe.error().message());
  return settings;
}

}  // namespace vignole
