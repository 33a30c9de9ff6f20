#pragma once
// Repeatability as in the paper's section IV (Fig. 9, Table VI; ISO 5725-1): runs of the same rail aligned by length,
// one dimension at a time.

#include <optional>
#include <string>
#include <vector>

#include "engine/geometry/expected.h"
#include "engine/quality/outliers.h"
#include "engine/quality/sample.h"

namespace vignole {

/// One run of the rail; not measured is NaN.
struct RepeatabilityRun {
  std::string name;
  std::vector<double> positionM;
  std::vector<double> valueMm;
};

struct RepeatabilitySettings {
  double sectionM = 10;  ///< stretch over which ranges are averaged (Table VI); (0, 10], (10, 20] ...
  double windowM = 0;    ///< values averaged over windows of this length first; 0: single profiles
  double alpha = 0.05;   ///< of the intervals
};

struct RepeatabilitySection {
  double fromM = 0, toM = 0;
  std::size_t positions = 0;
  double meanRangeMm = 0;
  std::optional<Mandel> consistency;  ///< per run: means and scatter of what deviates from the mean of the runs
};

struct RepeatabilityResult {
  std::vector<std::string> runs;
  std::vector<double> positionM;               ///< where every run has a value
  std::vector<std::vector<double>> valueMm;    ///< [run][position]: Fig. 9a
  std::vector<double> rangeMm;                 ///< per position: Fig. 9b
  std::size_t dropped = 0;                     ///< positions of the first run that another run lacks
  std::vector<RepeatabilitySection> sections;  ///< Table VI
  double meanMm = 0, meanRangeMm = 0, maxRangeMm = 0;
  double srMm = 0;  ///< pooled over the positions
  ValueRange srIntervalMm;
  double degrees = 0;
  double srFromRangeMm = 0;  ///< mean range / d2
  double rMm = 0;            ///< repeatability limit, 2.8 s_r
  std::vector<Sample> perRun;
  double autocorrelation = 0;  ///< of neighbours, of what deviates from the mean of the runs; the interval assumes 0
  std::optional<OutlierTest> grubbsRuns, doubleGrubbsRuns;  ///< means of the runs
  std::optional<OutlierTest> cochranRuns;                   ///< scatter of the runs about their common mean
  std::optional<OutlierTest> cochranPositions;              ///< variance among the runs, position by position
  StudyNotes notes;
};

/// The first run gives the positions; another run has a value there if one of its profiles lies within half the first
/// run's median spacing (the nearest is taken). At least two runs and one common position.
[[nodiscard]] Expected<RepeatabilityResult> repeatabilityStudy(const std::vector<RepeatabilityRun>& runs,
                                                               const RepeatabilitySettings& settings = {});

}  // namespace vignole
