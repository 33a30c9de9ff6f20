#pragma once
// Blur of a whole picture that changes over it.

#include <vector>

#include "engine/simulator/light_kernels.h"

namespace vignole::simulator {

/// Spreads the canvas' light with the variance (px^2, each axis) given for every pixel, row by row: as heat spreads, so
/// that edges stay where they are. Variances change little from pixel to pixel. Outside the picture the light is that
/// of its border.
void blur(Canvas& canvas, const std::vector<float>& variancePx2);

}  // namespace vignole::simulator
