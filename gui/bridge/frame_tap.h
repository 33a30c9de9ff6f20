#pragma once
// The latest frame of each camera for whoever looks: nobody waits, nothing is copied, and while nobody looks it costs
// one test a frame.

#include <array>
#include <atomic>
#include <memory>

#include "engine/acquisition/frame.h"
#include "engine/optics/calibration.h"
#include "gui/bridge/latest_value.h"

namespace vignole {

/// Written by the engine's threads, taken by any. A frame that is held keeps its buffer.
struct LatestFrames {
  std::atomic<bool> watched = false;
  std::array<LatestValue<Frame>, kCameraCount> cameras;
};

/// Passes everything on as it comes. The source outlives the tap.
class FrameTap : public FrameSource {
 public:
  FrameTap(FrameSource& source, std::shared_ptr<LatestFrames> latest) : source_(source), latest_(std::move(latest)) {}
  [[nodiscard]] FrameMessage next(int camera, std::stop_token stop) override {
    FrameMessage message = source_.next(camera, std::move(stop));
    if (latest_->watched.load(std::memory_order_relaxed))
      if (const Frame* frame = std::get_if<Frame>(&message))
        latest_->cameras[static_cast<std::size_t>(camera)].publish(*frame);
    return message;
  }
  [[nodiscard]] bool live() const override { return source_.live(); }

 private:
  FrameSource& source_;
  std::shared_ptr<LatestFrames> latest_;
};

}  // namespace vignole
