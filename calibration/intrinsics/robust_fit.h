#pragma once
// From nothing to an adjustment that outliers do not touch.

#include "calibration/intrinsics/outliers.h"
#include "calibration/job.h"

namespace vignole {

struct RobustFit {
  TargetFit fit;
  Selection selection;
  double unexplainedPx = 0;  ///< noise beyond the points' own uncertainties, px
};

/// Zhang's start, then the variant by a robust loss, outliers rejected one round after the other, last by plain least
/// squares on what is left. All views have a homography; `like` gives pixel pitch and size of the picture, and
/// `nominalFocalMm` > 0 one more start. Error: no start leads anywhere.
[[nodiscard]] Expected<RobustFit> robustFit(const TargetObservations& observations, const LensVariant& variant,
                                            const Intrinsics& like, double nominalFocalMm,
                                            const OutlierSettings& settings, const Job& job);

/// Outliers judged anew with these settings of the adjustment, from a fit that is near.
void refine(const TargetObservations& observations, const LensVariant& variant, const AdjustmentSettings& adjustment,
            const OutlierSettings& settings, RobustFit& robust);

}  // namespace vignole
