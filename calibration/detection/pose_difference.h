#pragma once
// How differently two pictures show a target: what a calibration gains from the second one.

#include <optional>
#include <span>
#include <vector>

#include "calibration/detection/target_finder.h"

namespace vignole {

/// Over the points that both pictures show, px.
struct PoseDifference {
  double movedPx = 0;     ///< root mean square of the points' shifts
  double reshapedPx = 0;  ///< the same, of what no shift, turn and scaling takes away: another tilt or distance
  double sizePx = 0;      ///< root mean square of the points' distances from their middle
  [[nodiscard]] double moved() const { return movedPx / sizePx; }
  [[nodiscard]] double reshaped() const { return reshapedPx / sizePx; }
};
/// Nothing where they share fewer than 4 points. A pattern that looks the same upside down may be numbered from either
/// end; the numbering that differs less counts.
[[nodiscard]] std::optional<PoseDifference> poseDifference(const TargetView& a, const TargetView& b,
                                                           const PlanarTarget& target);

/// For every view the first one before it that shows the same pose, points moved by less than `leastMoved` of the
/// target's size; -1: none. Views that are of no use are left out.
[[nodiscard]] std::vector<int> samePose(std::span<const TargetView> views, const PlanarTarget& target,
                                        double leastMoved = 0.01);
/// What a view that repeats another is refused with.
[[nodiscard]] std::string samePoseRefusal(const TargetView& other);

}  // namespace vignole
