#pragma once
// Runs of one rail judged: repeatability (the paper's Fig. 9 and Table VI) and accuracy against a reference (Table V),
// every dimension at once.

#include <optional>
#include <string>
#include <vector>

#include "engine/quality/accuracy.h"
#include "engine/quality/repeatability.h"
#include "gui/quality/measured_runs.h"

namespace vignole {

struct RunsStudySettings {
  double windowM = 0;  ///< values averaged over windows of this length first; 0: single profiles
  /// Stretch over which ranges are averaged; 0: 10 m as in Table VI, or as many tens as give at most six stretches.
  double sectionM = 0;
};

struct DimensionStudy {
  std::optional<RepeatabilityResult> repeatability;
  std::string whyNotRepeatability;  ///< one line
  std::optional<AccuracyResult> accuracy;
  std::string whyNotAccuracy;
  std::optional<double> toleranceMm;   ///< width; of a dimension with one limit the distance of that from nominal
  std::optional<double> sharePercent;  ///< 100 * 6 s_r / tolerance
};

/// Share of the tolerance that a gauge may use up (VDA 5, Q_MS).
inline constexpr double kAllowedSharePercent = 15;
/// Share of |E_n| above 1 among `n` values of a true gauge that is still chance: 4.55 % (beyond 2 u of a normal) and
/// the scatter of that share, one-sided at about 0.5 % since the worst of thirteen dimensions is judged.
[[nodiscard]] double allowedBeyond(std::size_t n);
/// A percentage of the reference says something: not of HF and FC, whose reference is about 0.
[[nodiscard]] bool percentMeans(Dimension dimension);

struct RunsStudy {
  std::vector<std::string> runs;
  std::string reference;  ///< what accuracy is against; empty: nothing
  double sectionM = 10, windowM = 0;
  PerDimension<DimensionStudy> dimensions;

  /// The one that uses up most of its tolerance; empty: none has both limits and figures.
  [[nodiscard]] std::optional<Dimension> worstShare() const;
  /// The one that disagrees with its reference most, measured by what chance allows; empty: no uncertainties are known.
  [[nodiscard]] std::optional<Dimension> worstAgreement() const;
};

/// At least two runs; the error says how many are there. Accuracy also from one.
[[nodiscard]] Expected<RunsStudy> studyRuns(const std::vector<MeasuredRun>& runs, const RunReference& reference,
                                            const PerDimension<ToleranceLimits>& limits,
                                            const RunsStudySettings& settings = {});

}  // namespace vignole
