#pragma once
// The latest pictures of the four cameras with the lines that the engine found in them, for whoever looks: nobody
// waits, no pixel is copied, and while nobody looks it costs one test a frame.

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>

#include "engine/acquisition/frame.h"
#include "engine/inspection/inspection.h"
#include "engine/optics/calibration.h"
#include "engine/stripe/stripe.h"

namespace vignole {

struct ExtractedFrame {
  Frame frame;  ///< its buffer is kept from the source's pool as long as this lives
  StripeResult stripe;
  double extractMs = 0;
};

/// Any number of threads may offer, ask and watch.
class LatestFrames {
 public:
  /// Buffers of each camera that are kept from the source's pool while somebody watches: a pool needs more.
  static constexpr std::size_t kHeld = 8;
  using Held = std::shared_ptr<const ExtractedFrame>;

  /// Frames are held while anybody watches; the last to leave lets go of them all. See FramesWatcher.
  void addWatcher();
  void removeWatcher();
  [[nodiscard]] bool watched() const { return watchers_.load(std::memory_order_relaxed) > 0; }
  void restart();  ///< before another source, whose triggers count from 0 again: what is held is let go
  /// Kept if somebody watches; frames of one camera come in order.
  void offer(const Frame& frame, const StripeResult& stripe, double extractMs);

  /// Null: none is held.
  [[nodiscard]] Held latest(int camera) const;
  [[nodiscard]] Held at(int camera, std::uint64_t trigger) const;
  /// Of the newest trigger that all cameras hold which have delivered lately; a camera that stays behind by all that is
  /// held is lost and waited for no longer. Null where a camera has no picture of it.
  [[nodiscard]] std::array<Held, kCameraCount> together() const;

 private:
  struct Camera {
    mutable std::mutex mutex;
    std::array<Held, kHeld> ring;
    std::uint64_t offered = 0;
  };
  std::atomic<int> watchers_ = 0;
  std::array<Camera, kCameraCount> cameras_;
};

/// Watches as long as it lives.
class FramesWatcher {
 public:
  explicit FramesWatcher(std::shared_ptr<LatestFrames> frames) : frames_(std::move(frames)) { frames_->addWatcher(); }
  ~FramesWatcher() { frames_->removeWatcher(); }
  FramesWatcher(const FramesWatcher&) = delete;
  FramesWatcher& operator=(const FramesWatcher&) = delete;

 private:
  std::shared_ptr<LatestFrames> frames_;
};

/// `watch`, and what is extracted is offered to `frames` too.
[[nodiscard]] InspectionObserver tapped(InspectionObserver watch, std::shared_ptr<LatestFrames> frames);

}  // namespace vignole
