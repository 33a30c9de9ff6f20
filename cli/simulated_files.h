#pragma once
// What the subcommands of `simulate` share: pictures rendered and written in parallel, folders.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "cli/console.h"
#include "engine/geometry/expected.h"
#include "engine/geometry/image_view.h"

namespace vignole::cli {

/// A picture that will be a file.
struct PictureJob {
  std::filesystem::path file;
  int widthPx = 0, heightPx = 0;
  std::function<void(const MutableImageView&)> render;
};

/// Renders all and writes them as PNG, on all cores; makes the folders. The first job that fails, in their order, is
/// the error.
[[nodiscard]] Expected<void> writePictures(const std::vector<PictureJob>& jobs, Progress& progress);

[[nodiscard]] Expected<void> makeFolder(const std::filesystem::path& folder);

}  // namespace vignole::cli
