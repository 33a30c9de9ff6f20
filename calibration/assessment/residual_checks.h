#pragma once
// Whether what an adjustment leaves is noise: residuals along the arcs (optics design, section 5: residual whiteness).

#include <array>
#include <vector>

#include "calibration/assessment/check.h"
#include "calibration/range_finders/rig_adjustment.h"

namespace vignole {

/// Of one camera's residuals, taken so far apart along their arcs that they share no error of the line filter.
struct ResidualStatistics {
  int samples = 0;
  double autocorrelation = 0;   ///< of neighbours, 0 for noise
  double uAutocorrelation = 0;  ///< standard uncertainty of that for noise
  double runsZ = 0;             ///< runs of one sign more than expected, in standard deviations; few: < 0
  double beyond3 = 0;           ///< share beyond three (robust) standard deviations; 0.0027 for normal noise
  double noiseRatio = 0;        ///< scatter over what the pictures' noise gives
};
[[nodiscard]] std::array<ResidualStatistics, kCameraCount> residualStatistics(const RigAdjustment& adjustment);

/// "residual whiteness", "residual runs", "residual distribution", "residual noise": each of the worst camera.
[[nodiscard]] std::vector<Check> residualChecks(const RigAdjustment& adjustment);

}  // namespace vignole
