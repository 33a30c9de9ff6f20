#include "engine/inspection/object_pool.h"

#include <gtest/gtest.h>
#include <thread>

namespace vignole {
namespace {

TEST(ObjectPool, HandsOutAgainWhatCameBackWithItsBuffers) {
  ObjectPool<std::vector<int>> pool;
  const int* buffer = nullptr;
  {
    auto object = pool.take();
    object->assign(1000, 1);
    buffer = object->data();
    EXPECT_EQ(pool.available(), 0U);
  }
  EXPECT_EQ(pool.available(), 1U);
  EXPECT_EQ(pool.take()->data(), buffer);
}

TEST(ObjectPool, MakesNoMoreThanAreOutAtOnceWhateverTheThreads) {
  ObjectPool<std::vector<int>> pool;
  {
    std::vector<std::jthread> threads;
    for (int t = 0; t < 3; ++t)
      threads.emplace_back([&pool] {
        for (int i = 0; i < 2000; ++i) pool.take()->push_back(i);
      });
  }
  EXPECT_GE(pool.available(), 1U);
  EXPECT_LE(pool.available(), 3U);
}

}  // namespace
}  // namespace vignole
