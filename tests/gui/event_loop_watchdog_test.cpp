#include "gui/bridge/event_loop_watchdog.h"

#include <QTest>
#include <gtest/gtest.h>

namespace vignole {
namespace {

TEST(EventLoopWatchdog, QuantilesOfKnownTurns) {
  EventLoopWatchdog watchdog;
  EXPECT_EQ(watchdog.quantileMs(0.99), 0);
  for (int i = 0; i < 99; ++i) watchdog.note(1.04);
  watchdog.note(80);
  EXPECT_NEAR(watchdog.quantileMs(0.5), 1.1, 1e-9);  // upper edge of its step
  EXPECT_NEAR(watchdog.quantileMs(0.99), 1.1, 1e-9);
  EXPECT_NEAR(watchdog.quantileMs(1.0), 80, 0.1);
  EXPECT_EQ(watchdog.maxMs(), 80);
  EXPECT_EQ(watchdog.turns(), 100U);
}

TEST(EventLoopWatchdog, SeesATurnThatBlocksTheWindow) {
  EventLoopWatchdog watchdog;
  watchdog.start();
  ASSERT_TRUE(QTest::qWaitFor([&] { return watchdog.turns() > 3; }));
  QTest::qSleep(120);  // the blocked turn itself, not a wait for something
  const auto before = watchdog.turns();
  ASSERT_TRUE(QTest::qWaitFor([&] { return watchdog.turns() > before; }));
  EXPECT_GE(watchdog.maxMs(), 100);
}

}  // namespace
}  // namespace vignole
