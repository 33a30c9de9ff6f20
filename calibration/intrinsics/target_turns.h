#pragma once
// A grid without a mark looks the same when it is turned, and the finder may count its points from either end. Where
// the target's own errors are to be estimated, a point has to be the same one in all views.

#include "calibration/intrinsics/target_adjustment.h"

namespace vignole {

/// Turns of a target (by 90, 180, 270 degrees) that bring its points onto themselves.
struct TargetTurn {
  Extrinsics turnedFromTarget;      ///< in its plane
  std::vector<std::size_t> places;  ///< point i comes to lie where point places[i] was
};
[[nodiscard]] std::vector<TargetTurn> turnsOf(const std::vector<Eigen::Vector3d>& points);

/// For each view the turn (index in `turns`, or -1) after which its residuals show the same errors of the target as
/// those of most others; -1 as well where that is not clear beyond chance. The fit takes the target as stated.
[[nodiscard]] std::vector<int> turnedViews(const TargetObservations& observations, const TargetFit& fit,
                                           const std::vector<TargetTurn>& turns);

/// The view's points counted as turned, its pose turned back.
void turn(const TargetTurn& by, ObservedView& view);
void turn(const TargetTurn& by, Extrinsics& cameraFromTarget);

}  // namespace vignole
