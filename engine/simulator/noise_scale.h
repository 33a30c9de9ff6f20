#pragma once
// Noise scaled so that lines are known as well as asked.

#include <vector>

#include "engine/geometry/expected.h"
#include "engine/simulator/line_bound.h"

namespace vignole::simulator {

/// Read noise and speckle contrast times `factor`, the variance of shot noise times its square.
[[nodiscard]] Effects withNoise(const Effects& effects, double factor);

/// The median over the places of the Cramer-Rao bound of a point that 1 px of line gives, along its normal, px.
[[nodiscard]] double medianBoundPx(const std::vector<LineLight>& places, const Effects& effects);

/// The factor at which that median is `boundPx`, to 1e-4 of it. Refused where no factor gives it: rounding to whole DN
/// alone is worse, or the speckle would have to exceed a contrast of 1.
[[nodiscard]] Expected<double> noiseFactorFor(double boundPx, const std::vector<LineLight>& places,
                                              const Effects& effects);

}  // namespace vignole::simulator
