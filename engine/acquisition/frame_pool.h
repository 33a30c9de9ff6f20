#pragma once
// The buffers of one camera: they go round from the source through the pipeline and back.

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <vector>

#include "engine/acquisition/frame_memory.h"

namespace vignole {

/// Thread-safe. A buffer's lease holds the pool, so a frame may outlive its source.
class FramePool : public std::enable_shared_from_this<FramePool> {
 public:
  using Clock = std::chrono::steady_clock;
  FramePool(std::size_t buffers, std::size_t bytes) : bytes_(bytes), free_(buffers) {}
  /// Waits until one is free, at most until `until`; null if none is by then, or if stopped.
  [[nodiscard]] std::shared_ptr<std::uint8_t[]> take(const std::stop_token& stop,
                                                     std::optional<Clock::time_point> until = {});
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  std::size_t bytes_;
  std::mutex mutex_;
  std::condition_variable_any returned_;
  std::vector<FrameMemory> free_;
};

}  // namespace vignole
