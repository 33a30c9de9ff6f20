#pragma once
// Gauge repeatability and reproducibility (AIAG MSA): crossed by analysis of variance or by average and range, nested
// where every part is measured by one operator only. For an automatic gauge the "operator" is a set-up, day or
// calibration.

#include <optional>
#include <string>
#include <vector>

#include "engine/geometry/expected.h"
#include "engine/quality/sample.h"

namespace vignole {

struct GaugeReading {
  std::string part, operatorName;
  double value = 0;
};

enum class GrrMethod { Anova, AverageRange, Nested };

struct GrrSettings {
  GrrMethod method = GrrMethod::Anova;
  double alpha = 0.05;              ///< the interaction is pooled with repeatability where its p is greater
  double sigmas = 6;                ///< study variation in standard deviations (6, or 5.15)
  std::optional<double> tolerance;  ///< T = upper - lower limit
};

struct AnovaRow {
  std::string source;  ///< "part", "operator", "interaction", "part(operator)", "repeatability", "total"
  double degrees = 0, ss = 0, ms = 0;
  std::optional<double> f, p;
};

/// One source of variation.
struct GrrComponent {
  double sd = 0;
  double percentContribution = 0;    ///< of the total variance
  double percentStudyVariation = 0;  ///< of the total standard deviation
  std::optional<double> percentTolerance;
  [[nodiscard]] double variance() const { return sd * sd; }
};

/// What the average-and-range method goes by.
struct AverageRange {
  double meanRange = 0;       ///< over all cells
  double meanDifference = 0;  ///< X_diff: largest minus smallest mean of an operator
  double partRange = 0;       ///< R_p: of the means of the parts
  double k1 = 0, k2 = 0, k3 = 0;
  double rangeLimit = 0;   ///< D4 mean range
  std::size_t beyond = 0;  ///< cells whose range exceeds it
};

struct GrrResult {
  std::size_t parts = 0, operators = 0, trials = 0;  ///< nested: parts of each operator
  GrrComponent repeatability, reproducibility, grr, part, total;
  GrrComponent operatorAlone, interaction;        ///< the two halves of reproducibility (ANOVA)
  double ndcRaw = 0;                              ///< 1.41 PV / GRR
  std::optional<int> ndc;                         ///< truncated, as the AIAG does; empty where GRR is 0
  std::vector<AnovaRow> anova;                    ///< with the interaction
  std::optional<double> pooledMs, pooledDegrees;  ///< repeatability after pooling; empty: not pooled
  std::optional<AverageRange> ranges;
  StudyNotes notes;
};

/// Every cell needs the same number of trials, two or more; the error names the cell that differs. One operator is
/// allowed where crossed: reproducibility is then 0.
[[nodiscard]] Expected<GrrResult> grrStudy(const std::vector<GaugeReading>& readings, const GrrSettings& settings = {});

}  // namespace vignole
