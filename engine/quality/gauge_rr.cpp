#include "engine/quality/gauge_rr.h"

#include <algorithm>
#include <cmath>

#include "engine/quality/chart_constants.h"
#include "engine/quality/distributions.h"
#include "engine/quality/gauge_cells.h"

namespace vignole {

namespace {

constexpr double kNdcFactor = 1.41;  // the AIAG's sqrt(2)

double real(std::size_t n) { return static_cast<double>(n); }

/// Means of the cells, of their rows and columns.
struct Means {
  std::vector<std::vector<double>> cell;  // [operator][part]
  std::vector<double> operators, parts;
  double whole = 0;
};

Means meansOf(const GaugeCells& cells) {
  Means m;
  m.parts.assign(cells.partsPerOperator(), 0);
  for (const auto& row : cells.values) {
    m.cell.emplace_back();
    for (const auto& trials : row) m.cell.back().push_back(meanOf(trials));
    m.operators.push_back(meanOf(m.cell.back()));
  }
  for (std::size_t p = 0; p < m.parts.size(); ++p) {
    std::vector<double> column;
    for (const auto& row : m.cell) column.push_back(row[p]);
    m.parts[p] = meanOf(column);
  }
  m.whole = meanOf(m.operators);
  return m;
}

double sumOfSquaresWithin(const GaugeCells& cells) {
  double sum = 0;
  for (const auto& row : cells.values)
    for (const auto& trials : row) sum += describe(trials).sumOfSquares;
  return sum;
}

AnovaRow row(std::string source, double degrees, double ss) {
  return {std::move(source), degrees, ss, degrees > 0 ? ss / degrees : 0, {}, {}};
}

void test(AnovaRow& row, const AnovaRow& against) {
  if (!(row.degrees > 0 && against.degrees > 0 && against.ms > 0)) return;
  row.f = row.ms / against.ms;
  row.p = fisherUpperTail(*row.f, row.degrees, against.degrees);
}

/// Negative components are 0.
double sdOf(double variance) { return std::sqrt(std::max(0.0, variance)); }

/// The sums, and every component as a share of the total and of the tolerance.
void complete(GrrResult& result, const GrrSettings& settings) {
  result.grr.sd = std::hypot(result.repeatability.sd, result.reproducibility.sd);
  result.total.sd = std::hypot(result.grr.sd, result.part.sd);
  for (GrrComponent* c : {&result.repeatability, &result.reproducibility, &result.operatorAlone, &result.interaction,
                          &result.grr, &result.part, &result.total}) {
    const double share = result.total.sd > 0 ? c->sd / result.total.sd : 0;
    c->percentStudyVariation = 100 * share;
    c->percentContribution = 100 * share * share;
    if (settings.tolerance) c->percentTolerance = 100 * settings.sigmas * c->sd / *settings.tolerance;
  }
  if (result.grr.sd > 0) {
    result.ndcRaw = kNdcFactor * result.part.sd / result.grr.sd;
    result.ndc = static_cast<int>(std::min(result.ndcRaw, 1e9));
  }
  result.notes.formulas.insert(result.notes.formulas.end(),
                               {"GRR^2 = repeatability^2 + reproducibility^2; total^2 = GRR^2 + part^2",
                                "%contribution = 100 variance / total variance; %study variation = 100 s / s_total; "
                                "%tolerance = 100 n_s s / T",
                                "ndc = 1.41 s_part / s_GRR, truncated"});
  result.notes.constants.emplace_back("n_s", settings.sigmas);
  result.notes.constants.emplace_back("ndc_factor", kNdcFactor);
  if (settings.tolerance) result.notes.constants.emplace_back("T", *settings.tolerance);
}

GrrResult crossedAnova(const GaugeCells& cells, const GrrSettings& settings) {
  const Means m = meansOf(cells);
  const double o = real(cells.operators.size()), p = real(cells.partsPerOperator()), r = real(cells.trials);
  double ssPart = 0, ssOperator = 0, ssInteraction = 0;
  for (const double mean : m.parts) ssPart += o * r * (mean - m.whole) * (mean - m.whole);
  for (std::size_t i = 0; i < m.cell.size(); ++i) {
    ssOperator += p * r * (m.operators[i] - m.whole) * (m.operators[i] - m.whole);
    for (std::size_t j = 0; j < m.parts.size(); ++j) {
      const double rest = m.cell[i][j] - m.operators[i] - m.parts[j] + m.whole;
      ssInteraction += r * rest * rest;
    }
  }
  const double ssWithin = sumOfSquaresWithin(cells);
  AnovaRow part = row("part", p - 1, ssPart), operators = row("operator", o - 1, ssOperator),
           interaction = row("interaction", (o - 1) * (p - 1), ssInteraction),
           within = row("repeatability", o * p * (r - 1), ssWithin);
  test(interaction, within);

  GrrResult result;
  const bool pool = !interaction.p || *interaction.p > settings.alpha;
  AnovaRow error = within, against = interaction;
  if (pool) {
    error = row("repeatability", within.degrees + interaction.degrees, ssWithin + ssInteraction);
    against = error;
    if (o > 1) {
      result.pooledMs = error.ms;
      result.pooledDegrees = error.degrees;
    }
  }
  test(part, against);
  test(operators, against);
  result.repeatability.sd = sdOf(error.ms);
  if (o > 1) result.operatorAlone.sd = sdOf((operators.ms - against.ms) / (p * r));
  if (!pool) result.interaction.sd = sdOf((interaction.ms - within.ms) / r);
  result.reproducibility.sd = std::hypot(result.operatorAlone.sd, result.interaction.sd);
  result.part.sd = sdOf((part.ms - against.ms) / (o * r));
  result.anova = {part, operators, interaction, within,
                  row("total", o * p * r - 1, ssPart + ssOperator + ssInteraction + ssWithin)};
  result.notes.formulas = {
      "crossed random effects: s_repeatability^2 = MS_e; s_operator^2 = (MS_o - MS_po) / (p r); s_po^2 = (MS_po - "
      "MS_e) / r; "
      "s_part^2 = (MS_p - MS_po) / (o r); negative components are 0",
      "interaction pooled with repeatability where p > alpha: MS_po and MS_e are then the pooled mean square"};
  result.notes.constants = {{"alpha", settings.alpha}};
  return result;
}

GrrResult averageRange(const GaugeCells& cells, const GrrSettings&) {
  const Means m = meansOf(cells);
  const std::size_t o = cells.operators.size(), p = cells.partsPerOperator();
  std::vector<double> ranges;
  for (const auto& row : cells.values)
    for (const auto& trials : row) ranges.push_back(describe(trials).range());
  constexpr int kDecimals = 4;  // of the AIAG's table of K1, K2, K3
  const ChartConstants trialConstants = chartConstants(static_cast<int>(cells.trials), ConstantPrecision::Exact);
  AverageRange a;
  a.meanRange = meanOf(ranges);
  a.meanDifference = describe(m.operators).range();
  a.partRange = describe(m.parts).range();
  a.k1 = rounded(1 / trialConstants.d2, kDecimals);
  a.k2 = o > 1 ? rounded(1 / averageRangeConstant(static_cast<int>(o), 1), kDecimals) : 0;
  a.k3 = rounded(1 / averageRangeConstant(static_cast<int>(p), 1), kDecimals);
  a.rangeLimit = rounded(trialConstants.d4Limit, 3) * a.meanRange;
  a.beyond = static_cast<std::size_t>(
      std::count_if(ranges.begin(), ranges.end(), [&](double range) { return range > a.rangeLimit; }));
  GrrResult result;
  result.repeatability.sd = a.meanRange * a.k1;
  const double operators = a.meanDifference * a.k2;
  result.reproducibility.sd =
      sdOf(operators * operators - result.repeatability.sd * result.repeatability.sd / (real(p) * real(cells.trials)));
  result.operatorAlone.sd = result.reproducibility.sd;
  result.part.sd = a.partRange * a.k3;
  result.ranges = a;
  result.notes.formulas = {
      "EV = mean range x K1; AV = sqrt((X_diff K2)^2 - EV^2 / (p r)), 0 where negative; PV = R_p K3",
      "K1 = 1/d2(r); K2, K3 = 1/d2* for one group of operators, of parts"};
  result.notes.constants = {{"K1", a.k1}, {"K2", a.k2}, {"K3", a.k3}, {"D4", rounded(trialConstants.d4Limit, 3)}};
  return result;
}

GrrResult nestedAnova(const GaugeCells& cells, const GrrSettings&) {
  const Means m = meansOf(cells);
  const double o = real(cells.operators.size()), p = real(cells.partsPerOperator()), r = real(cells.trials);
  double ssOperator = 0, ssPart = 0;
  for (std::size_t i = 0; i < m.cell.size(); ++i) {
    ssOperator += p * r * (m.operators[i] - m.whole) * (m.operators[i] - m.whole);
    for (const double mean : m.cell[i]) ssPart += r * (mean - m.operators[i]) * (mean - m.operators[i]);
  }
  const double ssWithin = sumOfSquaresWithin(cells);
  AnovaRow operators = row("operator", o - 1, ssOperator), part = row("part(operator)", o * (p - 1), ssPart),
           within = row("repeatability", o * p * (r - 1), ssWithin);
  test(operators, part);
  test(part, within);
  GrrResult result;
  result.repeatability.sd = sdOf(within.ms);
  result.operatorAlone.sd = sdOf((operators.ms - part.ms) / (p * r));
  result.reproducibility.sd = result.operatorAlone.sd;
  result.part.sd = sdOf((part.ms - within.ms) / r);
  result.anova = {operators, part, within, row("total", o * p * r - 1, ssOperator + ssPart + ssWithin)};
  result.notes.formulas = {
      "nested random effects: s_repeatability^2 = MS_e; s_part^2 = (MS_p(o) - MS_e) / r; s_operator^2 = (MS_o - "
      "MS_p(o)) / "
      "(p r); negative components are 0"};
  return result;
}

}  // namespace

Expected<GrrResult> grrStudy(const std::vector<GaugeReading>& readings, const GrrSettings& settings) {
  const bool nested = settings.method == GrrMethod::Nested;
  const auto cells = gaugeCells(readings, nested);
  if (!cells) return tl::unexpected(cells.error());
  GrrResult result = nested                                       ? nestedAnova(*cells, settings)
                     : settings.method == GrrMethod::AverageRange ? averageRange(*cells, settings)
                                                                  : crossedAnova(*cells, settings);
  result.parts = cells->partsPerOperator();
  result.operators = cells->operators.size();
  result.trials = cells->trials;
  complete(result, settings);
  return result;
}

}  // namespace vignole
