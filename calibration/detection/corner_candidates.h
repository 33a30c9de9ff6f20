#pragma once
// Saddles of the grey values with two dark and two bright sectors about them: what may be the corners of a chessboard.

#include <vector>

#include "calibration/detection/corner_fit.h"
#include "engine/geometry/image_view.h"

namespace vignole {

/// Squares of 8 px and more. Places to about half a pixel, angles to some degrees; strongest first.
[[nodiscard]] std::vector<Corner> cornerCandidates(const ImageView& image);

}  // namespace vignole
