#pragma once
// Capability of a process (Cp, Cpk: spread within subgroups) and its performance (Pp, Ppk: whole spread) with their
// intervals; only where the process is stable, for otherwise they predict nothing.

#include <optional>
#include <vector>

#include "engine/quality/control_chart.h"

namespace vignole {

/// Stability by points beyond the limits alone: the other rules cry wolf on every long series.
[[nodiscard]] inline ControlChartSettings stabilityChart() {
  ControlChartSettings chart;
  chart.rules = RuleSet::Limits;
  return chart;
}

struct CapabilitySettings {
  std::optional<double> lower, upper;             ///< limits of the tolerance; one may be missing, not both
  double alpha = 0.05;                            ///< of the intervals
  double sigmas = 6;                              ///< width that is compared with the tolerance
  ControlChartSettings chart = stabilityChart();  ///< its kind gives the spread within; its signals the stability
  bool evenIfUnstable = false;
};

struct CapabilityIndex {
  double value = 0;
  ValueRange interval;
};

struct CapabilityResult {
  ControlChart chart;
  Sample all;
  bool stable = false;
  double sigmaWithin = 0;
  std::optional<CapabilityIndex> cp, cpk, pp, ppk;  ///< empty: not stable, one limit only (Cp, Pp) or no spread
  std::optional<double> beyondPpm;                  ///< expected outside the tolerance, whole spread, normal
  std::size_t beyond = 0;                           ///< observed outside
  StudyNotes notes;
};

[[nodiscard]] Expected<CapabilityResult> capabilityStudy(const std::vector<Subgroup>& subgroups,
                                                         const CapabilitySettings& settings);

}  // namespace vignole
