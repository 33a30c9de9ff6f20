#pragma once
// Pictures taken at several exposures: a folder named exposure<NUMBER>ms on the way to a picture tells its exposure
// (DIR/exposure7.5ms/placement1/camera1.png, as `simulate plate --exposure` writes them).

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/geometry/expected.h"

namespace vignole {

/// Of the innermost folder that is named so; none: the path does not tell.
[[nodiscard]] std::optional<double> exposureMsOf(const std::filesystem::path& path);
/// "exposure7.5ms".
[[nodiscard]] std::string exposureFolder(double exposureMs);

/// A placement of the plate: a folder of camera1.png ... camera4.png.
struct ExposedPlacement {
  std::filesystem::path folder;
  std::string place;  ///< what is left of the path without its exposure: the same placement at another exposure
  std::optional<double> exposureMs;
};

/// `given`: placements, or folders that hold them in folders exposure*/placement* or placement*. By exposure, then
/// place in natural order (placement2 before placement10). Refuses a folder without any.
[[nodiscard]] Expected<std::vector<ExposedPlacement>> findPlacements(const std::vector<std::filesystem::path>& given);

/// A picture of one camera in some scene (a frame of a rail, a placement).
struct ExposedPicture {
  std::filesystem::path file;
  std::string scene;  ///< what is left of the path without its exposure and camera
  int camera = 0;     ///< 0..3, from the last "camera<NUMBER>" in the path
  double exposureMs = 0;
};

/// `given`: pictures, or folders that are searched for them. In the order of exposure, scene, camera. Refuses a picture
/// whose path tells no exposure or no camera, and folders without pictures.
[[nodiscard]] Expected<std::vector<ExposedPicture>> findExposedPictures(
    const std::vector<std::filesystem::path>& given);

}  // namespace vignole
