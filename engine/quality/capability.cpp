#include "engine/quality/capability.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/quality/distributions.h"

namespace vignole {

namespace {

/// Spread and mean of the process as an index sees them.
struct Process {
  double mean, sigma, degrees, n;
};

std::optional<CapabilityIndex> spreadIndex(const Process& p, const CapabilitySettings& s) {
  if (!s.lower || !s.upper || !(p.sigma > 0)) return {};
  const double value = (*s.upper - *s.lower) / (s.sigmas * p.sigma);
  if (std::isinf(p.degrees)) return CapabilityIndex{value, {value, value}};
  return CapabilityIndex{value,
                         {value * std::sqrt(chiSquareQuantile(s.alpha / 2, p.degrees) / p.degrees),
                          value * std::sqrt(chiSquareQuantile(1 - s.alpha / 2, p.degrees) / p.degrees)}};
}

std::optional<CapabilityIndex> centredIndex(const Process& p, const CapabilitySettings& s) {
  if (!(p.sigma > 0)) return {};
  double value = std::numeric_limits<double>::infinity();
  if (s.upper) value = std::min(value, (*s.upper - p.mean) / (s.sigmas / 2 * p.sigma));
  if (s.lower) value = std::min(value, (p.mean - *s.lower) / (s.sigmas / 2 * p.sigma));
  const double half = normalQuantile(1 - s.alpha / 2) *
                      std::sqrt(4 / (s.sigmas * s.sigmas * p.n) + value * value / (2 * p.degrees));  // Bissell 1990
  return CapabilityIndex{value, {value - half, value + half}};
}

double expectedBeyondPpm(const Process& p, const CapabilitySettings& s) {
  double share = 0;
  if (s.upper) share += normalProbability((p.mean - *s.upper) / p.sigma);
  if (s.lower) share += normalProbability((*s.lower - p.mean) / p.sigma);
  return 1e6 * share;
}

}  // namespace

Expected<CapabilityResult> capabilityStudy(const std::vector<Subgroup>& subgroups, const CapabilitySettings& settings) {
  if (!settings.lower && !settings.upper) return inputError("", "capability needs a tolerance: one limit at least");
  auto chart = controlChart(subgroups, settings.chart);
  if (!chart) return tl::unexpected(chart.error());
  CapabilityResult result;
  std::vector<double> all;
  for (const Subgroup& g : subgroups) all.insert(all.end(), g.values.begin(), g.values.end());
  result.all = describe(all);
  result.beyond = static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [&](double v) {
    return (settings.upper && v > *settings.upper) || (settings.lower && v < *settings.lower);
  }));
  result.stable = chart->stable();
  result.sigmaWithin = chart->sigma;
  result.chart = std::move(*chart);
  if (result.stable || settings.evenIfUnstable) {
    const auto n = static_cast<double>(result.all.n);
    const Process within{result.all.mean, result.sigmaWithin, result.chart.sigmaDegrees, n};
    const Process whole{result.all.mean, result.all.sd(), n - 1, n};
    result.cp = spreadIndex(within, settings);
    result.cpk = centredIndex(within, settings);
    result.pp = spreadIndex(whole, settings);
    result.ppk = centredIndex(whole, settings);
    if (whole.sigma > 0) result.beyondPpm = expectedBeyondPpm(whole, settings);
  }
  result.notes.formulas = {
      "Cp = T / (n_s sigma_within); Cpk = min(upper - mean, mean - lower) / (n_s/2 sigma_within)",
      "Pp, Ppk: the same with s over all values",
      "interval of Cp, Pp by chi squared; of Cpk, Ppk +- z sqrt(4 / (n_s^2 n) + Cpk^2 / (2 nu)) (Bissell)",
      "stable: no signal by the rules that are named, on the location and the spread of subgroups"};
  result.notes.formulas.insert(result.notes.formulas.end(), result.chart.notes.formulas.begin(),
                               result.chart.notes.formulas.end());
  result.notes.constants = result.chart.notes.constants;
  result.notes.constants.insert(
      result.notes.constants.end(),
      {{"n_s", settings.sigmas}, {"alpha", settings.alpha}, {"nu_within", result.chart.sigmaDegrees}});
  return result;
}

}  // namespace vignole
