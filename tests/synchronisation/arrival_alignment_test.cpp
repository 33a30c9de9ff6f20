#include "engine/synchronisation/arrival_alignment.h"

#include <gtest/gtest.h>

namespace vignole {
namespace {

constexpr double kPeriodS = 0.015;

TEST(ArrivalAlignment, FindsTheTriggerOfACameraThatJoins) {
  ArrivalAlignment alignment({6, 0.35});
  std::optional<std::int64_t> offset;
  int frames = 0;
  for (std::uint64_t t = 1000; t < 1020 && !offset; ++t) {
    const double s = static_cast<double>(t) * kPeriodS;
    alignment.addReference(t, s + 0.011);
    offset = alignment.add(static_cast<std::int64_t>(t) - 997, s + 0.013);
    ++frames;
  }
  ASSERT_TRUE(offset);
  EXPECT_EQ(*offset, 997);
  EXPECT_LE(frames, 10);
}

TEST(ArrivalAlignment, WorksWhenTheOthersAreLaterThanTheCamera) {
  ArrivalAlignment alignment({4, 0.35});
  std::optional<std::int64_t> offset;
  for (std::uint64_t t = 50; t < 80 && !offset; ++t) {
    const double s = static_cast<double>(t) * kPeriodS;
    offset = alignment.add(static_cast<std::int64_t>(t) + 5, s);  // the reference of this trigger is not there yet
    alignment.addReference(t, s + 0.004);
  }
  ASSERT_TRUE(offset);
  EXPECT_EQ(*offset, -5);
}

TEST(ArrivalAlignment, FramesHeldUpOnTheWayDoNotDecide) {
  ArrivalAlignment alignment({6, 0.35});
  std::optional<std::int64_t> offset;
  for (std::uint64_t t = 0; t < 40; ++t) {
    const double s = static_cast<double>(t) * kPeriodS;
    alignment.addReference(t, s);
    const double late = t % 5 == 4 ? 0.5 * kPeriodS : 0.0;  // never six good ones in a row
    offset = alignment.add(static_cast<std::int64_t>(t), s + late);
    EXPECT_FALSE(offset);
  }
}

TEST(ArrivalAlignment, SaysNothingWithoutOthers) {
  ArrivalAlignment alignment;
  for (int i = 0; i < 20; ++i) EXPECT_FALSE(alignment.add(i, i * kPeriodS));
}

}  // namespace
}  // namespace vignole
