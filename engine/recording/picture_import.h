#pragma once
// A folder of pictures as a recording of one rail.

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>

#include "engine/geometry/expected.h"
#include "engine/recording/recorded_setup.h"

namespace vignole {

/// The pictures of each trigger; an empty name: that camera has none.
using PictureSeries = std::map<std::uint64_t, std::array<std::filesystem::path, kCameraCount>>;

/// Names that are understood, N a trigger, C a camera from 1: triggerN/cameraC.png (as `simulate rail` writes them),
/// cameraC_N.png, cameraC-N.png, and cameraC.png alone for a single trigger 0; also .pgm, .bmp, .tif, .tiff, .jpg,
/// .jpeg. Other files are left alone. Refuses two pictures for the same place and a folder without any.
[[nodiscard]] Expected<PictureSeries> findPictures(const std::filesystem::path& folder);

struct ImportSettings {
  bool whole = false;
  /// What is missing between the first and the last trigger is recorded as lost; else it is refused.
  bool missingIsLost = false;
  RailBegin rail;  ///< firstTrigger is the series' own
  RecordedSetup setup;
};
/// Pictures must have the size that the calibration says. Written whole or not at all.
[[nodiscard]] Expected<void> importPictures(const PictureSeries& pictures, const ImportSettings& settings,
                                            const std::filesystem::path& file,
                                            const std::function<void(double)>& progress);

}  // namespace vignole
