#pragma once
// Factorial experiments as plans (paper section III-B): which factors take which levels in which run. Pure: no picture
// is known here.

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/geometry/expected.h"

namespace vignole {

/// A number or a name; analysed as a name in any case: no straight line through the levels is assumed.
using FactorLevel = std::variant<double, std::string>;
[[nodiscard]] std::string words(const FactorLevel& level);

struct Factor {
  std::string name;
  std::vector<FactorLevel> levels;  ///< in the order in which they are preferred where they do equally well
};

/// Index of the level of each factor, in the order of the factors.
using Combination = std::vector<int>;

/// Every combination of the levels; the last factor changes fastest.
[[nodiscard]] std::vector<Combination> allCombinations(const std::vector<Factor>& factors);

struct DesignSettings {
  int maxRuns = 256;        ///< more are refused
  std::optional<int> runs;  ///< a fraction of the full design with as many runs; none: the full one
};

struct FactorialDesign {
  std::vector<Factor> factors;
  std::vector<Combination> runs;  ///< the last factor changes fastest
  std::size_t fullRuns = 0;       ///< of the full factorial design
  /// Of a fraction: how much of the full design's information a run yields, ratio of |X'X / n|^(1/p) with the p
  /// parameters of all main effects and two-factor interactions; 1 for the full design.
  double efficiency = 1;
  [[nodiscard]] bool full() const { return runs.size() == fullRuns; }
};

/// Full factorial, or the fraction that is D-optimal for main effects and two-factor interactions (greedy choice, then
/// exchanges; the same for the same factors). Refuses one level, equal levels, a name that appears twice, more runs
/// than the limit, a fraction that cannot tell the effects apart.
[[nodiscard]] Expected<FactorialDesign> factorialDesign(std::vector<Factor> factors,
                                                        const DesignSettings& settings = {});

/// "exposure_ms 10, sigma_px 2".
[[nodiscard]] std::string words(const std::vector<Factor>& factors, const Combination& combination);

}  // namespace vignole
