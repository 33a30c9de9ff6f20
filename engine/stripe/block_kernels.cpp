#include "engine/stripe/block_kernels.h"

#include <algorithm>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/stripe/block_kernels.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace vignole::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t kSide = 8;

unsigned plainSum(const std::uint8_t* block, std::ptrdiff_t stride) {
  unsigned sum = 0;
  for (std::size_t y = 0; y < kSide; y += 2, block += 2 * stride)
    for (std::size_t x = 0; x < kSide; ++x) sum += block[x];
  return sum;
}

unsigned plainDifferences(const std::uint8_t* block, std::ptrdiff_t stride) {
  unsigned sum = 0;
  for (std::size_t y = 0; y < kSide; y += 2, block += 2 * stride)
    for (std::size_t x = 0; x < kSide; ++x) {
      const int difference = block[x] - (block + stride)[x];
      sum += static_cast<unsigned>(difference < 0 ? -difference : difference);
    }
  return sum;
}

#if HWY_TARGET != HWY_SCALAR

const hn::ScalableTag<std::uint8_t> kBytes;
const hn::Repartition<std::uint64_t, decltype(kBytes)> kWide;

HWY_INLINE auto vectorSum(const std::uint8_t* p, std::ptrdiff_t stride) {
  // The rows of the next blocks are asked for meanwhile: four streams are more than the hardware follows by itself.
  auto sum = hn::Zero(kWide);
  for (std::size_t y = 0; y < kSide; y += 2, p += 2 * stride) {
    hwy::Prefetch(p + static_cast<std::ptrdiff_t>(kSide) * stride);
    sum = hn::Add(sum, hn::SumsOf8(hn::LoadU(kBytes, p)));
  }
  return sum;
}

HWY_INLINE auto vectorDifferences(const std::uint8_t* p, std::ptrdiff_t stride) {
  auto sum = hn::Zero(kWide);
  for (std::size_t y = 0; y < kSide; y += 2, p += 2 * stride) {
    const auto upper = hn::LoadU(kBytes, p), lower = hn::LoadU(kBytes, p + stride);
    sum = hn::Add(sum, hn::SumsOf8(hn::Sub(hn::Max(upper, lower), hn::Min(upper, lower))));
  }
  return sum;
}

#endif

// One 64-bit lane gathers the eight pixels of a block's row, so a vector works on as many blocks as it has such lanes.
template <class VectorSums, class PlainSums>
HWY_INLINE void eachBlock(const std::uint8_t* pixels, std::size_t blocks, std::uint16_t* sums,
                          const VectorSums& vectorSums, const PlainSums& plainSums) {
  std::size_t b = 0;
#if HWY_TARGET != HWY_SCALAR
  const hn::Rebind<std::uint16_t, decltype(kWide)> narrow;
  const std::size_t step = hn::Lanes(kWide);
  for (; b + step <= blocks; b += step)
    hn::StoreU(hn::TruncateTo(narrow, vectorSums(pixels + b * kSide)), narrow, sums + b);
  if (b < blocks && blocks >= step) {  // the last vector overlaps the one before
    b = blocks - step;
    hn::StoreU(hn::TruncateTo(narrow, vectorSums(pixels + b * kSide)), narrow, sums + b);
    return;
  }
#else
  (void)vectorSums;
#endif
  for (; b < blocks; ++b) sums[b] = static_cast<std::uint16_t>(plainSums(pixels + b * kSide));
}

void sumRow(const std::uint8_t* pixels, std::ptrdiff_t stride, std::size_t blocks, std::uint16_t* sums) {
  eachBlock(
      pixels, blocks, sums,
#if HWY_TARGET != HWY_SCALAR
      [stride](const std::uint8_t* p) HWY_ATTR { return vectorSum(p, stride); },
#else
      nullptr,
#endif
      [stride](const std::uint8_t* p) { return plainSum(p, stride); });
}

void differencesRow(const std::uint8_t* pixels, std::ptrdiff_t stride, std::size_t blocks, std::uint16_t* sums) {
  eachBlock(
      pixels, blocks, sums,
#if HWY_TARGET != HWY_SCALAR
      [stride](const std::uint8_t* p) HWY_ATTR { return vectorDifferences(p, stride); },
#else
      nullptr,
#endif
      [stride](const std::uint8_t* p) { return plainDifferences(p, stride); });
}

const hn::ScalableTag<std::uint16_t> kShorts;

void minimumRow(const std::uint16_t* in, int radius, std::size_t count, std::uint16_t* out) {
  for (std::size_t i = 0; i < count; i += hn::Lanes(kShorts)) {
    auto least = hn::LoadU(kShorts, in + i);
    for (int k = 1; k <= radius; ++k)
      least = hn::Min(least, hn::Min(hn::LoadU(kShorts, in + i - k), hn::LoadU(kShorts, in + i + k)));
    hn::StoreU(least, kShorts, out + i);
  }
}

void excessRow(const std::uint16_t* const* rows, int rowCount, const std::uint16_t* sums, std::size_t count,
               std::uint16_t* background, std::uint16_t* excess) {
  for (std::size_t i = 0; i < count; i += hn::Lanes(kShorts)) {
    auto least = hn::LoadU(kShorts, rows[0] + i);
    for (int r = 1; r < rowCount; ++r) least = hn::Min(least, hn::LoadU(kShorts, rows[r] + i));
    hn::StoreU(least, kShorts, background + i);
    hn::StoreU(hn::SaturatedSub(hn::LoadU(kShorts, sums + i), least), kShorts, excess + i);
  }
}

void markRow(const std::uint16_t* excess, std::ptrdiff_t pitch, std::uint16_t floor, std::size_t count,
             std::uint64_t* marks) {
  const auto least = hn::Set(kShorts, floor);
  const std::size_t lanes = hn::Lanes(kShorts);
  for (std::size_t word = 0; 64 * word < count; ++word) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < 64; i += lanes) {
      const auto own = hn::LoadU(kShorts, excess + 64 * word + i);
      if (hn::AllTrue(kShorts, hn::Eq(hn::SaturatedSub(own, least), hn::Zero(kShorts)))) continue;  // dark, as most are
      auto largest = least;
      for (int r = -1; r <= 1; ++r) {
        const std::uint16_t* p = excess + r * pitch + 64 * word + i;
        const auto side = hn::Max(hn::LoadU(kShorts, p - 1), hn::LoadU(kShorts, p + 1));
        largest = hn::Max(largest, hn::Max(side, hn::LoadU(kShorts, p)));
      }
      const auto needed = hn::Max(least, hn::ShiftRight<3>(largest));
      // a > b for unsigned numbers: their saturated difference is not zero
      const auto above = hn::SaturatedSub(own, needed);
      std::uint8_t bytes[8] = {};
      hn::StoreMaskBits(kShorts, hn::Ne(above, hn::Zero(kShorts)), bytes);
      std::uint64_t part = 0;
      std::memcpy(&part, bytes, sizeof part);
      bits |= part << i;
    }
    const std::size_t rest = count - 64 * word;
    marks[word] = rest < 64 ? bits & ((std::uint64_t{1} << rest) - 1) : bits;
  }
}

}  // namespace
}  // namespace vignole::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vignole {

HWY_EXPORT(sumRow);
HWY_EXPORT(differencesRow);
HWY_EXPORT(minimumRow);
HWY_EXPORT(excessRow);
HWY_EXPORT(markRow);

void sumBlockRow(const std::uint8_t* pixels, std::ptrdiff_t stride, std::size_t blocks, std::uint16_t* sums) {
  HWY_DYNAMIC_DISPATCH(sumRow)(pixels, stride, blocks, sums);
}

void sumBlockDifferences(const std::uint8_t* pixels, std::ptrdiff_t stride, std::size_t blocks, std::uint16_t* sums) {
  HWY_DYNAMIC_DISPATCH(differencesRow)(pixels, stride, blocks, sums);
}

void minimumAlongRow(const std::uint16_t* in, int radius, std::size_t count, std::uint16_t* out) {
  HWY_DYNAMIC_DISPATCH(minimumRow)(in, radius, count, out);
}

void backgroundAndExcess(const std::uint16_t* const* rows, int rowCount, const std::uint16_t* sums, std::size_t count,
                         std::uint16_t* background, std::uint16_t* excess) {
  HWY_DYNAMIC_DISPATCH(excessRow)(rows, rowCount, sums, count, background, excess);
}

void markBlocks(const std::uint16_t* excess, std::ptrdiff_t pitch, std::uint16_t floor, std::size_t count,
                std::uint64_t* marks) {
  HWY_DYNAMIC_DISPATCH(markRow)(excess, pitch, floor, count, marks);
}

}  // namespace vignole
#endif
