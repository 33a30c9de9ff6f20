#include "cli/memory_speed.h"

#include <atomic>
#include <hwy/cache_control.h>
#include <numeric>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cli/memory_speed.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace vignole::cli::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

std::uint64_t sumOfStreams(const std::uint8_t* HWY_RESTRICT bytes, std::size_t perStream) {
  const hn::ScalableTag<std::uint8_t> d;
  const hn::ScalableTag<std::uint64_t> sums;
  auto a = hn::Zero(sums), b = a, c = a, e = a;
  const auto add = [&](auto sum, const std::uint8_t* at) { return hn::Add(sum, hn::SumsOf8(hn::LoadU(d, at))); };
  for (std::size_t i = 0; i < perStream; i += hn::Lanes(d)) {
    a = add(a, bytes + i);
    b = add(b, bytes + perStream + i);
    c = add(c, bytes + 2 * perStream + i);
    e = add(e, bytes + 3 * perStream + i);
  }
  return hn::GetLane(hn::SumOfLanes(sums, hn::Add(hn::Add(a, b), hn::Add(c, e))));
}

}  // namespace vignole::cli::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vignole::cli {

HWY_EXPORT(sumOfStreams);

std::uint64_t readOnce(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kStreams = 4, kWidest = 256;  // no vector is wider
  const std::size_t perStream = bytes.size() / kStreams / kWidest * kWidest;
  const auto rest = bytes.subspan(kStreams * perStream);
  return HWY_DYNAMIC_DISPATCH(sumOfStreams)(bytes.data(), perStream) +
         std::accumulate(rest.begin(), rest.end(), std::uint64_t{0});
}

void evict(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kLine = 64;
  for (std::size_t i = 0; i < bytes.size(); i += kLine) hwy::FlushCacheline(bytes.data() + i);
  if (!bytes.empty()) hwy::FlushCacheline(&bytes.back());
  std::atomic_thread_fence(std::memory_order_seq_cst);
}

}  // namespace vignole::cli
#endif  // HWY_ONCE
