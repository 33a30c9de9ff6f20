#include "gui/bridge/latest_value.h"

#include <gtest/gtest.h>
#include <thread>

namespace vignole {
namespace {

TEST(LatestValue, IsEmptyUntilSomethingIsPublished) {
  LatestValue<int> mailbox;
  EXPECT_EQ(mailbox.takeNew(), nullptr);
}

TEST(LatestValue, TheNewestWinsAndTheOverwrittenAreCounted) {
  LatestValue<int> mailbox;
  mailbox.publish(1);
  mailbox.publish(2);
  mailbox.publish(3);
  const auto taken = mailbox.takeNew();
  ASSERT_NE(taken, nullptr);
  EXPECT_EQ(*taken, 3);
  EXPECT_EQ(mailbox.published(), 3U);
  EXPECT_EQ(mailbox.overwritten(), 2U);
}

TEST(LatestValue, IsTakenOnce) {
  LatestValue<int> mailbox;
  mailbox.publish(1);
  EXPECT_NE(mailbox.takeNew(), nullptr);
  EXPECT_EQ(mailbox.takeNew(), nullptr);
  mailbox.publish(2);
  EXPECT_EQ(*mailbox.takeNew(), 2);
  EXPECT_EQ(mailbox.overwritten(), 0U);
}

TEST(LatestValue, WhatWasTakenOutlivesWhatComesAfter) {
  LatestValue<std::vector<int>> mailbox;
  mailbox.publish({1, 2, 3});
  const auto held = mailbox.takeNew();
  for (int i = 0; i < 10; ++i) mailbox.publish({i});
  EXPECT_EQ(*held, (std::vector<int>{1, 2, 3}));
}

TEST(LatestValue, ReaderBesideWriterSeesRisingWholeValues) {
  LatestValue<std::pair<int, int>> mailbox;
  constexpr int kLast = 20000;
  std::jthread writer([&] {
    for (int i = 1; i <= kLast; ++i) mailbox.publish({i, -i});
  });
  int last = 0;
  std::uint64_t taken = 0;
  while (last < kLast) {
    const auto value = mailbox.takeNew();
    if (!value) continue;
    ++taken;
    ASSERT_GT(value->first, last);
    ASSERT_EQ(value->second, -value->first);
    last = value->first;
  }
  writer.join();
  EXPECT_EQ(taken + mailbox.overwritten(), mailbox.published());
}

}  // namespace
}  // namespace vignole
