#include "calibration/intrinsics/circle_shift.h"

#include "calibration/detection/circle_centre.h"

namespace vignole {

TargetObservations withoutCircleShift(const TargetObservations& observations, const TargetFit& fit) {
  TargetObservations shifted = observations;
  if (!(observations.radiusMm > 0)) return shifted;
  for (std::size_t v = 0; v < shifted.views.size(); ++v)
    for (Observation& o : shifted.views[v]) {
      const Point2 centre = fit.points[static_cast<std::size_t>(o.point)].head<2>();
      const Point2 shift = circleImageShift(fit.intrinsics, fit.cameraFromTarget[v], centre, observations.radiusMm);
      if (shift.allFinite()) o.px -= shift;
    }
  return shifted;
}

}  // namespace vignole
