#pragma once
// How well the pins come out (optics design, section 1.6; paper, Table IV).

#include <array>
#include <span>
#include <vector>

#include "calibration/range_finders/arc_adjustment.h"

namespace vignole {

/// Less than a quarter of a circle says little of its radius and centre: such a pin is used for the adjustment but has no
/// CD, RD and PD.
inline constexpr double kLeastMetricArcDeg = 90;

/// One view an arc, whether used or not. World: that of the adjustment.
[[nodiscard]] std::vector<PinView> pinViews(const ArcAdjustment& adjustment, const RigInputs& inputs);

/// Table IV and reprojection of one camera, over its views; of the ridge's scatter nothing is set.
[[nodiscard]] RangeFinderFit fitOf(std::span<const PinView> views, int camera);

[[nodiscard]] SpreadMm spreadOf(std::span<const double> values);

}  // namespace vignole
