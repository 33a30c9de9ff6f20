#include "engine/quality/control_chart.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vignole {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
/// Efficiency of the mean moving range against s for normal values, asymptotically (Cryer, Ryan 1990).
constexpr double kMovingRangeEfficiency = 0.605;

/// The data in the forms that the charts need.
struct Data {
  std::vector<double> means;
  std::vector<Sample> samples;
  std::size_t n = 0, smallest = 0, largest = 0;
  double mean = 0;  ///< of all values
};

Data dataOf(const std::vector<Subgroup>& subgroups) {
  Data d;
  std::vector<double> all;
  d.smallest = std::numeric_limits<std::size_t>::max();
  for (const Subgroup& g : subgroups) {
    d.samples.push_back(describe(g.values));
    d.means.push_back(d.samples.back().mean);
    d.smallest = std::min(d.smallest, g.values.size());
    d.largest = std::max(d.largest, g.values.size());
    all.insert(all.end(), g.values.begin(), g.values.end());
  }
  d.n = all.size();
  d.mean = meanOf(all);
  return d;
}

Expected<void> check(const std::vector<Subgroup>& subgroups, const Data& data, const ControlChartSettings& settings) {
  if (subgroups.size() < 2) return inputError("", "a control chart needs at least two points");
  const bool individuals = settings.kind == ChartKind::IndividualsMovingRange;
  const bool xbar = settings.kind == ChartKind::XbarR || settings.kind == ChartKind::XbarS;
  for (const Subgroup& g : subgroups) {
    if (g.values.empty()) return inputError("subgroup " + g.name, "has no values");
    if (individuals && g.values.size() > 1)
      return inputError("subgroup " + g.name, "has several values: use an X-bar chart, or leave the subgroups out");
    if (xbar && g.values.size() < 2)
      return inputError("subgroup " + g.name, "has one value: X-bar charts need two or more in every subgroup");
  }
  if (data.largest > 1000) return inputError("", "subgroups of more than 1000 values have no tabulated constants");
  return {};
}

std::vector<double> movingRanges(const std::vector<double>& values) {
  std::vector<double> ranges;
  for (std::size_t i = 1; i < values.size(); ++i) ranges.push_back(std::abs(values[i] - values[i - 1]));
  return ranges;
}

/// Within subgroups, of single values: mean over the subgroups of R / d2(n) or s / c4(n).
void estimateSigma(ControlChart& chart, const Data& data, ConstantPrecision precision, bool byRange) {
  if (data.largest == 1) {
    chart.meanMovingRange = meanOf(movingRanges(data.means));
    chart.sigma = *chart.meanMovingRange / chartConstants(2, precision).d2;
    chart.sigmaDegrees = kMovingRangeEfficiency * static_cast<double>(data.n - 1);
    return;
  }
  std::vector<double> estimates, spreads;
  double inverse = 0;
  for (const Sample& s : data.samples) {
    if (s.n < 2) continue;
    const ChartConstants c = chartConstants(static_cast<int>(s.n), precision);
    spreads.push_back(byRange ? s.range() : s.sd());
    estimates.push_back(spreads.back() / (byRange ? c.d2 : c.c4));
    // Relative variance of this estimate, which 1 / (2 nu) is for s with nu degrees of freedom.
    inverse += byRange ? (c.d3 / c.d2) * (c.d3 / c.d2) : (1 - c.c4 * c.c4) / (c.c4 * c.c4);
  }
  const auto count = static_cast<double>(estimates.size());
  chart.sigma = meanOf(estimates);
  chart.sigmaDegrees = count * count / (2 * inverse);
  (byRange ? chart.meanRange : chart.meanSd) = meanOf(spreads);
}

void beyondLimits(ChartPanel& panel) {
  for (std::size_t i = 0; i < panel.values.size(); ++i)
    if (panel.values[i] > panel.upper[i] || panel.values[i] < panel.lower[i]) panel.signals.push_back({1, i});
}

ChartPanel constantPanel(std::string name, std::vector<double> values, double centre, double lcl, double ucl) {
  ChartPanel p;
  p.name = std::move(name);
  p.lower.assign(values.size(), lcl);
  p.upper.assign(values.size(), ucl);
  p.values = std::move(values);
  p.centre = centre;
  p.lcl = lcl;
  p.ucl = ucl;
  return p;
}

/// Means with limits by the size of each subgroup, and the rules.
ChartPanel locationPanel(const ControlChart& chart, const Data& data, const ControlChartSettings& settings,
                         std::string name) {
  const auto half = [&](std::size_t n) { return settings.sigmas * chart.sigma / std::sqrt(static_cast<double>(n)); };
  ChartPanel p;
  p.name = std::move(name);
  p.values = data.means;
  p.centre = chart.centre;
  p.lcl = chart.centre - half(data.largest);
  p.ucl = chart.centre + half(data.largest);
  std::vector<double> z;
  for (const Sample& s : data.samples) {
    p.lower.push_back(chart.centre - half(s.n));
    p.upper.push_back(chart.centre + half(s.n));
    z.push_back(chart.sigma > 0 ? (s.mean - chart.centre) / chart.sigma * std::sqrt(static_cast<double>(s.n)) : 0.0);
  }
  p.signals = ruleSignals(z, settings.rules, settings.sigmas);
  return p;
}

void individuals(ControlChart& chart, const Data& data, const ControlChartSettings& settings,
                 ConstantPrecision precision) {
  chart.panels.push_back(locationPanel(chart, data, settings, "I"));
  const ChartConstants c = chartConstants(2, precision);
  const double mean = settings.sigma ? c.d2 * *settings.sigma : *chart.meanMovingRange;
  // The tables give D4 for three sigma; other widths come from d3.
  const double upper = settings.sigmas == 3 ? c.d4Limit * mean : mean * (1 + settings.sigmas * c.d3 / c.d2);
  chart.panels.push_back(constantPanel("MR", movingRanges(data.means), mean, 0, upper));
  chart.panels.back().first = 1;
  beyondLimits(chart.panels.back());
  chart.notes.formulas = {"sigma = mean moving range / d2; limits = centre +- L sigma; MR: upper limit D4 mean MR"};
  chart.notes.constants = {{"d2", c.d2}, {"D4", c.d4Limit}};
}

ChartPanel spreadPanel(const ControlChart& chart, const Data& data, const ControlChartSettings& settings,
                       ConstantPrecision precision, bool byRange) {
  ChartPanel p;
  p.name = std::string(byRange ? "R" : "S");
  for (const Sample& s : data.samples) {
    const ChartConstants c = chartConstants(static_cast<int>(s.n), precision);
    const double centre = chart.sigma * (byRange ? c.d2 : c.c4);
    const double sd = chart.sigma * (byRange ? c.d3 : std::sqrt(1 - c.c4 * c.c4));
    const bool tabulated = settings.sigmas == 3;
    const double low =
        tabulated ? centre * (byRange ? c.d3Limit : c.b3Limit) : std::max(0.0, centre - settings.sigmas * sd);
    const double high = tabulated ? centre * (byRange ? c.d4Limit : c.b4Limit) : centre + settings.sigmas * sd;
    p.values.push_back(byRange ? s.range() : s.sd());
    p.lower.push_back(low);
    p.upper.push_back(high);
    if (s.n != data.largest) continue;
    p.centre = centre;
    p.lcl = low;
    p.ucl = high;
  }
  beyondLimits(p);
  return p;
}

void xbar(ControlChart& chart, const Data& data, const ControlChartSettings& settings, ConstantPrecision precision,
          bool byRange) {
  chart.panels.push_back(locationPanel(chart, data, settings, "X-bar"));
  const ChartConstants c = chartConstants(static_cast<int>(data.largest), precision);
  // Of one size and as the tables have it: A2 mean R and A3 mean s, the rounding of the examples included.
  if (data.smallest == data.largest && !settings.sigma && settings.sigmas == 3) {
    ChartPanel& p = chart.panels.back();
    const double half = byRange ? c.a2 * *chart.meanRange : c.a3 * *chart.meanSd;
    p.lcl = chart.centre - half;
    p.ucl = chart.centre + half;
    p.lower.assign(p.values.size(), p.lcl);
    p.upper.assign(p.values.size(), p.ucl);
    std::vector<double> z;
    for (const double v : p.values) z.push_back(half > 0 ? 3 * (v - chart.centre) / half : 0.0);
    p.signals = ruleSignals(z, settings.rules, settings.sigmas);
  }
  chart.panels.push_back(spreadPanel(chart, data, settings, precision, byRange));
  if (byRange) {
    chart.notes.formulas = {"sigma = mean R / d2; X-bar: centre +- A2 mean R; R: D3 mean R, D4 mean R",
                            "subgroups of different size: limits of each from sigma and its n"};
    chart.notes.constants = {{"d2", c.d2}, {"A2", c.a2}, {"D3", c.d3Limit}, {"D4", c.d4Limit}};
  } else {
    chart.notes.formulas = {"sigma = mean s / c4; X-bar: centre +- A3 mean s; S: B3 mean s, B4 mean s",
                            "subgroups of different size: limits of each from sigma and its n"};
    chart.notes.constants = {{"c4", c.c4}, {"A3", c.a3}, {"B3", c.b3Limit}, {"B4", c.b4Limit}};
  }
}

void ewma(ControlChart& chart, const Data& data, const ControlChartSettings& settings) {
  const double lambda = settings.lambda;
  const double sigmaMean = chart.sigma / std::sqrt(static_cast<double>(data.largest));
  const double asymptotic = settings.sigmas * sigmaMean * std::sqrt(lambda / (2 - lambda));
  ChartPanel p = constantPanel("EWMA", {}, chart.centre, chart.centre - asymptotic, chart.centre + asymptotic);
  double value = chart.centre, forgotten = 1;
  for (const double mean : data.means) {
    value = lambda * mean + (1 - lambda) * value;
    forgotten *= (1 - lambda) * (1 - lambda);
    const double half = settings.exactLimits ? asymptotic * std::sqrt(1 - forgotten) : asymptotic;
    p.values.push_back(value);
    p.lower.push_back(chart.centre - half);
    p.upper.push_back(chart.centre + half);
  }
  beyondLimits(p);
  chart.panels.push_back(std::move(p));
  chart.notes.formulas = {"EWMA_i = lambda x_i + (1 - lambda) EWMA_(i-1), EWMA_0 = centre",
                          settings.exactLimits
                              ? "limits = centre +- L sigma sqrt(lambda / (2 - lambda) (1 - (1 - lambda)^(2 i)))"
                              : "limits = centre +- L sigma sqrt(lambda / (2 - lambda)), asymptotic"};
  chart.notes.constants = {{"lambda", lambda}};
}

void cusum(ControlChart& chart, const Data& data, const ControlChartSettings& settings) {
  const double sigmaMean = chart.sigma / std::sqrt(static_cast<double>(data.largest));
  const double k = settings.cusumK * sigmaMean, h = settings.cusumH * sigmaMean;
  std::vector<double> up, down;
  double high = 0, low = 0;
  for (const double mean : data.means) {
    high = std::max(0.0, high + mean - chart.centre - k);
    low = std::max(0.0, low + chart.centre - k - mean);
    up.push_back(high);
    down.push_back(low);
  }
  for (auto& [name, values] : {std::pair{"C+", &up}, std::pair{"C-", &down}}) {
    chart.panels.push_back(constantPanel(name, std::move(*values), 0, 0, h));
    beyondLimits(chart.panels.back());
  }
  chart.notes.formulas = {
      "C+_i = max(0, C+_(i-1) + x_i - centre - k sigma); C-_i = max(0, C-_(i-1) + centre - k sigma - "
      "x_i); signal above h sigma"};
  chart.notes.constants = {{"k", settings.cusumK}, {"h", settings.cusumH}, {"k_sigma", k}, {"h_sigma", h}};
}

}  // namespace

std::size_t ControlChart::signalCount() const {
  std::size_t count = 0;
  for (const ChartPanel& p : panels) count += p.signals.size();
  return count;
}

bool ControlChart::stable() const {
  return std::all_of(panels.begin(), panels.end(),
                     [](const ChartPanel& p) { return p.name == "MR" || p.signals.empty(); });
}

Expected<ControlChart> controlChart(const std::vector<Subgroup>& subgroups, const ControlChartSettings& settings) {
  const Data data = dataOf(subgroups);
  if (auto fit = check(subgroups, data, settings); !fit) return tl::unexpected(fit.error());
  ControlChart chart;
  chart.kind = settings.kind;
  chart.rules = settings.rules;
  chart.n = data.n;
  chart.subgroups = subgroups.size();
  chart.autocorrelation = autocorrelation(data.means);
  estimateSigma(chart, data, settings.constants, settings.kind != ChartKind::XbarS);
  if (settings.sigma) {
    chart.sigma = *settings.sigma;
    chart.sigmaDegrees = kInfinite;
  }
  chart.centre = settings.target.value_or(data.mean);
  switch (settings.kind) {
    case ChartKind::IndividualsMovingRange:
      individuals(chart, data, settings, settings.constants);
      break;
    case ChartKind::XbarR:
      xbar(chart, data, settings, settings.constants, true);
      break;
    case ChartKind::XbarS:
      xbar(chart, data, settings, settings.constants, false);
      break;
    case ChartKind::Ewma:
      ewma(chart, data, settings);
      break;
    case ChartKind::Cusum:
      cusum(chart, data, settings);
      break;
  }
  chart.notes.constants.emplace_back("L", settings.sigmas);
  return chart;
}

}  // namespace vignole
