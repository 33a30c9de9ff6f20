#include "gui/stripes/stripe_watch.h"

#include <chrono>
#include <utility>

#include "engine/stripe/stripe_extractor.h"

namespace vignole {

namespace {
using namespace std::chrono_literals;
constexpr auto kEvery = 40ms;  // 25 pictures a second of each camera
}  // namespace

StripeWatch::StripeWatch(std::shared_ptr<LatestFrames> frames, const RigCalibration& calibration,
                         const Section& section, const StripeSettings& inUse)
    : frames_(std::move(frames)) {
  for (int c = 0; c < kCameraCount; ++c)
    optics_[static_cast<std::size_t>(c)] = extractionOptics(calibration, section, c);
  orders_.inUse = inUse;
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

StripeWatch::~StripeWatch() {
  thread_.request_stop();
  thread_.join();
}

void StripeWatch::order(const std::function<void(Orders&)>& change) {
  {
    const std::lock_guard lock(mutex_);
    change(orders_);
    changed_ = true;
  }
  wake_.notify_one();
}

void StripeWatch::setLooking(bool looking) {
  if (looking && !watcher_) watcher_.emplace(frames_);
  if (!looking) watcher_.reset();
  order([&](Orders& o) { o.looking = looking; });
}
void StripeWatch::setFrozen(bool frozen) {
  order([&](Orders& o) {
    o.frozen = frozen;
    o.trigger.reset();
  });
}
void StripeWatch::showTrigger(std::uint64_t trigger, PictureAgain again) {
  order([&](Orders& o) {
    o.frozen = true;
    o.trigger = trigger;
    o.again = std::move(again);
  });
}
void StripeWatch::setInUse(const StripeSettings& settings) {
  order([&](Orders& o) { o.inUse = settings; });
}
void StripeWatch::setTrial(const std::optional<LineTrial>& settings, PictureAgain again) {
  order([&](Orders& o) {
    o.trial = settings;
    if (again) o.again = std::move(again);
  });
}

void StripeWatch::setViewSize(int camera, const QSize& pixels) {
  const auto c = static_cast<std::size_t>(camera);
  {
    const std::lock_guard lock(mutex_);
    if (orders_.sizes[c] == pixels) return;
  }
  order([&](Orders& o) { o.sizes[c] = pixels; });
}

QPolygonF StripeWatch::field(int camera) const {
  QPolygonF polygon;
  for (const PixelPosition& p : optics_[static_cast<std::size_t>(camera)].field)
    polygon << QPointF(static_cast<double>(p.x), static_cast<double>(p.y));
  return polygon;
}

LatestFrames::Held StripeWatch::extracted(int camera, Frame frame, const StripeSettings& settings) const {
  auto taken = std::make_shared<ExtractedFrame>();
  taken->frame = std::move(frame);
  taken->frame.camera = camera;
  StripeExtractor extractor(settings, optics_[static_cast<std::size_t>(camera)]);
  // Once to make its buffers: the time of a frame is told as the engine has it.
  extractor.extract(taken->frame.image, taken->stripe);
  const auto begin = std::chrono::steady_clock::now();
  extractor.extract(taken->frame.image, taken->stripe);
  taken->extractMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  return taken;
}

StripeWatch::PerCamera StripeWatch::ofTrigger(const Orders& orders) const {
  PerCamera found;
  for (int c = 0; c < kCameraCount; ++c) {
    auto& held = found[static_cast<std::size_t>(c)];
    held = frames_->at(c, *orders.trigger);
    if (held || !orders.again) continue;
    if (auto frame = orders.again(c, *orders.trigger, 0)) held = extracted(c, *std::move(frame), orders.inUse);
  }
  return found;
}

std::optional<StripeTrial> StripeWatch::tried(const Orders& orders, const LatestFrames::Held& taken,
                                              double stepPx) const {
  if (!orders.trial) return {};
  Frame frame = taken->frame;
  const int camera = frame.camera;
  if (orders.trial->exposureMs > 0) {
    auto exposed =
        orders.again ? orders.again(camera, frame.trigger, orders.trial->exposureMs) : std::optional<Frame>{};
    if (!exposed) return {};
    frame = *std::move(exposed);
  }
  StripeTrial trial;
  trial.taken = extracted(camera, std::move(frame), orders.trial->stripe);
  trial.figures = stripeFigures(trial.taken->stripe);
  trial.difference = lineDifference(taken->stripe, trial.taken->stripe);
  trial.strokes = strokesOf(trial.taken->stripe, stepPx);
  return trial;
}

void StripeWatch::run(const std::stop_token& stop) {
  PerCamera held;
  Pictures pictures;
  std::optional<std::uint64_t> shown;  // of showTrigger
  while (!stop.stop_requested()) {
    Orders orders;
    bool changed = false;
    {
      std::unique_lock lock(mutex_);
      if (orders_.looking)
        wake_.wait_for(lock, stop, kEvery, [this] { return changed_; });
      else
        wake_.wait(lock, stop, [this] { return orders_.looking; });
      orders = orders_;
      changed = std::exchange(changed_, false);
    }
    if (stop.stop_requested()) return;
    std::array<bool, kCameraCount> fresh{};
    if (orders.trigger && orders.trigger != shown) {
      held = ofTrigger(orders);
      fresh.fill(true);
    } else if (!orders.frozen) {
      const PerCamera now = frames_->together();
      for (std::size_t c = 0; c < now.size(); ++c)
        if (now[c] && now[c] != held[c]) {
          held[c] = now[c];
          fresh[c] = true;
        }
    }
    shown = orders.trigger;
    bool any = false;
    for (std::size_t c = 0; c < held.size(); ++c) {
      if (!fresh[c] && !(changed && held[c])) continue;
      auto picture = std::make_shared<StripePicture>();
      if (held[c]) {
        *picture = stripePicture(held[c], orders.sizes[c]);
        picture->trial = tried(orders, held[c], 2);
      } else {
        picture->camera = static_cast<int>(c);
        picture->trigger = orders.trigger.value_or(0);
      }
      pictures[c] = std::move(picture);
      any = true;
    }
    if (any) pictures_.publish(pictures);
  }
}

}  // namespace vignole
