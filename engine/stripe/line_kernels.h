#pragma once
// What is done to every point of every line, for the best SIMD target of the machine.

#include "engine/stripe/line_points.h"
#include "engine/stripe/line_smoothing.h"

namespace vignole {

/// From ridge and light to width and contrast of the line, and the point's place to third order: fills s2 and strength,
/// corrects x and y. `light` is raised to 1 DN where it is less.
void measureLight(LinePoints& points, float filterVariancePx2);

/// Turns the normals to the side of LinePoints::nx and fills `step`. Wrong for the first and the last point of a line,
/// whose neighbours are on others.
void orientNormals(LinePoints& points);

/// Fills `sigma`: pixel noise and speckle (uncertainty.h).
void setRidgeSigma(LinePoints& points, float gradientNoiseDn, float speckle, float filterVariancePx2);

/// Fills bend, shift and shiftedSigma where there is room for the narrowest window, and 0, 0, sigma elsewhere.
void smoothAlong(LinePoints& points, const LineSmoothing& smoothing);

/// Fills `brightening` from the neighbours up to five places away; 0 where there is no room for them.
void setBrightening(LinePoints& points);

}  // namespace vignole
