#pragma once
// Control charts: I-MR, X-bar/R, X-bar/S, EWMA, CUSUM (ISO 7870, NIST/SEMATECH e-Handbook 6.3). Profiles of one rail
// are autocorrelated: the subgroup is the rail.

#include <optional>
#include <string>
#include <vector>

#include "engine/geometry/expected.h"
#include "engine/quality/chart_constants.h"
#include "engine/quality/run_rules.h"
#include "engine/quality/sample.h"

namespace vignole {

enum class ChartKind { IndividualsMovingRange, XbarR, XbarS, Ewma, Cusum };

struct ControlChartSettings {
  ChartKind kind = ChartKind::IndividualsMovingRange;
  double sigmas = 3;  ///< control limits in standard deviations of what is plotted
  RuleSet rules = RuleSet::WesternElectric;
  ConstantPrecision constants = ConstantPrecision::Tabulated;
  std::optional<double> target;  ///< centre line; empty: the mean of the data
  std::optional<double> sigma;   ///< of one value; empty: from moving ranges, ranges or standard deviations
  double lambda = 0.3;           ///< EWMA: weight of the newest
  bool exactLimits = false;      ///< EWMA: limits that widen from the start in place of the asymptotic ones
  double cusumK = 0.5;           ///< CUSUM: allowance in sigma
  double cusumH = 5;             ///< CUSUM: decision interval in sigma
};

/// Subgroups in order; individuals are subgroups of one.
struct Subgroup {
  std::string name;
  std::vector<double> values;
};

/// One of the (usually two) curves.
struct ChartPanel {
  std::string name;                          ///< "I", "MR", "X-bar", "R", "S", "EWMA", "C+", "C-"
  std::size_t first = 0;                     ///< subgroup of the first value: 1 for moving ranges
  std::vector<double> values, lower, upper;  ///< a limit per point: they differ where sizes do
  double centre = 0;
  double lcl = 0, ucl = 0;          ///< of subgroups of the usual size; EWMA: asymptotic
  std::vector<RuleSignal> signals;  ///< index from `first`
};

struct ControlChart {
  ChartKind kind = ChartKind::IndividualsMovingRange;
  RuleSet rules = RuleSet::WesternElectric;
  double centre = 0;        ///< of single values
  double sigma = 0;         ///< of single values, within subgroups
  double sigmaDegrees = 0;  ///< effective degrees of freedom of sigma; infinite where it was given
  std::optional<double> meanMovingRange, meanRange, meanSd;
  std::size_t n = 0, subgroups = 0;
  std::vector<ChartPanel> panels;  ///< location first
  double autocorrelation = 0;      ///< of neighbours in the location panel (individuals: of the values)
  StudyNotes notes;

  [[nodiscard]] std::size_t signalCount() const;
  /// No signal in any panel but the moving range (it repeats what the individuals say).
  [[nodiscard]] bool stable() const;
};

/// EWMA and CUSUM run over the means of subgroups. Individuals: subgroups of one value; X-bar charts: of two or more.
[[nodiscard]] Expected<ControlChart> controlChart(const std::vector<Subgroup>& subgroups,
                                                  const ControlChartSettings& settings = {});

}  // namespace vignole
