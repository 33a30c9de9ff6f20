#include "engine/simulator/frames_ahead.h"

#include <algorithm>
#include <utility>

#include "engine/acquisition/frame_memory.h"

namespace vignole {

namespace {
constexpr std::size_t kBehind = 4;  ///< triggers
}  // namespace

bool RailSchedule::present(std::uint64_t trigger) const {
  if (railTriggers == 0) return true;
  const std::uint64_t pitch = railTriggers + gapTriggers;
  return trigger % pitch < railTriggers && (rails == 0 || trigger / pitch < rails);
}

std::optional<std::uint64_t> RailSchedule::triggers() const {
  if (railTriggers == 0 || rails == 0) return {};
  return rails * (railTriggers + gapTriggers);
}

/// Memory of frames, used again: pages that were never touched cost more than the frame.
class FramesAhead::Buffers : public std::enable_shared_from_this<Buffers> {
 public:
  explicit Buffers(std::size_t bytes) : bytes_(bytes) {}
  std::shared_ptr<std::uint8_t[]> take() {
    FrameMemory memory;
    {
      const std::lock_guard lock(mutex_);
      if (!free_.empty()) {
        memory = std::move(free_.back());
        free_.pop_back();
      }
    }
    if (!memory) memory = makeFrameMemory(bytes_);
    return {memory.release(), [pool = shared_from_this()](std::uint8_t* back) {
              const std::lock_guard lock(pool->mutex_);
              pool->free_.emplace_back(back);
            }};
  }

 private:
  std::size_t bytes_;
  std::mutex mutex_;
  std::vector<FrameMemory> free_;
};

Expected<std::shared_ptr<FramesAhead>> FramesAhead::create(std::shared_ptr<const VirtualRig> rig,
                                                           const FramesAheadSettings& settings) {
  std::shared_ptr<const VirtualRig> empty;
  if (settings.schedule.railTriggers > 0) {
    VirtualRigSettings without = rig->settings();
    Fault dark;
    dark.kind = "black";
    without.faults.push_back(dark);
    auto made = VirtualRig::create(std::move(without));
    if (!made) return tl::unexpected<Error>(made.error());
    empty = std::move(*made);
  }
  return std::shared_ptr<FramesAhead>(new FramesAhead(std::move(rig), std::move(empty), settings));
}

FramesAhead::FramesAhead(std::shared_ptr<const VirtualRig> rig, std::shared_ptr<const VirtualRig> empty,
                         const FramesAheadSettings& settings)
    : rig_(std::move(rig)), empty_(std::move(empty)), settings_(settings) {
  std::size_t bytes = 0;
  for (const RangeFinderCalibration& finder : rig_->calibration().rangeFinders)
    bytes = std::max(bytes, static_cast<std::size_t>(finder.intrinsics.widthPx) *
                                static_cast<std::size_t>(finder.intrinsics.heightPx));
  buffers_ = std::make_shared<Buffers>(bytes);
  moveTo(0);
  for (int i = 0; i < std::max(1, settings_.threads); ++i)
    threads_.emplace_back([this](const std::stop_token& stop) { render(stop); });
}

FramesAhead::~FramesAhead() {
  for (std::jthread& thread : threads_) thread.request_stop();
  threads_.clear();
}

/// The window begins at that trigger, with what it has of it.
void FramesAhead::moveTo(std::uint64_t first) {
  const std::size_t length = kBehind + std::max<std::size_t>(1, settings_.ahead);
  if (first < first_ || first >= first_ + window_.size() || window_.empty()) {
    window_.clear();
    ++generation_;
  } else {
    window_.erase(window_.begin(), window_.begin() + static_cast<std::ptrdiff_t>(first - first_));
  }
  first_ = first;
  while (window_.size() < length) {
    window_.emplace_back();
    window_.back().cameras.resize(static_cast<std::size_t>(settings_.cameras));
  }
  wanted_.notify_all();
  ready_.notify_all();
}

ProvidedFrame FramesAhead::rendered(int camera, std::uint64_t trigger) const {
  const Intrinsics& in = rig_->calibration().rangeFinders[static_cast<std::size_t>(camera)].intrinsics;
  const std::shared_ptr<std::uint8_t[]> buffer = buffers_->take();
  const MutableImageView image{buffer.get(), in.widthPx, in.heightPx, in.widthPx};
  (settings_.schedule.present(trigger) ? *rig_ : *empty_).render(camera, trigger, image);
  return {image, buffer};
}

void FramesAhead::render(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    const auto open = [this] {
      return std::find_if(window_.begin(), window_.end(),
                          [](const Shown& shown) { return shown.begun < shown.cameras.size(); });
    };
    if (!wanted_.wait(lock, stop, [&] { return open() != window_.end(); })) return;
    const auto shown = open();
    const std::uint64_t trigger = first_ + static_cast<std::uint64_t>(shown - window_.begin());
    const std::uint64_t generation = generation_;
    const std::size_t camera = shown->begun++;
    lock.unlock();
    ProvidedFrame frame = rendered(static_cast<int>(camera), trigger);
    lock.lock();
    if (generation != generation_ || trigger < first_) continue;  // nobody waits for it any more
    Shown& now = window_[trigger - first_];
    now.cameras[camera] = std::move(frame);
    ++now.rendered;
    ready_.notify_all();
  }
}

bool FramesAhead::prepare(std::uint64_t trigger, std::stop_token stop) {
  std::unique_lock lock(mutex_);
  // Those just before stay: their frames may not have been fetched yet.
  const std::uint64_t keep = trigger - std::min<std::uint64_t>(trigger, kBehind);
  const bool known = trigger >= first_ && trigger < first_ + window_.size();
  if (!known || keep > first_) moveTo(known ? keep : trigger);
  const std::uint64_t generation = generation_;
  const auto done = [&] {
    return generation != generation_ || trigger < first_ ||
           window_[trigger - first_].rendered == window_[trigger - first_].cameras.size();
  };
  return ready_.wait(lock, stop, done);
}

ProvidedFrame FramesAhead::frame(int camera, std::uint64_t trigger, std::stop_token stop) {
  if (camera < 0 || camera >= settings_.cameras) return {};
  {
    std::unique_lock lock(mutex_);
    if (trigger >= first_ && trigger < first_ + window_.size()) {
      const ProvidedFrame& known = window_[trigger - first_].cameras[static_cast<std::size_t>(camera)];
      if (!known.image.empty()) return known;
    }
  }
  if (stop.stop_requested()) return {};
  return rendered(camera, trigger);
}

}  // namespace vignole
