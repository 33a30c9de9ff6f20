#pragma once
// Which of a view's bright lines is the laser's: those of all views lie in one plane, reflections do not.

#include <span>
#include <vector>

#include "calibration/light_plane/plane_fit.h"

namespace vignole {

struct LineChoiceSettings {
  double sigmas = 6;            ///< a line may lie so far off the plane, in its uncertainty
  double distanceShare = 1e-3;  ///< or in its distance from the camera
};

/// For every stripe the index of its line, -1 where none agrees with the plane that most light lies in.
[[nodiscard]] std::vector<int> chooseLines(std::span<const TargetStripe> stripes, const Intrinsics& in,
                                           const LineChoiceSettings& settings);

}  // namespace vignole
