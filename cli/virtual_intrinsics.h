#pragma once
// The intrinsic parameters that a calibration of the virtual rig's cameras would have found.

#include <cstdint>

#include "calibration/intrinsics/calibrated_intrinsics.h"

namespace vignole::cli {

/// The truth disturbed as a good calibration errs, with that covariance: f by 5e-4 of itself, the principal point by
/// 1.5 px, kappa by 3e-3 / f^2 (optics design, section 1.8). Polynomial model: k1 by the same as kappa; k2 by 0.3, k3
/// by 0.1, p1 and p2 by 0.1 of what k1's error does where the corners of the picture are (6.4 mm). Independent of each
/// other. Drawn by the seed and the camera's number. `exact`: the truth, without a covariance.
[[nodiscard]] CalibratedIntrinsics virtualIntrinsics(const RangeFinderCalibration& truth, int camera,
                                                     std::uint64_t seed, bool exact);

}  // namespace vignole::cli
