#pragma once
// What the memory allows, for the benchmarks to be judged by.

#include <cstdint>
#include <span>

namespace vignole::cli {

/// Sum of all bytes, each read once, as fast as one core can: four streams at a time, so that enough lines are under
/// way. More streams or prefetches gained less than 1 %, and without them the same sum of cached bytes takes a fifth:
/// it is the memory that limits.
[[nodiscard]] std::uint64_t readOnce(std::span<const std::uint8_t> bytes);

/// Drops the bytes from all caches.
void evict(std::span<const std::uint8_t> bytes);

}  // namespace vignole::cli
