#pragma once
// The mailbox between a thread that produces many values and a screen that shows some: the newest one wins, nothing
// queues up, and what was overwritten unseen is counted.

#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>

namespace vignole {

/// Any number of threads may publish and take.
template <typename T>
class LatestValue {
 public:
  void publish(T value) {
    auto fresh = std::make_shared<const T>(std::move(value));
    const std::lock_guard lock(mutex_);
    if (unseen_) ++overwritten_;
    latest_.swap(fresh);
    unseen_ = true;
    ++published_;
  }

  /// The newest value if it has not been taken before, else null.
  [[nodiscard]] std::shared_ptr<const T> takeNew() {
    const std::lock_guard lock(mutex_);
    if (!unseen_) return nullptr;
    unseen_ = false;
    return latest_;
  }

  void clear() {
    const std::lock_guard lock(mutex_);
    latest_.reset();
    unseen_ = false;
  }

  [[nodiscard]] std::uint64_t published() const {
    const std::lock_guard lock(mutex_);
    return published_;
  }
  [[nodiscard]] std::uint64_t overwritten() const {
    const std::lock_guard lock(mutex_);
    return overwritten_;
  }

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<const T> latest_;
  bool unseen_ = false;
  std::uint64_t published_ = 0, overwritten_ = 0;
};

}  // namespace vignole
