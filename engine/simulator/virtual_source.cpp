// The virtual rig as a source of frames.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <optional>

#include "engine/acquisition/frame_pool.h"
#include "engine/simulator/hashing.h"
#include "engine/simulator/virtual_rig.h"

namespace vignole {

namespace {

using simulator::Stream;
using Clock = std::chrono::steady_clock;

class VirtualSource final : public FrameSource {
 public:
  VirtualSource(std::shared_ptr<const VirtualRig> rig, const VirtualSourceSettings& settings)
      : rig_(std::move(rig)), settings_(settings) {
    const double count = settings.lengthMm / rig_->settings().spacingMm;
    // A length that is a whole number of spacings but for rounding has that many triggers.
    triggersPerRail_ = static_cast<std::uint64_t>(std::max(0.0, std::floor(count + 1e-9)));
    for (std::size_t i = 0; i < kCameraCount; ++i) {
      const Intrinsics& in = rig_->calibration().rangeFinders[i].intrinsics;
      streams_[i].pool =
          std::make_shared<FramePool>(std::max<std::size_t>(1, settings.buffers),
                                      static_cast<std::size_t>(in.widthPx) * static_cast<std::size_t>(in.heightPx));
    }
  }

  FrameMessage next(int camera, std::stop_token stop) override {
    Stream_& stream = streams_[static_cast<std::size_t>(camera)];
    while (!stop.stop_requested() && stream.rail < settings_.rails) {
      const std::uint64_t first = static_cast<std::uint64_t>(stream.rail) * triggersPerRail_;
      if (!stream.begun) {
        stream.begun = true;
        stream.trigger = first;
        return begin(stream.rail, first);
      }
      if (stream.trigger >= first + triggersPerRail_) {
        if (!waitForTrigger(first + triggersPerRail_, stop)) break;
        ++stream.rail;
        stream.begun = false;
        return RailEnd{first + triggersPerRail_};
      }
      if (auto message = take(camera, stream.trigger, stop)) {
        ++stream.trigger;
        return *std::move(message);
      }
      if (stop.stop_requested()) break;
      ++stream.trigger;  // missed: only the count tells
    }
    return SourceEnd{};
  }

  [[nodiscard]] bool live() const override { return settings_.paced; }

 private:
  struct Stream_ {  // NOLINT: Stream is the kind of random numbers
    std::shared_ptr<FramePool> pool;
    int rail = 0;
    bool begun = false;
    std::uint64_t trigger = 0;
  };

  [[nodiscard]] RailBegin begin(int rail, std::uint64_t firstTrigger) const {
    const VirtualRigSettings& s = rig_->settings();
    RailBegin begin;
    begin.id = "V" + std::to_string(s.seed) + "-" + std::to_string(rail + 1);
    begin.heat = "virtual-" + std::to_string(s.seed);
    begin.sectionName = s.section.name;
    begin.firstTrigger = firstTrigger;
    begin.spacingMm = s.spacingMm;
    begin.lengthMm = settings_.lengthMm;
    begin.speedMmPerS = s.speedMmPerS;
    begin.temperatureC = s.temperatureC;
    begin.temperatureUncertaintyC = 0;  // rendered, so known exactly
    return begin;
  }

  /// The message of a trigger, or nothing where there is none (missed, or stopped).
  std::optional<FrameMessage> take(int camera, std::uint64_t trigger, const std::stop_token& stop) {
    if (!waitForTrigger(trigger, stop)) return {};
    if (const Fault* slow = fault("slow", camera, trigger)) pause(slow->value / 1000, stop);
    if (stop.stop_requested() || drawn("missed-trigger", Stream::Missed, camera, trigger)) return {};
    if (cameraDead(rig_->settings().faults, camera, trigger)) return FrameLost{camera, trigger, "camera gone"};
    if (drawn("frame-loss", Stream::Loss, camera, trigger)) return FrameLost{camera, trigger, "frame lost"};

    // A camera in real time writes over what nobody took: as many frames behind as there are buffers are lost.
    std::optional<Clock::time_point> patience;
    if (settings_.paced) {
      patience = due(trigger + settings_.buffers);
      if (Clock::now() > *patience) return FrameLost{camera, trigger, "queue overflow"};
    }
    const std::shared_ptr<std::uint8_t[]> buffer =
        streams_[static_cast<std::size_t>(camera)].pool->take(stop, patience);
    if (!buffer) {
      if (stop.stop_requested()) return {};
      return FrameLost{camera, trigger, "queue overflow"};
    }
    const Intrinsics& in = rig_->calibration().rangeFinders[static_cast<std::size_t>(camera)].intrinsics;
    const MutableImageView image{buffer.get(), in.widthPx, in.heightPx, in.widthPx};
    rig_->render(camera, trigger, image);
    return Frame{camera, trigger, image, buffer};
  }

  [[nodiscard]] const Fault* fault(std::string_view kind, int camera, std::uint64_t trigger) const {
    return activeFault(rig_->settings().faults, kind, camera, trigger);
  }
  [[nodiscard]] bool drawn(std::string_view kind, Stream stream, int camera, std::uint64_t trigger) const {
    const Fault* f = fault(kind, camera, trigger);
    if (f == nullptr) return false;
    // A trigger that was missed was missed by the cameras that the fault names, each by itself.
    simulator::Draws draws(rig_->settings().seed, stream, {static_cast<std::uint64_t>(camera), trigger});
    return draws.uniform() < f->value;
  }
  /// Real time begins with the first trigger that anybody asks for.
  Clock::time_point due(std::uint64_t trigger) {
    const std::lock_guard lock(startMutex_);
    if (!start_) start_ = Clock::now();
    const double periodS = rig_->settings().spacingMm / rig_->settings().speedMmPerS;
    return *start_ + std::chrono::duration_cast<Clock::duration>(
                         std::chrono::duration<double>(static_cast<double>(trigger) * periodS));
  }
  bool waitForTrigger(std::uint64_t trigger, const std::stop_token& stop) {
    if (settings_.paced) waitUntil(due(trigger), stop);
    return !stop.stop_requested();
  }
  static void pause(double seconds, const std::stop_token& stop) {
    waitUntil(Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds)), stop);
  }
  static void waitUntil(Clock::time_point time, const std::stop_token& stop) {
    std::mutex mutex;
    std::condition_variable_any never;
    std::unique_lock lock(mutex);
    never.wait_until(lock, stop, time, [] { return false; });
  }

  std::shared_ptr<const VirtualRig> rig_;
  VirtualSourceSettings settings_;
  std::uint64_t triggersPerRail_ = 0;
  std::array<Stream_, kCameraCount> streams_;
  std::mutex startMutex_;
  std::optional<Clock::time_point> start_;
};

}  // namespace

std::unique_ptr<FrameSource> makeVirtualSource(std::shared_ptr<const VirtualRig> rig,
                                               const VirtualSourceSettings& settings) {
  return std::make_unique<VirtualSource>(std::move(rig), settings);
}

}  // namespace vignole
