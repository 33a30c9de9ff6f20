#pragma once
// Rules that find patterns on a control chart: Western Electric 1-4 and Nelson 1-8.

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace vignole {

/// Limits: rule 1 alone.
enum class RuleSet { Limits, WesternElectric, Nelson };
[[nodiscard]] std::string_view name(RuleSet rules);
[[nodiscard]] std::optional<RuleSet> ruleSetNamed(std::string_view name);
/// "rule 2 of 3 beyond 2 sigma on one side" ...; rule from 1.
[[nodiscard]] std::string_view describe(RuleSet rules, int rule);

struct RuleSignal {
  int rule = 0;           ///< from 1
  std::size_t index = 0;  ///< the point that completes the pattern
};

/// z: deviations from the centre line in standard deviations of what is plotted. A pattern signals at the point that
/// completes it and at every further point that continues it; where k of m points must lie beyond, that point is one of
/// them (or the m points are the first of the chart). Rule 1: beyond `limitSigmas`. Ordered by point, then by rule.
[[nodiscard]] std::vector<RuleSignal> ruleSignals(std::span<const double> z, RuleSet rules, double limitSigmas = 3);

}  // namespace vignole
