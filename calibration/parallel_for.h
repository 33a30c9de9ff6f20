#pragma once
// Independent parts of a step on all cores.

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace vignole {

/// body(i) for i in 0 ... count - 1, each once, in any order and thread; returns when all are done. `body` throws
/// nothing and writes to its own place, so that the result does not depend on the threads.
template <typename Body>
void parallelFor(std::size_t count, const Body& body) {
  const std::size_t threads = std::min<std::size_t>(std::max(1U, std::thread::hardware_concurrency()), count);
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) body(i);
  };
  std::vector<std::jthread> others;
  for (std::size_t i = 1; i < threads; ++i) others.emplace_back(work);
  work();
}

}  // namespace vignole
