#include "gui/bridge/virtual_line.h"

#include <QTest>
#include <gtest/gtest.h>

#include "engine/recipe/recipe.h"
#include "gui/main_window/main_window.h"

namespace vignole {
namespace {

VirtualLineSettings settings() {
  VirtualLineSettings s;
  s.recipe = *findRecipe("60E1");
  s.rig.section = s.recipe.section;
  s.rig.parameters = s.recipe.parameters;
  return s;
}

bool waitForState(Line& line, LineState state) {
  return QTest::qWaitFor([&] { return line.pull(PullDetail::Everything).state == state; }, 30000);
}

TEST(VirtualLine, MeasuresStopsAndMeasuresAnotherRail) {
  auto line = VirtualLine::create(settings());
  ASSERT_TRUE(line) << line.error().message();
  EXPECT_EQ((*line)->pull(PullDetail::Everything).state, LineState::Idle);
  (*line)->start();
  ASSERT_TRUE(waitForState(**line, LineState::Measuring));
  EXPECT_TRUE((*line)->running());
  ASSERT_TRUE(QTest::qWaitFor([&] { return (*line)->pull(PullDetail::Everything).rail != nullptr; }, 30000));
  EXPECT_EQ((*line)->pull(PullDetail::Everything).stages.size(), 14U);

  (*line)->stop();
  ASSERT_TRUE(waitForState(**line, LineState::Stopped));
  const LineSnapshot stopped = (*line)->pull(PullDetail::Everything);
  EXPECT_EQ(stopped.triggers.seen, stopped.triggers.measured + stopped.triggers.incomplete + stopped.triggers.lost);
  EXPECT_GE(stopped.railsPassed, 1U) << "a rail that a stop cuts short ends as well";

  const auto last = stopped.latest;
  (*line)->start();
  ASSERT_TRUE(waitForState(**line, LineState::Measuring));
  ASSERT_TRUE(QTest::qWaitFor([&] { return (*line)->pull(PullDetail::Profile).latest != last; }, 30000));
}

TEST(VirtualLine, AnotherRecipeIsInForceFromTheNextStartAndTheRunningRailKeepsItsOwn) {
  VirtualLineSettings s = settings();
  s.rig.varyDimensions = false;
  auto line = VirtualLine::create(s);
  ASSERT_TRUE(line) << line.error().message();
  (*line)->start();
  ASSERT_TRUE(waitForState(**line, LineState::Measuring));
  auto other = *makeRecipe("54E1", "X", "A");
  other.version = 3;
  ASSERT_TRUE((*line)->useRecipe(other));
  EXPECT_EQ((*line)->pull(PullDetail::Everything).recipe->section.name, "60E1") << "the rail in the gauge";
  EXPECT_EQ((*line)->pull(PullDetail::Everything).nextRecipe, "54E1 X/A v3");

  (*line)->stop();
  ASSERT_TRUE(waitForState(**line, LineState::Stopped));
  EXPECT_EQ((*line)->pull(PullDetail::Everything).recipe->section.name, "60E1") << "shown until the next start";
  (*line)->start();
  const LineSnapshot& fresh = (*line)->pull(PullDetail::Profile);
  EXPECT_EQ(fresh.recipe->section.name, "54E1");
  EXPECT_TRUE(fresh.nextRecipe.empty());
  EXPECT_TRUE(!fresh.latest || fresh.latest->rail->sectionName == "54E1") << "nothing of the section before";
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        const LineSnapshot& now = (*line)->pull(PullDetail::Everything);
        return now.latest && now.latest->measurement.dimensions[index(Dimension::RH)].valueMm;
      },
      30000));
  const LineSnapshot& now = (*line)->pull(PullDetail::Everything);
  EXPECT_NEAR(*now.latest->measurement.dimensions[index(Dimension::RH)].valueMm, 159, 0.2);
}

TEST(VirtualLine, AWrongDeviationIsSeenOnTheRail) {
  VirtualLineSettings s = settings();
  s.rig.deviationMm[index(Dimension::WT)] = 1.4;
  auto line = VirtualLine::create(s);
  ASSERT_TRUE(line) << line.error().message();
  (*line)->start();
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        const LineSnapshot& now = (*line)->pull(PullDetail::Everything);
        return now.rail && now.rail->dimensions[index(Dimension::WT)].verdict == Verdict::Fail;
      },
      30000));
}

TEST(VirtualLine, ClosingTheWindowWhileMeasuringStopsCleanly) {
  auto line = VirtualLine::create(settings());
  ASSERT_TRUE(line) << line.error().message();
  Theme theme;
  Session session;
  Units units;
  Workplace place{theme, **line, session, units};
  MainWindow window(place);
  (*line)->start();
  window.show();
  window.startTicking();
  ASSERT_TRUE(QTest::qWaitFor([&] { return (*line)->pull(PullDetail::Profile).latest != nullptr; }, 30000));
  EXPECT_TRUE(window.close());
  EXPECT_TRUE(QTest::qWaitFor([&] { return !(*line)->running(); }, 10000));
}

}  // namespace
}  // namespace vignole
