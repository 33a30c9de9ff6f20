#pragma once
// What a camera's stream hands over to the thread that takes its frames: bounded, never waited for by the stream.

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>

#include "engine/geometry/image_view.h"
#include "engine/synchronisation/frame_tagger.h"

namespace vignole::gige {

/// A frame that arrived whole, or, without a lease, one that there was no place for.
struct Arrival {
  std::uint64_t epoch = 0;  ///< number of the stream that it came from
  FrameTag tag;
  ImageView image;
  bool railLine = false;  ///< the line that says that a rail is there was high
  double s = 0;           ///< when, on the steady clock
  std::shared_ptr<const void> lease;
};

[[nodiscard]] inline double nowS() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

class CameraInbox {
 public:
  explicit CameraInbox(std::size_t capacity) : capacity_(capacity) {}

  /// Is there place for a frame with its pixels? Only the stream's thread adds, so a yes holds.
  [[nodiscard]] bool hasPlace() const {
    const std::scoped_lock lock(mutex_);
    return frames_ < capacity_;
  }
  void push(Arrival arrival) {
    {
      const std::scoped_lock lock(mutex_);
      frames_ += arrival.lease ? 1U : 0U;
      arrivals_.push_back(std::move(arrival));
    }
    changed_.notify_one();
  }
  /// Wakes who waits although nothing arrived.
  void poke() {
    {
      const std::scoped_lock lock(mutex_);
      poked_ = true;
    }
    changed_.notify_one();
  }
  /// The oldest; nothing if poked, stopped or out of patience before one came.
  [[nodiscard]] std::optional<Arrival> take(const std::stop_token& stop, std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, stop, patience, [this] { return poked_ || !arrivals_.empty(); });
    poked_ = false;
    if (arrivals_.empty()) return {};
    Arrival arrival = std::move(arrivals_.front());
    arrivals_.pop_front();
    frames_ -= arrival.lease ? 1U : 0U;
    return arrival;
  }
  void clear() {
    std::deque<Arrival> gone;  // declared first: the buffers go back outside of the lock
    const std::scoped_lock lock(mutex_);
    gone.swap(arrivals_);
    frames_ = 0;
  }

 private:
  const std::size_t capacity_;
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<Arrival> arrivals_;
  std::size_t frames_ = 0;
  bool poked_ = false;
};

}  // namespace vignole::gige
