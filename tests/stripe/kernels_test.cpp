// The same answers on every SIMD target, without SIMD, from call to call, and without allocations.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <gtest/gtest.h>
#include <hwy/targets.h>
#include <new>
#include <random>

#include "engine/stripe/block_kernels.h"
#include "engine/stripe/block_scan.h"
#include "engine/stripe/stripe_extractor.h"
#include "tests/synthetic/stripe_scene.h"

namespace {
std::atomic<std::size_t> allocations{0};  // NOLINT: the only way to see them
}

// The sanitizers bring their own operator new; what is counted here is the same code without them.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define VIGNOLE_ALLOCATIONS_COUNTED 0
#else
#define VIGNOLE_ALLOCATIONS_COUNTED 1
void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
#endif

namespace vignole {
namespace {

/// Runs `work` once on every target this machine has, and once without SIMD.
template <class Work>
void onEveryTarget(const Work& work) {
  const std::int64_t available = hwy::SupportedTargets();
  for (std::int64_t left = available; left != 0; left &= left - 1) {
    hwy::SetSupportedTargetsForTest(left & -left);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    work();
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

TEST(BlockKernels, AgreeWithPlainSums) {
  std::mt19937 random(3);
  for (const std::size_t blocks : {1U, 3U, 4U, 7U, 8U, 9U, 31U, 175U}) {
    const std::size_t stride = blocks * 8 + 5;
    std::vector<std::uint8_t> pixels(stride * 8);
    for (auto& p : pixels) p = static_cast<std::uint8_t>(random());
    std::vector<std::uint16_t> sums(blocks, 0), differences(blocks, 0);
    for (std::size_t y = 0; y < 8; ++y)
      for (std::size_t x = 0; x < blocks * 8; ++x) {
        if (y % 2 == 0) {
          sums[x / 8] = static_cast<std::uint16_t>(sums[x / 8] + pixels[y * stride + x]);
          differences[x / 8] = static_cast<std::uint16_t>(
              differences[x / 8] + std::abs(pixels[y * stride + x] - pixels[(y + 1) * stride + x]));
        }
      }
    onEveryTarget([&] {
      std::vector<std::uint16_t> found(blocks, 0xABCD);
      sumBlockRow(pixels.data(), static_cast<std::ptrdiff_t>(stride), blocks, found.data());
      EXPECT_EQ(found, sums) << stripeSimdTarget();
      sumBlockDifferences(pixels.data(), static_cast<std::ptrdiff_t>(stride), blocks, found.data());
      EXPECT_EQ(found, differences) << stripeSimdTarget();
    });
  }
}

TEST(BlockScan, MarksTheBlocksOfTheLineAndFewOthers) {
  const synthetic::StripeScene scene = synthetic::stripeScene("narrow", 5);
  onEveryTarget([&] {
    BlockScan scan;
    scan.begin(scene.view(), {});
    for (int row = 0; row < scan.rows(); ++row) scan.settle(row);
    std::vector<char> marked(static_cast<std::size_t>(scan.columns() * scan.rows()), 0);
    for (const BlockRun& run : scan.runs())
      for (int c = 0; c < run.count; ++c)
        marked[static_cast<std::size_t>(run.row * scan.columns() + run.first + c)] = 1;
    EXPECT_EQ(std::count(marked.begin(), marked.end(), 1), static_cast<std::ptrdiff_t>(scan.candidates()));
    EXPECT_LT(scan.candidates(), 900U);
    int missed = 0;
    for (const synthetic::TruthSample& s : scene.truth)
      missed += marked[static_cast<std::size_t>(static_cast<int>(s.y + 0.5) / 8 * scan.columns() +
                                                static_cast<int>(s.x + 0.5) / 8)] == 0;
    EXPECT_LT(missed, 0.002 * static_cast<double>(scene.truth.size()));
  });
}

TEST(BlockScan, ABlockAloneIsNoLineTwoSideBySideMayBe) {
  std::vector<std::uint8_t> pixels(640 * 480, 20);
  const auto light = [&](int column, int row) {
    for (int y = 0; y < kBlock; ++y)
      std::fill_n(pixels.begin() + (row * kBlock + y) * 640 + column * kBlock, kBlock, std::uint8_t{90});
  };
  light(20, 20);
  light(0, 0);
  light(79, 59);
  light(40, 30);
  light(41, 31);
  onEveryTarget([&] {
    BlockScan scan;
    scan.begin({pixels.data(), 640, 480, 640}, {});
    for (int row = 0; row < scan.rows(); ++row) scan.settle(row);
    ASSERT_EQ(scan.candidates(), 2U) << stripeSimdTarget();
    ASSERT_EQ(scan.runs().size(), 2U);
    EXPECT_EQ(scan.runs()[0].row, 30);
    EXPECT_EQ(scan.runs()[0].first, 40);
    EXPECT_EQ(scan.runs()[1].row, 31);
    EXPECT_EQ(scan.runs()[1].first, 41);
  });
}

TEST(Extraction, EveryTargetFindsTheSamePoints) {
  const synthetic::StripeScene scene = synthetic::stripeScene("rail", 2);
  StripeResult first;
  StripeExtractor({}).extract(scene.view(), first);
  onEveryTarget([&] {
    StripeResult result;
    StripeExtractor({}).extract(scene.view(), result);
    ASSERT_NEAR(static_cast<double>(result.points.size()), static_cast<double>(first.points.size()), 2)
        << stripeSimdTarget();
    // Rounding may admit a point more or less where the line passes between two pixels, and with it another chord at
    // the end of the line; the others agree within what a float coordinate can tell.
    for (const StripePoint& p : result.points) {
      if ((p.flags & (kLineEnd | kGapEdge)) != 0) continue;
      float nearest = 1;
      for (const StripePoint& q : first.points) nearest = std::min(nearest, std::hypot(p.x - q.x, p.y - q.y));
      EXPECT_TRUE(nearest < 5e-4F || nearest > 0.3F) << stripeSimdTarget() << ": " << nearest;
    }
  });
}

bool sameBits(const StripeResult& a, const StripeResult& b) {
  return a.points.size() == b.points.size() && a.lines.size() == b.lines.size() && a.noiseDn == b.noiseDn &&
         std::equal(a.points.begin(), a.points.end(), b.points.begin(), [](const StripePoint& p, const StripePoint& q) {
           return p.x == q.x && p.y == q.y && p.nx == q.nx && p.ny == q.ny && p.sigmaPx == q.sigmaPx &&
                  p.strength == q.strength && p.widthPx == q.widthPx && p.flags == q.flags;
         });
}

TEST(Extraction, SameBitsWhateverCameBefore) {
  const synthetic::StripeScene hard = synthetic::stripeScene("hard", 1), clean = synthetic::stripeScene("clean", 1);
  const std::vector<std::uint8_t> small(64 * 48, 9);
  StripeResult first, again, fresh;
  StripeExtractor extractor({});
  extractor.extract(hard.view(), first);
  extractor.extract(clean.view(), again);
  extractor.extract({small.data(), 64, 48, 64}, again);
  extractor.extract(hard.view(), again);
  EXPECT_TRUE(sameBits(first, again));
  StripeExtractor({}).extract(hard.view(), fresh);
  EXPECT_TRUE(sameBits(first, fresh));
}

TEST(Extraction, AllocatesNothingInSteadyState) {
  if (!VIGNOLE_ALLOCATIONS_COUNTED) GTEST_SKIP() << "a sanitizer has taken the allocator";
  const synthetic::StripeScene scenes[] = {synthetic::stripeScene("hard", 3), synthetic::stripeScene("wide", 4)};
  StripeExtractor extractor({});
  StripeResult result;
  for (int round = 0; round < 2; ++round)
    for (const auto& scene : scenes) extractor.extract(scene.view(), result);
  const std::size_t before = allocations;
  for (int round = 0; round < 3; ++round)
    for (const auto& scene : scenes) extractor.extract(scene.view(), result);
  EXPECT_EQ(allocations - before, 0U);
  EXPECT_GT(result.points.size(), 1000U);
}

}  // namespace
}  // namespace vignole
