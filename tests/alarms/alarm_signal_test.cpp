#include "engine/alarms/alarm_signal.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace vignole {
namespace {

AlarmTime at(double seconds) {
  return AlarmTime(AlarmDuration(std::llround(1000 * seconds))) + std::chrono::hours(24 * 20000);
}

AlarmRule above(double limit, double deadband = 0, double onDelayS = 0, double offDelayS = 0, double filterS = 0) {
  AlarmRule r;
  r.condition = AlarmCondition::Above;
  r.limit = limit;
  r.deadband = deadband;
  r.onDelayS = onDelayS;
  r.offDelayS = offDelayS;
  r.filterS = filterS;
  return r;
}

TEST(AlarmSignal, DeadbandHoldsItUntilTheValueHasComeBack) {
  const AlarmRule rule = above(10, 2);
  AlarmSignal s(rule);
  s.observe(10, at(0));
  EXPECT_FALSE(s.on()) << "at the limit is not above";
  s.observe(10.1, at(1));
  EXPECT_TRUE(s.on());
  for (const double v : {9.9, 8.1, 10.5, 8.1}) {
    s.observe(v, at(2));
    EXPECT_TRUE(s.on()) << v;
  }
  s.observe(8, at(3));
  EXPECT_FALSE(s.on());
  s.observe(9.9, at(4));
  EXPECT_FALSE(s.on()) << "back inside the band from below";
}

TEST(AlarmSignal, BelowIsTheMirror) {
  AlarmRule rule = above(10, 2);
  rule.condition = AlarmCondition::Below;
  AlarmSignal s(rule);
  s.observe(9.9, at(0));
  EXPECT_TRUE(s.on());
  s.observe(11.9, at(1));
  EXPECT_TRUE(s.on());
  s.observe(12, at(2));
  EXPECT_FALSE(s.on());
}

TEST(AlarmSignal, OnDelayWantsItWithoutABreak) {
  const AlarmRule rule = above(10, 0, 5);
  AlarmSignal s(rule);
  s.observe(11, at(0));
  s.observe(11, at(4.9));
  EXPECT_FALSE(s.on());
  s.observe(9, at(4.95));
  s.observe(11, at(5));
  s.observe(11, at(9.9));
  EXPECT_FALSE(s.on()) << "the break began the delay anew";
  s.advance(at(30));
  EXPECT_TRUE(s.on());
  EXPECT_EQ(s.since(), at(10)) << "when the delay was over, not when somebody looked";
}

TEST(AlarmSignal, ALateLookDoesNotMissWhatWasDueBefore) {
  const AlarmRule rule = above(10, 0, 5, 0);
  AlarmSignal s(rule);
  s.observe(11, at(0));
  s.observe(9, at(60));  // nobody called in between: the delay was long over
  EXPECT_FALSE(s.on());
  EXPECT_EQ(s.since(), at(60)) << "it was on from 5 to 60";
}

TEST(AlarmSignal, OffDelayBridgesGaps) {
  const AlarmRule rule = above(10, 0, 0, 3);
  AlarmSignal s(rule);
  s.observe(11, at(0));
  s.observe(9, at(1));
  s.observe(11, at(3));
  s.observe(9, at(4));
  s.observe(9, at(6.9));
  EXPECT_TRUE(s.on());
  s.advance(at(7));
  EXPECT_FALSE(s.on());
}

TEST(AlarmSignal, FilterThenDelay) {
  // A single spike of 10 x the limit passes the limit, but neither the filter nor the delay.
  const AlarmRule rule = above(1, 0.1, 2, 2, 10);
  AlarmSignal s(rule);
  for (int i = 0; i < 100; ++i) s.observe(i == 50 ? 10 : 0, at(0.1 * i));
  EXPECT_FALSE(s.on());
  EXPECT_LT(*s.value(), 0.1);
  // A step to 2: the filter reaches 1 after 10 s x ln 2, the alarm comes 2 s later.
  double cameOn = 0;
  for (int i = 0; i < 200 && cameOn == 0; ++i) {
    s.observe(2, at(10 + 0.1 * i));
    if (s.on()) cameOn = 0.1 * i;
  }
  EXPECT_NEAR(cameOn, 10 * std::log(2.0) + 2, 0.5);
}

TEST(AlarmSignal, TheFilterDependsOnTimeNotOnTheRate) {
  const AlarmRule rule = above(100, 0, 0, 0, 5);
  AlarmSignal often(rule), seldom(rule);
  often.observe(0, at(0));
  seldom.observe(0, at(0));
  for (int i = 1; i <= 100; ++i) often.observe(1, at(0.1 * i));
  seldom.observe(1, at(10));
  EXPECT_NEAR(*often.value(), *seldom.value(), 1e-9);
  EXPECT_NEAR(*often.value(), 1 - std::exp(-2.0), 1e-9);
}

TEST(AlarmSignal, NoValueChangesNothing) {
  const AlarmRule rule = above(10);
  AlarmSignal s(rule);
  s.observe(11, at(0));
  s.observe(std::numeric_limits<double>::quiet_NaN(), at(1));
  s.observe(std::numeric_limits<double>::infinity(), at(2));
  EXPECT_TRUE(s.on());
  EXPECT_EQ(*s.value(), 11);
}

TEST(AlarmSignal, AClockThatIsSetBackDoesNoHarm) {
  const AlarmRule rule = above(10, 0, 5, 0, 2);
  AlarmSignal s(rule);
  s.observe(11, at(100));
  s.observe(11, at(50));
  EXPECT_FALSE(s.on());
  EXPECT_EQ(*s.value(), 11);
  s.observe(11, at(106));
  EXPECT_TRUE(s.on());
}

}  // namespace
}  // namespace vignole
