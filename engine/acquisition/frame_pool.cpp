#include "engine/acquisition/frame_pool.h"

namespace vignole {

std::shared_ptr<std::uint8_t[]> FramePool::take(const std::stop_token& stop, std::optional<Clock::time_point> until) {
  std::unique_lock lock(mutex_);
  const auto ready = [&] { return !free_.empty(); };
  const bool got = until ? returned_.wait_until(lock, stop, *until, ready) : returned_.wait(lock, stop, ready);
  if (!got) return nullptr;
  FrameMemory buffer = std::move(free_.back());
  free_.pop_back();
  lock.unlock();
  // Made when first needed: a run that never falls behind needs few.
  if (!buffer) buffer = makeFrameMemory(bytes_);
  return {buffer.release(), [pool = shared_from_this()](std::uint8_t* back) {
            const std::lock_guard guard(pool->mutex_);
            pool->free_.emplace_back(back);
            pool->returned_.notify_one();
          }};
}

}  // namespace vignole
