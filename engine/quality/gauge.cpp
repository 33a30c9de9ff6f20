#include "engine/quality/gauge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "engine/quality/distributions.h"

namespace vignole {

namespace {

/// Mean against 0; values that do not scatter leave no doubt.
std::pair<double, double> meanTest(const Sample& s, double mean) {
  if (s.n < 2) return {0, 1};
  if (!(s.sumOfSquares > 0)) {
    if (mean == 0) return {0, 1};
    return {std::copysign(std::numeric_limits<double>::infinity(), mean), 0};
  }
  const double t = mean / (s.sd() / std::sqrt(static_cast<double>(s.n)));
  return {t, studentTwoSided(t, s.degrees())};
}

}  // namespace

Expected<Type1Result> type1Study(std::span<const double> values, const Type1Settings& settings) {
  if (values.size() < 2) return inputError("", "a type 1 study needs at least two values; 25 or more are usual");
  std::vector<double> deviations;
  for (const double v : values) deviations.push_back(v - settings.reference);
  const Sample d = describe(deviations);
  Type1Result result;
  result.sample = describe(values);
  result.bias = d.mean;
  result.biasInterval = meanInterval(d, settings.alpha);
  std::tie(result.t, result.p) = meanTest(d, d.mean);
  const double s = d.sd();
  if (settings.tolerance && s > 0) {
    result.cg = settings.kPercent / 100 * *settings.tolerance / (settings.sigmas * s);
    result.cgk = (settings.kPercent / 200 * *settings.tolerance - std::abs(d.mean)) / (settings.sigmas / 2 * s);
    result.percentRepeatability = settings.kPercent / *result.cg;
    if (*result.cgk > 0) result.percentRepeatabilityAndBias = settings.kPercent / *result.cgk;
  }
  result.notes.formulas = {"Cg = K/100 T / (n_s s); Cgk = (K/200 T - |bias|) / (n_s/2 s); bias = mean - reference",
                           "%Var(repeatability) = K / Cg; %Var(repeatability and bias) = K / Cgk",
                           "t = bias / (s / sqrt(n)), n - 1 degrees of freedom, two-sided"};
  result.notes.constants = {{"K_percent", settings.kPercent},
                            {"n_s", settings.sigmas},
                            {"reference", settings.reference},
                            {"alpha", settings.alpha}};
  if (settings.tolerance) result.notes.constants.emplace_back("T", *settings.tolerance);
  return result;
}

Expected<LinearityResult> linearityStudy(std::span<const double> reference, std::span<const double> value,
                                         const LinearitySettings& settings) {
  if (reference.size() != value.size()) return inputError("", "linearity needs pairs of reference and value");
  std::vector<double> bias;
  std::map<double, std::vector<double>> levels;
  for (std::size_t i = 0; i < value.size(); ++i) {
    bias.push_back(value[i] - reference[i]);
    levels[reference[i]].push_back(bias.back());
  }
  const auto line = regress(reference, bias);
  if (!line) return tl::unexpected(line.error());
  LinearityResult result;
  result.line = *line;
  result.bias = describe(bias);
  double within = 0, degrees = 0;
  result.zeroInBand = true;
  for (const auto& [at, values] : levels) {
    LinearityLevel level;
    level.reference = at;
    level.bias = describe(values);
    std::tie(level.t, level.p) = meanTest(level.bias, level.bias.mean);
    level.band = line->band(at, settings.alpha);
    result.zeroInBand = result.zeroInBand && level.band.low <= 0 && level.band.high >= 0;
    within += level.bias.sumOfSquares;
    degrees += level.bias.degrees();
    result.levels.push_back(level);
  }
  result.repeatability = degrees > 0 ? std::sqrt(within / degrees) : 0;
  result.percentLinearity = 100 * std::abs(line->slope);
  if (settings.processVariation) {
    result.linearity = std::abs(line->slope) * *settings.processVariation;
    result.percentBias = 100 * std::abs(result.bias.mean) / *settings.processVariation;
  }
  result.notes.formulas = {
      "bias = value - reference = intercept + slope x reference, least squares",
      "band: line +- t(1 - alpha/2, n - 2) s sqrt(1/n + (x - mean x)^2 / S_xx); acceptable where it "
      "holds 0 at every reference",
      "linearity = |slope| x process variation; %linearity = 100 |slope|",
      "repeatability = s pooled within the references"};
  result.notes.constants = {{"alpha", settings.alpha},
                            {"t", studentQuantile(1 - settings.alpha / 2, static_cast<double>(line->n) - 2)}};
  if (settings.processVariation) result.notes.constants.emplace_back("process_variation", *settings.processVariation);
  return result;
}

}  // namespace vignole
