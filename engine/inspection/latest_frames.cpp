#include "engine/inspection/latest_frames.h"

#include <algorithm>
#include <utility>

namespace vignole {

void LatestFrames::addWatcher() { watchers_.fetch_add(1, std::memory_order_relaxed); }

void LatestFrames::removeWatcher() {
  if (watchers_.fetch_sub(1, std::memory_order_relaxed) == 1) restart();
}

void LatestFrames::restart() {
  for (Camera& camera : cameras_) {
    std::array<Held, kHeld> gone;  // let go of outside the lock: the last owner gives buffers back to their pool
    const std::scoped_lock lock(camera.mutex);
    camera.ring.swap(gone);
    camera.offered = 0;
  }
}

void LatestFrames::offer(const Frame& frame, const StripeResult& stripe, double extractMs) {
  if (!watched() || frame.camera < 0 || frame.camera >= kCameraCount) return;
  Held held = std::make_shared<const ExtractedFrame>(ExtractedFrame{frame, stripe, extractMs});
  Camera& camera = cameras_[static_cast<std::size_t>(frame.camera)];
  {
    const std::scoped_lock lock(camera.mutex);
    // Who stopped watching meanwhile has emptied the ring, or will, behind this lock.
    if (!watched()) return;
    camera.ring[camera.offered++ % kHeld].swap(held);
  }
}

LatestFrames::Held LatestFrames::latest(int camera) const {
  const Camera& from = cameras_[static_cast<std::size_t>(camera)];
  const std::scoped_lock lock(from.mutex);
  return from.offered == 0 ? nullptr : from.ring[(from.offered - 1) % kHeld];
}

LatestFrames::Held LatestFrames::at(int camera, std::uint64_t trigger) const {
  const Camera& from = cameras_[static_cast<std::size_t>(camera)];
  const std::scoped_lock lock(from.mutex);
  const auto found = std::find_if(from.ring.begin(), from.ring.end(),
                                  [&](const Held& held) { return held && held->frame.trigger == trigger; });
  return found == from.ring.end() ? nullptr : *found;
}

std::array<LatestFrames::Held, kCameraCount> LatestFrames::together() const {
  std::array<Held, kCameraCount> newest, result;
  std::uint64_t last = 0;
  for (int c = 0; c < kCameraCount; ++c) {
    newest[static_cast<std::size_t>(c)] = latest(c);
    if (const Held& held = newest[static_cast<std::size_t>(c)]) last = std::max(last, held->frame.trigger);
  }
  std::uint64_t common = last;
  for (const Held& held : newest)
    if (held && held->frame.trigger + kHeld > last) common = std::min(common, held->frame.trigger);
  for (int c = 0; c < kCameraCount; ++c) {
    Held& into = result[static_cast<std::size_t>(c)];
    const Held& own = newest[static_cast<std::size_t>(c)];
    if (own && own->frame.trigger == common)
      into = own;
    else
      into = at(c, common);
  }
  return result;
}

InspectionObserver tapped(InspectionObserver watch, std::shared_ptr<LatestFrames> frames) {
  watch.frameExtracted = [frames = std::move(frames), extracted = std::move(watch.frameExtracted)](
                             const Frame& frame, const StripeResult& stripe, double extractMs) {
    if (extracted) extracted(frame, stripe, extractMs);
    frames->offer(frame, stripe, extractMs);
  };
  return watch;
}

}  // namespace vignole
