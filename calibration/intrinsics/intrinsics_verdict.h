#pragma once
// Whether a calibration may be used: "refused, because ..., do ...", and what is worth knowing otherwise.

#include "calibration/intrinsics/intrinsics_calibration.h"

namespace vignole {

/// Before any adjustment, and where it failed.
[[nodiscard]] std::string refusalForViews(std::size_t usable, const IntrinsicsSettings& settings);
/// After it; `tiltDeg` is the largest angle between two views' planes.
void judgeCalibration(double tiltDeg, const IntrinsicsSettings& settings, IntrinsicsCalibration& calibration);

}  // namespace vignole
