#pragma once
// Dark or light spots of elliptical outline: what may be the dots of a target.

#include <vector>

#include "calibration/detection/circle_fit.h"
#include "engine/geometry/image_view.h"

namespace vignole {

/// Spots that stand out from the mean of the window of 2 `halfWindow` + 1 pixels about them, wholly inside the picture;
/// outlines to the pixel only.
[[nodiscard]] std::vector<DotEllipse> dotCandidates(const ImageView& image, bool light, int halfWindow);

/// Adds those that are not there yet (another window may have found them before).
void addNew(const std::vector<DotEllipse>& more, std::vector<DotEllipse>& all);

}  // namespace vignole
