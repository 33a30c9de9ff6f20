#include "cli/placement_pictures.h"

#include <array>
#include <optional>

#include "engine/acquisition/picture_file.h"

namespace vignole::cli {

namespace {

namespace fs = std::filesystem;

Expected<fs::path> pictureIn(const fs::path& folder, int camera) {
  std::error_code problem;
  if (!fs::is_directory(folder, problem))
    return inputError(folder.string(), "is no folder; a placement is a folder of camera1.png ... camera4.png");
  const std::string name = "camera" + std::to_string(camera + 1);
  for (const char* extension : {".png", ".tif", ".tiff", ".bmp", ".jpg", ".jpeg", ".pgm"})
    if (const fs::path file = folder / (name + extension); fs::exists(file, problem)) return file;
  return inputError(folder.string(), "lacks " + name + ".png; a placement is a folder of camera1.png ... camera4.png");
}

}  // namespace

Expected<std::vector<PlacementLines>> readPlacements(const std::vector<std::string>& folders,
                                                     const std::array<Intrinsics, kCameraCount>& cameras,
                                                     const Job& job, const PinLineSettings& settings) {
  std::vector<PlacementLines> placements;
  for (std::size_t m = 0; m < folders.size(); ++m) {
    PlacementLines placement;
    placement.folder = folders[m];
    for (int c = 0; c < kCameraCount; ++c) {
      if (job.cancelled()) return cancelledError();
      job.report((static_cast<double>(m) + c / 4.0) / static_cast<double>(folders.size()), "lines on pins");
      const auto file = pictureIn(folders[m], c);
      if (!file) return tl::unexpected(file.error());
      const auto picture = readPicture(*file);
      if (!picture) return tl::unexpected(picture.error());
      const Intrinsics& in = cameras[static_cast<std::size_t>(c)];
      if (picture->width != in.widthPx || picture->height != in.heightPx)
        return inputError(file->string(), "has " + std::to_string(picture->width) + " x " +
                                              std::to_string(picture->height) + " pixels, but camera " +
                                              std::to_string(c + 1) + " is calibrated for " +
                                              std::to_string(in.widthPx) + " x " + std::to_string(in.heightPx));
      PinPicture& found = placement.pictures[static_cast<std::size_t>(c)];
      found = findPinLines(picture->view(), settings);
      found.file = file->string();
    }
    placements.push_back(std::move(placement));
  }
  return placements;
}

}  // namespace vignole::cli
