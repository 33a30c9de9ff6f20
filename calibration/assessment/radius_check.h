#pragma once
// Radii that are stated wrongly hide in the cameras' places, since each camera sees the pins from one side only; the
// arcs' own curvature tells them.

#include <array>
#include <span>

#include "calibration/assessment/check.h"
#include "calibration/assessment/pin_centres.h"
#include "engine/target/pin_plate.h"

namespace vignole {

/// Of one camera's long arcs: radius by the arc alone minus the stated one, weighted mean.
struct RadiusMisfit {
  int arcs = 0;
  double meanMm = 0;
  double uMm = 0;  ///< standard uncertainty, by points and plate
};
[[nodiscard]] std::array<RadiusMisfit, kCameraCount> radiusMisfits(std::span<const PinPixels> arcs,
                                                                   const RigCalibration& calibration,
                                                                   const PinPlate& plate);
/// "pin radii".
[[nodiscard]] Check radiusCheck(const std::array<RadiusMisfit, kCameraCount>& misfits);

}  // namespace vignole
