#pragma once
// How much the ridge really scatters: the noise of the pictures predicts it, the residuals decide.

#include <span>
#include <vector>

#include "calibration/range_finders/arc_adjustment.h"

namespace vignole {

/// Sets CameraLight::noise and correlation of the cameras by the residuals of an adjustment that has the pins as
/// unknowns (as stated they would leave their errors in the residuals), less what the unknowns took out of them.
void refineNoise(ArcAdjustment& adjustment, std::span<const int> cameras, const PinPlate& plate,
                 const std::vector<ArcObservation>& arcs);

}  // namespace vignole
