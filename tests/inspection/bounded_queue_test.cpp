#include "engine/inspection/bounded_queue.h"

#include <atomic>
#include <gtest/gtest.h>
#include <memory>
#include <thread>
#include <vector>

namespace vignole {
namespace {

TEST(BoundedQueue, KeepsOrderAndCountsItsHighWater) {
  BoundedQueue<int> queue(4);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(queue.push(int{i}));
  EXPECT_EQ(queue.depth(), 3U);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(queue.pop(), i);
  EXPECT_TRUE(queue.push(7));
  EXPECT_EQ(queue.depth(), 1U);
  EXPECT_EQ(queue.highWater(), 3U);
  EXPECT_EQ(queue.capacity(), 4U);
  EXPECT_EQ(queue.overflows(), 0U);
}

TEST(BoundedQueue, DropsAndCountsWhenFullAndLeavesTheItemAlone) {
  BoundedQueue<std::unique_ptr<int>> queue(1);
  EXPECT_TRUE(queue.tryPush(std::make_unique<int>(1)));
  auto second = std::make_unique<int>(2);
  EXPECT_FALSE(queue.tryPush(std::move(second)));
  ASSERT_NE(second, nullptr);  // NOLINT(bugprone-use-after-move): the contract under test
  EXPECT_EQ(*second, 2);
  EXPECT_EQ(queue.overflows(), 1U);
}

TEST(BoundedQueue, TokensTakeTheirTurnButNoPlace) {
  BoundedQueue<int> queue(1);
  EXPECT_TRUE(queue.tryPush(1));
  queue.pushToken(2);
  EXPECT_EQ(queue.pop(), 1);
  EXPECT_TRUE(queue.tryPush(3)) << "a token occupies no place";
  EXPECT_EQ(queue.pop(), 2);
  EXPECT_EQ(queue.pop(), 3);
  EXPECT_EQ(queue.highWater(), 1U);
}

TEST(BoundedQueue, WhoFoundItFullGoesOnWhenHalfIsEmpty) {
  BoundedQueue<int> queue(4);
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(queue.push(int{i}));
  std::atomic<bool> pushed{false};
  std::jthread producer([&] {
    EXPECT_TRUE(queue.push(4));
    pushed = true;
  });
  EXPECT_EQ(queue.pop(), 0);
  EXPECT_EQ(queue.pop(), 1);
  producer.join();  // without another pop
  EXPECT_TRUE(pushed);
  for (int i = 2; i < 5; ++i) EXPECT_EQ(queue.pop(), i);
  EXPECT_EQ(queue.highWater(), 4U);
}

TEST(BoundedQueue, WhatNeedNotWakeTheConsumerComesWithTheNextOrAtAQuarter) {
  using Queue = BoundedQueue<int>;
  Queue queue(8);
  for (const auto last : {Queue::Wake::Now, Queue::Wake::Later}) {
    std::jthread consumer([&] {
      EXPECT_EQ(queue.pop(), 1);
      EXPECT_EQ(queue.pop(), 2);
    });
    EXPECT_TRUE(queue.push(1, {}, 0, Queue::Wake::Later));
    EXPECT_TRUE(queue.tryPush(2, 0, last));
  }  // joins without another push
  EXPECT_TRUE(queue.empty());
}

TEST(BoundedQueue, AStopReleasesWhoWaitsForAPlaceOrAnItem) {
  BoundedQueue<int> full(1), empty(1);
  EXPECT_TRUE(full.push(1));
  std::atomic<bool> pushed{true}, popped{true};
  {
    std::jthread producer([&](const std::stop_token& stop) { pushed = full.push(2, stop); });
    std::jthread consumer([&](const std::stop_token& stop) { popped = empty.pop(stop).has_value(); });
  }  // requests the stop and joins
  EXPECT_FALSE(pushed);
  EXPECT_FALSE(popped);
  EXPECT_EQ(full.pop(), 1);
}

TEST(BoundedQueue, WhatIsThereIsGivenOutEvenAfterAStop) {
  BoundedQueue<int> queue(2);
  EXPECT_TRUE(queue.push(5));
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(queue.pop(stop.get_token()), 5);
  EXPECT_EQ(queue.pop(stop.get_token()), std::nullopt);
}

TEST(BoundedQueue, LanesAreBoundedApartAndTakenInTurn) {
  BoundedQueue<int, 2> queue(2);
  EXPECT_TRUE(queue.tryPush(10, 0));
  EXPECT_TRUE(queue.tryPush(11, 0));
  EXPECT_FALSE(queue.tryPush(12, 0));
  EXPECT_TRUE(queue.tryPush(20, 1));
  const auto any = [](std::size_t) { return true; };
  EXPECT_EQ(queue.pop({}, any)->item, 10);
  EXPECT_EQ(queue.pop({}, any)->item, 20);
  EXPECT_TRUE(queue.tryPush(21, 1));
  const auto taken = queue.pop({}, [](std::size_t lane) { return lane == 1; });
  EXPECT_EQ(taken->lane, 1U);
  EXPECT_EQ(taken->item, 21);
  EXPECT_EQ(queue.pop({}, any)->item, 11);
}

TEST(BoundedQueue, ManyProducersLoseNothingAndKeepTheirOwnOrder) {
  constexpr int kProducers = 4, kEach = 5000;
  BoundedQueue<int, kProducers> queue(3);
  std::vector<std::jthread> producers;
  for (int p = 0; p < kProducers; ++p)
    producers.emplace_back([&queue, p] {
      for (int i = 0; i < kEach; ++i) ASSERT_TRUE(queue.push(int{i}, {}, static_cast<std::size_t>(p)));
    });
  std::vector<int> next(kProducers, 0);
  for (int i = 0; i < kProducers * kEach; ++i) {
    const auto taken = queue.pop({}, [](std::size_t) { return true; });
    ASSERT_EQ(taken->item, next[taken->lane]++);
  }
  EXPECT_LE(queue.highWater(), 3U);
}

}  // namespace
}  // namespace vignole
