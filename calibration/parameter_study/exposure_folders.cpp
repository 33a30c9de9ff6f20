#include "calibration/parameter_study/exposure_folders.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <set>
#include <string_view>

#include "engine/optics/calibration.h"

namespace vignole {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPrefix = "exposure", kSuffix = "ms", kCamera = "camera";

std::optional<double> exposureNamed(std::string_view name) {
  if (!name.starts_with(kPrefix) || !name.ends_with(kSuffix) || name.size() <= kPrefix.size() + kSuffix.size())
    return {};
  name.remove_prefix(kPrefix.size());
  name.remove_suffix(kSuffix.size());
  double value = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), value);
  if (error != std::errc() || end != name.data() + name.size() || !std::isfinite(value) || value <= 0) return {};
  return value;
}

/// The path without its folders exposure*ms.
fs::path placeOf(const fs::path& path) {
  fs::path place;
  for (const fs::path& part : path)
    if (!exposureNamed(part.string())) place /= part;
  return place;
}

/// placement2 before placement10: runs of digits are compared as numbers.
bool naturallyBefore(std::string_view a, std::string_view b) {
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (!digit(a[i]) || !digit(b[j])) {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i;
      ++j;
      continue;
    }
    std::uint64_t x = 0, y = 0;
    i = static_cast<std::size_t>(std::from_chars(a.data() + i, a.data() + a.size(), x).ptr - a.data());
    j = static_cast<std::size_t>(std::from_chars(b.data() + j, b.data() + b.size(), y).ptr - b.data());
    if (x != y) return x < y;
  }
  return a.size() - i < b.size() - j;
}

std::vector<fs::path> foldersIn(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    if (it->is_directory(error)) found.push_back(it->path());
  std::sort(found.begin(), found.end());
  return found;
}

bool isPlacement(const fs::path& folder) {
  std::error_code error;
  return fs::exists(folder / "camera1.png", error);
}

void collectPlacements(const fs::path& folder, std::vector<ExposedPlacement>& found) {
  if (isPlacement(folder)) {
    found.push_back({folder, placeOf(folder).lexically_normal().string(), exposureMsOf(folder)});
    return;
  }
  for (const fs::path& below : foldersIn(folder)) {
    const std::string name = below.filename().string();
    if (exposureNamed(name) || name.starts_with("placement")) collectPlacements(below, found);
  }
}

bool isPicture(const fs::path& file) {
  static const std::set<std::string> known{".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff", ".pgm"};
  std::string extension = file.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return known.contains(extension);
}

/// The last camera<NUMBER> of the path: where its digits stand, and the number.
struct CameraWord {
  std::size_t at = 0, length = 0;
  int number = 0;
};
std::optional<CameraWord> cameraIn(const std::string& text) {
  for (std::size_t at = text.rfind(kCamera); at != std::string::npos; at = at == 0 ? at : text.rfind(kCamera, at - 1)) {
    const char* first = text.data() + at + kCamera.size();
    int number = 0;
    const auto [end, error] = std::from_chars(first, text.data() + text.size(), number);
    if (error == std::errc() && number >= 1 && number <= kCameraCount)
      return CameraWord{at, static_cast<std::size_t>(end - text.data()) - at, number};
    if (at == 0) break;
  }
  return {};
}

Expected<ExposedPicture> pictureAt(const fs::path& file) {
  const auto exposure = exposureMsOf(file.parent_path());
  if (!exposure)
    return inputError(file.string(), "lies in no folder exposure<NUMBER>ms: its exposure is not known; name it so");
  std::string scene = placeOf(file).lexically_normal().string();
  const auto camera = cameraIn(scene);
  if (!camera)
    return inputError(file.string(), "has no camera1 to camera4 in its path: whose picture it is, is not known");
  return ExposedPicture{file, scene.replace(camera->at, camera->length, ""), camera->number - 1, *exposure};
}

}  // namespace

std::optional<double> exposureMsOf(const fs::path& path) {
  std::optional<double> found;
  for (const fs::path& part : path)
    if (const auto exposure = exposureNamed(part.string())) found = exposure;
  return found;
}

std::string exposureFolder(double exposureMs) {
  std::array<char, 32> buffer{};
  char* end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), exposureMs).ptr;
  return std::string(kPrefix) + std::string(buffer.data(), end) + std::string(kSuffix);
}

Expected<std::vector<ExposedPlacement>> findPlacements(const std::vector<fs::path>& given) {
  std::vector<ExposedPlacement> found;
  for (const fs::path& folder : given) {
    std::error_code error;
    if (!fs::is_directory(folder, error))
      return inputError(folder.string(), "is no folder; give folders of placements");
    const std::size_t before = found.size();
    collectPlacements(folder, found);
    if (found.size() == before)
      return inputError(folder.string(),
                        "holds no placement: a folder of camera1.png to camera4.png, or such folders named placement* "
                        "below it or below exposure<NUMBER>ms");
  }
  std::stable_sort(found.begin(), found.end(), [](const ExposedPlacement& a, const ExposedPlacement& b) {
    if (a.exposureMs != b.exposureMs) return a.exposureMs < b.exposureMs;
    return naturallyBefore(a.place, b.place);
  });
  for (std::size_t i = 1; i < found.size(); ++i)
    if (found[i].place == found[i - 1].place && found[i].exposureMs == found[i - 1].exposureMs)
      return inputError(found[i].folder.string(), "is given twice");
  return found;
}

Expected<std::vector<ExposedPicture>> findExposedPictures(const std::vector<fs::path>& given) {
  std::vector<fs::path> files;
  for (const fs::path& path : given) {
    std::error_code error;
    if (!fs::exists(path, error)) return inputError(path.string(), "does not exist; give pictures or their folders");
    if (!fs::is_directory(path, error)) {
      files.push_back(path);
      continue;
    }
    const std::size_t before = files.size();
    for (fs::recursive_directory_iterator it(path, error), end; !error && it != end; it.increment(error))
      if (it->is_regular_file(error) && isPicture(it->path())) files.push_back(it->path());
    if (error) return worldError(path.string(), "cannot be searched: " + error.message());
    if (files.size() == before) return inputError(path.string(), "holds no picture");
  }
  std::vector<ExposedPicture> pictures;
  for (const fs::path& file : files) {
    auto picture = pictureAt(file);
    if (!picture) return tl::unexpected(picture.error());
    pictures.push_back(*std::move(picture));
  }
  std::stable_sort(pictures.begin(), pictures.end(), [](const ExposedPicture& a, const ExposedPicture& b) {
    if (a.exposureMs != b.exposureMs) return a.exposureMs < b.exposureMs;
    if (a.scene != b.scene) return naturallyBefore(a.scene, b.scene);
    return a.camera < b.camera;
  });
  return pictures;
}

}  // namespace vignole
