#include "gui/stripes/stripe_watch.h"

#include <chrono>

#include "engine/inspection/inspection.h"
#include "engine/stripe/stripe_extractor.h"

namespace vignole {

namespace {

using namespace std::chrono_literals;
constexpr auto kEvery = 66ms;  // fifteen pictures a second of each camera

ExtractedLine extracted(StripeExtractor& extractor, const ImageView& image) {
  ExtractedLine line;
  const auto begin = std::chrono::steady_clock::now();
  extractor.extract(image, line.stripe);
  line.ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  return line;
}

QImage copied(const ImageView& view) {
  QImage image(view.width, view.height, QImage::Format_Grayscale8);
  for (int row = 0; row < view.height; ++row) std::copy_n(view.row(row), view.width, image.scanLine(row));
  return image;
}

}  // namespace

StripeWatch::StripeWatch(std::shared_ptr<LatestFrames> frames, RigCalibration calibration, Section section,
                         StripeSettings inUse)
    : frames_(std::move(frames)),
      calibration_(std::move(calibration)),
      section_(std::move(section)),
      inUse_(inUse),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

StripeWatch::~StripeWatch() {
  frames_->watched = false;
  thread_.request_stop();
  wake_.notify_all();
  thread_.join();
}

void StripeWatch::setInUse(const StripeSettings& settings) {
  const std::lock_guard lock(mutex_);
  inUse_ = settings;
  changed_ = true;
}
void StripeWatch::setTrial(const std::optional<StripeSettings>& settings) {
  const std::lock_guard lock(mutex_);
  trial_ = settings;
  changed_ = true;
}
void StripeWatch::setFrozen(bool frozen) {
  const std::lock_guard lock(mutex_);
  frozen_ = frozen;
}
void StripeWatch::setLooking(bool looking) {
  frames_->watched = looking;
  const std::lock_guard lock(mutex_);
  looking_ = looking;
}

std::shared_ptr<const StripePicture> StripeWatch::take(int camera) {
  return pictures_[static_cast<std::size_t>(camera)].takeNew();
}

void StripeWatch::run(const std::stop_token& stop) {
  std::array<std::shared_ptr<const Frame>, kCameraCount> held;
  std::array<std::optional<StripeExtractor>, kCameraCount> inUse, trial;
  bool first = true;
  while (!stop.stop_requested()) {
    bool frozen = false, looking = false, changed = false;
    StripeSettings settings;
    std::optional<StripeSettings> tried;
    {
      std::unique_lock lock(mutex_);
      wake_.wait_for(lock, stop, kEvery, [] { return false; });
      frozen = frozen_;
      looking = looking_;
      changed = changed_ || first;
      changed_ = false;
      settings = inUse_;
      tried = trial_;
    }
    first = false;
    if (stop.stop_requested() || !looking) continue;
    for (int c = 0; c < kCameraCount; ++c) {
      const auto i = static_cast<std::size_t>(c);
      if (changed) {
        const StripeOptics optics = extractionOptics(calibration_, section_, c);
        inUse[i].emplace(settings, optics);
        trial[i].reset();
        if (tried) trial[i].emplace(*tried, optics);
      }
      auto fresh = frozen ? nullptr : frames_->cameras[i].takeNew();
      if (fresh)
        held[i] = std::move(fresh);
      else if (!changed)
        continue;
      if (!held[i]) continue;
      StripePicture picture;
      picture.camera = c;
      picture.trigger = held[i]->trigger;
      picture.image = copied(held[i]->image);
      picture.inUse = extracted(*inUse[i], held[i]->image);
      if (trial[i]) picture.trial = extracted(*trial[i], held[i]->image);
      pictures_[i].publish(std::move(picture));
    }
  }
}

}  // namespace vignole
