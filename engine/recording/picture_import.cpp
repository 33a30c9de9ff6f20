#include "engine/recording/picture_import.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include "engine/acquisition/picture_file.h"
#include "engine/inspection/inspection.h"
#include "engine/recording/chunk.h"
#include "engine/recording/recording_writer.h"
#include "engine/recording/sparse_frame.h"
#include "engine/stripe/stripe_extractor.h"

namespace vignole {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kMostTriggers = 10'000'000;

std::optional<std::uint64_t> numberOf(std::string_view digits) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (digits.empty() || error != std::errc() || end != digits.data() + digits.size()) return {};
  return number;
}

bool isPicture(const fs::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  constexpr std::array<std::string_view, 7> kKnown = {".png", ".pgm", ".bmp", ".tif", ".tiff", ".jpg", ".jpeg"};
  return std::find(kKnown.begin(), kKnown.end(), extension) != kKnown.end();
}

struct Place {
  std::size_t camera = 0;
  std::optional<std::uint64_t> trigger;  ///< empty: the name does not say
};

/// "camera2", "camera2_17", "camera2-17"
std::optional<Place> placeOf(std::string_view stem) {
  constexpr std::string_view kCamera = "camera";
  if (!stem.starts_with(kCamera) || stem.size() <= kCamera.size()) return {};
  const char digit = stem[kCamera.size()];
  if (digit < '1' || digit >= '1' + kCameraCount) return {};
  Place place{static_cast<std::size_t>(digit - '1'), {}};
  const std::string_view rest = stem.substr(kCamera.size() + 1);
  if (rest.empty()) return place;
  if (rest.front() != '_' && rest.front() != '-') return {};
  place.trigger = numberOf(rest.substr(1));
  return place.trigger ? std::optional(place) : std::nullopt;
}

Expected<void> take(const fs::path& file, std::optional<std::uint64_t> triggerOfFolder, PictureSeries& series) {
  const auto place = isPicture(file) ? placeOf(file.stem().string()) : std::nullopt;
  if (!place || (triggerOfFolder && place->trigger)) return {};
  fs::path& to = series[triggerOfFolder.value_or(place->trigger.value_or(0))][place->camera];
  if (!to.empty())
    return inputError(file.string(), "is the same camera and trigger as " + to.string() + "; remove one");
  to = file;
  return {};
}

/// In the order of their names, so that the same folder gives the same errors.
std::vector<fs::path> sorted(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder, failed)) entries.push_back(entry.path());
  std::sort(entries.begin(), entries.end());
  return entries;
}

std::string cameraName(std::size_t camera) { return "camera " + std::to_string(camera + 1); }

/// The first picture that is not there.
Expected<void> checkComplete(const PictureSeries& pictures) {
  std::uint64_t expected = pictures.begin()->first;
  for (const auto& [trigger, cameras] : pictures) {
    const std::string remedy = "; add it, or let --missing lost count what is missing as lost";
    if (trigger != expected)
      return inputError(cameras[0].parent_path().string(),
                        "has no pictures of trigger " + std::to_string(expected) + remedy);
    for (std::size_t c = 0; c < kCameraCount; ++c)
      if (cameras[c].empty()) {
        const auto any = std::find_if(cameras.begin(), cameras.end(), [](const fs::path& p) { return !p.empty(); });
        return inputError(any->parent_path().string(),
                          "has no picture of " + cameraName(c) + " at trigger " + std::to_string(trigger) + remedy);
      }
    ++expected;
  }
  return {};
}

class Importer {
 public:
  Importer(RecordingWriter& writer, const ImportSettings& settings) : writer_(writer), settings_(settings) {
    for (int camera = 0; camera < kCameraCount; ++camera)
      extractors_.emplace_back(settings.setup.recipe.stripe,
                               extractionOptics(settings.setup.calibration, settings.setup.recipe.section, camera));
  }

  Expected<void> add(std::size_t camera, std::uint64_t trigger, const fs::path& file) {
    ChunkHead head{.kind = ChunkKind::Lost, .camera = static_cast<std::uint8_t>(camera), .trigger = trigger};
    if (file.empty()) return written(writer_.append(head, "no picture"));
    const auto picture = readPicture(file);
    if (!picture) return tl::unexpected(picture.error());
    const Intrinsics& in = settings_.setup.calibration.rangeFinders.at(camera).intrinsics;
    if (picture->width != in.widthPx || picture->height != in.heightPx)
      return inputError(file.string(), "has " + std::to_string(picture->width) + " x " +
                                           std::to_string(picture->height) + " pixels but the calibration of " +
                                           cameraName(camera) + " is for " + std::to_string(in.widthPx) + " x " +
                                           std::to_string(in.heightPx) + "; give the cameras' calibration");
    extractors_[camera].extract(picture->view(), stripe_);
    packer_.pack(picture->view(), settings_.whole ? FrameKind::Whole : FrameKind::Sparse, bytes_);
    head.kind = ChunkKind::Frame;
    head.digest = digest_.of(stripe_);
    return written(writer_.append(head, bytes_));
  }

  Expected<void> written(bool good) {
    if (good) return {};
    return worldError(writer_.part().string(), "cannot be written: " + writer_.failure());
  }

 private:
  RecordingWriter& writer_;
  const ImportSettings& settings_;
  std::vector<StripeExtractor> extractors_;
  StripeResult stripe_;
  StripeDigest digest_;
  FramePacker packer_;
  PackedBytes bytes_;
};

Expected<void> writeAll(const PictureSeries& pictures, const ImportSettings& settings, RecordingWriter& writer,
                        const std::function<void(double)>& progress) {
  Importer importer(writer, settings);
  const std::uint64_t first = pictures.begin()->first, end = pictures.rbegin()->first + 1;
  if (auto done = importer.written(writer.append({.kind = ChunkKind::Setup}, toJson(settings.setup))); !done)
    return done;
  RecordedRailBegin begin{settings.rail, {}};
  begin.rail.firstTrigger = first;
  const auto toAll = [&](ChunkKind kind, std::uint64_t trigger, const std::string& text) {
    bool good = true;
    for (std::uint8_t camera = 0; camera < kCameraCount; ++camera)
      good = writer.append({.kind = kind, .camera = camera, .trigger = trigger}, text) && good;
    return importer.written(good);
  };
  if (auto done = toAll(ChunkKind::RailBegin, first, toJson(begin)); !done) return done;
  for (std::uint64_t trigger = first; trigger < end; ++trigger) {
    const auto found = pictures.find(trigger);
    for (std::size_t camera = 0; camera < kCameraCount; ++camera)
      if (auto done = importer.add(camera, trigger, found == pictures.end() ? fs::path() : found->second.at(camera));
          !done)
        return done;
    progress(static_cast<double>(trigger - first) / static_cast<double>(end - first));
  }
  return toAll(ChunkKind::RailEnd, end, {});
}

}  // namespace

Expected<PictureSeries> findPictures(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) return inputError(folder.string(), "is no folder; give a folder of pictures");
  PictureSeries series;
  for (const fs::path& entry : sorted(folder)) {
    constexpr std::string_view kTrigger = "trigger";
    const std::string name = entry.filename().string();
    const auto trigger =
        name.starts_with(kTrigger) ? numberOf(std::string_view(name).substr(kTrigger.size())) : std::nullopt;
    if (!fs::is_directory(entry, ignored)) {
      if (auto done = take(entry, {}, series); !done) return tl::unexpected(done.error());
    } else if (trigger) {
      for (const fs::path& file : sorted(entry))
        if (auto done = take(file, trigger, series); !done) return tl::unexpected(done.error());
    }
  }
  if (series.empty())
    return inputError(folder.string(),
                      "holds no pictures named triggerN/cameraC.png, cameraC_N.png or camera1.png ... camera4.png");
  if (series.rbegin()->first - series.begin()->first >= kMostTriggers)
    return inputError(folder.string(), "has triggers from " + std::to_string(series.begin()->first) + " to " +
                                           std::to_string(series.rbegin()->first) + ", which is too far for one rail");
  return series;
}

Expected<void> importPictures(const PictureSeries& pictures, const ImportSettings& settings, const fs::path& file,
                              const std::function<void(double)>& progress) {
  if (pictures.empty()) return inputError(file.string(), "has nothing to be made of");
  if (!settings.missingIsLost)
    if (auto complete = checkComplete(pictures); !complete) return complete;
  auto writer = RecordingWriter::create(file);
  if (!writer) return tl::unexpected(writer.error());
  auto done = writeAll(pictures, settings, **writer, progress);
  if (done) done = (*writer)->commit();
  if (!done) (*writer)->discard();
  return done;
}

}  // namespace vignole
