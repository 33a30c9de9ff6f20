#pragma once
// Which pictures an adjustment may start with, and which say nothing new.

#include "calibration/intrinsics/intrinsics_calibration.h"
#include "calibration/intrinsics/target_adjustment.h"

namespace vignole {

struct TakenViews {
  TargetObservations observations;
  std::vector<std::size_t> source;  ///< of each observed view: its place among all
  Intrinsics like;                  ///< pixel pitch, size of the picture
};

/// Leaves out what the finder refused, pictures of another size, with too few points, mirrored ones, points that the
/// target does not have; `results` gets a line for every view, with the reason.
[[nodiscard]] TakenViews takeViews(const std::vector<TargetView>& views, const PlanarTarget& target,
                                   const IntrinsicsSettings& settings, std::vector<ViewResult>& results);

/// Views whose target stands where an earlier one stood are rejected in `selection`.
void rejectSamePoses(const TargetObservations& observations, const TargetFit& fit,
                     const std::vector<std::string>& names, double samePosePx, Selection& selection);

/// Largest angle between the target's planes of two views that count, degrees.
[[nodiscard]] double tiltDifferenceDeg(const TargetFit& fit, const Selection& selection);

}  // namespace vignole
