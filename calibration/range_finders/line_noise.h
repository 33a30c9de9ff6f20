#pragma once
// How much the ridge really scatters: the noise of the pictures predicts it, the residuals decide.

#include <span>
#include <vector>

#include "calibration/range_finders/arc_adjustment.h"

namespace vignole {

/// Sets CameraLight::noise of the cameras. With the pins as unknowns all residuals count, less what the unknowns took
/// out of them; with the pins as stated their errors are in the residuals, so only what each arc scatters by about its
/// own circle counts.
void refineNoise(ArcAdjustment& adjustment, std::span<const int> cameras, const ArcFreedom& freedom,
                 const PinPlate& plate, const std::vector<ArcObservation>& arcs);

}  // namespace vignole
