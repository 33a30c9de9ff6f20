#pragma once
// Placements of the pin plate on disk: a folder of camera1.png ... camera4.png each.

#include <filesystem>
#include <vector>

#include "calibration/job.h"
#include "calibration/range_finders/pin_lines.h"

namespace vignole::cli {

/// The lines on the pins of every picture, not yet associated. Refuses folders that lack a picture and pictures of
/// another size than the camera's.
[[nodiscard]] Expected<std::vector<PlacementLines>> readPlacements(const std::vector<std::string>& folders,
                                                                   const std::array<Intrinsics, kCameraCount>& cameras,
                                                                   const Job& job,
                                                                   const PinLineSettings& settings = {});

}  // namespace vignole::cli
