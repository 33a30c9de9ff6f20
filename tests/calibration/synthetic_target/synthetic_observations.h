#pragma once

#include "calibration/intrinsics/target_adjustment.h"
#include "tests/calibration/synthetic_target/synthetic_views.h"

namespace vignole {

/// The views as the adjustment takes them, weighed by what the finder says.
[[nodiscard]] inline TargetObservations observationsOf(const SyntheticViews& views, const PlanarTarget& target) {
  TargetObservations observations;
  observations.radiusMm = target.diameterMm / 2;
  for (const Point2& p : target.points()) observations.points.emplace_back(p.x(), p.y(), 0);
  for (const TargetView& view : views.views) {
    ObservedView& observed = observations.views.emplace_back();
    for (const FoundPoint& f : view.points) observed.push_back({f.index, f.px, f.uPx, f.uPx});
  }
  return observations;
}

/// Camera and poses as they are, but for the start that an adjustment of the variant would have.
[[nodiscard]] inline TargetFit truthAsStart(const SyntheticViews& views, const PlanarTarget& target,
                                            const Intrinsics& camera, const LensVariant& variant) {
  TargetFit start{asVariant(camera, variant), views.cameraFromTarget, {}, false};
  for (const Point2& p : target.points()) start.points.emplace_back(p.x(), p.y(), 0);
  return start;
}

}  // namespace vignole
