#pragma once
// Which calibration of the archive a line is to be started with.

#include <optional>

#include "engine/archive/archive.h"
#include "engine/geometry/expected.h"
#include "engine/optics/calibration.h"

namespace vignole {

/// Whether both are of the same four cameras in the same places: a calibration of another rig measures nothing.
[[nodiscard]] bool ofTheSameRig(const RigCalibration& a, const RigCalibration& b);

/// The one that was put in force last, if it is of the rig that `lines` is of; empty: none was.
[[nodiscard]] Expected<std::optional<RigCalibration>> calibrationInForce(const Archive& archive,
                                                                         const RigCalibration& lines);

}  // namespace vignole
