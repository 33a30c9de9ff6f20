#include "engine/acquisition/memory_source.h"

#include <gtest/gtest.h>
#include <thread>

namespace vignole {
namespace {

std::vector<FrameSet> twoSets() {
  static const std::array<std::uint8_t, 8> pixels{};
  std::vector<FrameSet> sets(2);
  for (std::size_t s = 0; s < 2; ++s)
    for (std::size_t c = 0; c < 4; ++c) sets[s][c] = {pixels.data() + 4 * s + c, 1, 1, 1};
  return sets;
}

TEST(MemorySource, ShowsItsSetsInTurnAsWholeRails) {
  MemorySourceSettings settings;
  settings.rail.id = "bench";
  settings.profiles = 3;
  settings.rails = 2;
  const auto sets = twoSets();
  MemorySource source(sets, nullptr, settings);
  std::uint64_t trigger = 0;
  for (int rail = 0; rail < 2; ++rail) {
    const FrameMessage begin = source.next(1, {});
    ASSERT_TRUE(std::holds_alternative<RailBegin>(begin));
    EXPECT_EQ(std::get<RailBegin>(begin).firstTrigger, trigger);
    for (int i = 0; i < 3; ++i, ++trigger) {
      const FrameMessage message = source.next(1, {});
      ASSERT_TRUE(std::holds_alternative<Frame>(message));
      const Frame& frame = std::get<Frame>(message);
      EXPECT_EQ(frame.trigger, trigger);
      EXPECT_EQ(frame.camera, 1);
      EXPECT_EQ(frame.image.data, sets[trigger % 2][1].data);
    }
    const FrameMessage end = source.next(1, {});
    ASSERT_TRUE(std::holds_alternative<RailEnd>(end));
    EXPECT_EQ(std::get<RailEnd>(end).endTrigger, trigger);
  }
  EXPECT_TRUE(std::holds_alternative<SourceEnd>(source.next(1, {})));
  EXPECT_TRUE(std::holds_alternative<RailBegin>(source.next(2, {}))) << "each camera has its own stream";
}

TEST(MemorySource, PacedKeepsTheRateAndWakesOnAStop) {
  MemorySourceSettings settings;
  settings.profiles = 1000;
  settings.rateHz = 100;
  MemorySource source(twoSets(), nullptr, settings);
  (void)source.next(0, {});
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < 6; ++i) EXPECT_TRUE(std::holds_alternative<Frame>(source.next(0, {})));
  // The first comes at once, five periods follow.
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(50));

  settings.rateHz = 1e-3;
  MemorySource slow(twoSets(), nullptr, settings);
  (void)slow.next(0, {});
  (void)slow.next(0, {});
  FrameMessage last = RailEnd{};
  {
    std::jthread camera([&](const std::stop_token& stop) { last = slow.next(0, stop); });
  }  // stops it: a thousand seconds are not waited for
  EXPECT_TRUE(std::holds_alternative<SourceEnd>(last));
}

}  // namespace
}  // namespace vignole
