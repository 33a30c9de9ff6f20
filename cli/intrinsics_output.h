#pragma once
// A calibration of intrinsics as JSON and as text.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "calibration/next_pose/next_pose.h"

namespace vignole::cli {

struct ExportedLens {
  std::string file;
  double maxResidualPx = 0;
};

[[nodiscard]] nlohmann::ordered_json toJson(const IntrinsicsCalibration& calibration,
                                            const std::optional<NextPose>& nextPose,
                                            const std::vector<ExportedLens>& exported);
[[nodiscard]] std::string toTable(const IntrinsicsCalibration& calibration, const std::optional<NextPose>& nextPose);

/// Model, distortion, principal point, focal length: for who converts a lens.
[[nodiscard]] nlohmann::ordered_json lensJson(const Intrinsics& in);

}  // namespace vignole::cli
