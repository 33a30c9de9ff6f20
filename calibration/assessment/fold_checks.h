#pragma once
// Pins and placements that a solution has not seen, and the same plate the other way round: k-fold and plate reversal
// (optics design, section 5).

#include <string>
#include <vector>

#include "calibration/assessment/check.h"
#include "calibration/assessment/pin_centres.h"
#include "calibration/job.h"
#include "calibration/range_finders/rig_adjustment.h"
#include "engine/rail/dimension.h"
#include "engine/rail/section.h"

namespace vignole {

/// One solution without some pins or one placement, and where it puts what was left out.
struct Fold {
  std::string leftOut;  ///< "pins 2 6 10", "placement2"
  PinMisfit misfit;     ///< of the centres from where they should be, by plate, lines and the solution's covariance
  double cdMm = 0;      ///< mean of that distance, over arcs of at least kLeastMetricArcDeg
};

/// `count` folds of the pins, judged against the plate as stated. Error: cancelled.
[[nodiscard]] Expected<std::vector<Fold>> pinFolds(const RigInputs& inputs, const RigAdjustmentSettings& settings,
                                                   const RigAdjustment& whole, int count, const Job& job);
/// One fold a placement, judged against the pins as found by the others, which the placement is laid onto. None with
/// fewer than two placements.
[[nodiscard]] Expected<std::vector<Fold>> placementFolds(const RigInputs& inputs, const RigAdjustmentSettings& settings,
                                                         const RigAdjustment& whole, const Job& job);
/// `what`: "k-fold over pins" ...
[[nodiscard]] Check foldCheck(const std::string& what, const std::vector<Fold>& folds);

/// Placements as they were first and turned by about 180 degrees, each solved by itself: what one measures of a section
/// that the other one sees.
struct Reversal {
  bool done = false;
  std::string why;  ///< not done
  PerDimension<double> differenceMm{};
  PerDimension<double> uMm{};  ///< standard uncertainty of the difference, the two taken as independent
};
[[nodiscard]] Expected<Reversal> plateReversal(const RigInputs& inputs, const RigAdjustmentSettings& settings,
                                               const RigAdjustment& whole, const Section& section,
                                               const DimensionParameters& parameters, const Job& job);
[[nodiscard]] Check reversalCheck(const Reversal& reversal);

}  // namespace vignole
