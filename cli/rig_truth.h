#pragma once
// Cameras as JSON, for the truth beside simulated pictures.

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "engine/geometry/transform2.h"
#include "engine/optics/calibration.h"

namespace vignole::cli {

[[nodiscard]] nlohmann::ordered_json intrinsicsTruth(const Intrinsics& in);
/// {"rotation": 3 x 3, "translation_mm": [x, y, z]}
[[nodiscard]] nlohmann::ordered_json poseTruth(const Extrinsics& pose);
/// All four cameras: serial, intrinsics, pose.
[[nodiscard]] nlohmann::ordered_json rigTruth(const RigCalibration& rig);

/// A ten-thousandth of a pixel is far below what any extraction resolves.
[[nodiscard]] nlohmann::ordered_json pixelsTruth(const std::vector<Point2>& pixels);

}  // namespace vignole::cli
