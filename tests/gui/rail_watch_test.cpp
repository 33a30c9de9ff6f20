#include "gui/bridge/rail_watch.h"

#include <gtest/gtest.h>

#include "tests/gui/made_line.h"

namespace vignole {
namespace {

using namespace vignole::test;
using std::chrono::milliseconds;

class RailWatchTest : public ::testing::Test {
 protected:
  RailWatch watch{recipe(), "made"};
  InspectionObserver observer = watch.observer();
  LineSnapshot line = emptySnapshot();
  RailWatch::Clock::time_point now{};

  void pull(PullDetail detail = PullDetail::Everything) { watch.fill(line, detail, now); }
  void send(const MadeProfile& profile, int times, double fromM = 0) {
    for (int i = 0; i < times; ++i) {
      MadeProfile at = profile;
      at.positionM = fromM + 0.015 * i;
      observer.profileMeasured(makeProfile(at));
    }
  }
};

TEST_F(RailWatchTest, NothingBeforeTheFirstProfile) {
  pull();
  EXPECT_FALSE(line.latest);
  EXPECT_FALSE(line.rail);
  observer.railBegan(*madeRail());
  EXPECT_TRUE(watch.railUnderWay());
  pull();
  EXPECT_FALSE(line.rail);
}

TEST_F(RailWatchTest, ShowsTheNewestProfileAndTheRailSoFar) {
  observer.railBegan(*madeRail());
  send({}, 40);
  pull(PullDetail::Profile);
  ASSERT_TRUE(line.latest);
  EXPECT_NEAR(line.latest->profile.positionMm, 39 * 15, 1e-6);
  EXPECT_FALSE(line.rail) << "summaries come with Everything";
  pull();
  ASSERT_TRUE(line.rail);
  EXPECT_EQ(line.rail->profiles, 40U);
  EXPECT_EQ(line.rail->verdict, Verdict::Pass);
}

TEST_F(RailWatchTest, AgeGrowsWhenNothingComes) {
  observer.railBegan(*madeRail());
  send({}, 1);
  pull();
  EXPECT_EQ(line.ageS, 0);
  now += milliseconds(2500);
  pull();
  EXPECT_NEAR(line.ageS, 2.5, 1e-9);
  send({}, 1);
  pull();
  EXPECT_EQ(line.ageS, 0);
}

TEST_F(RailWatchTest, OneLostFrameIsNoLostCamera) {
  observer.railBegan(*madeRail());
  send({.lostCamera = 2}, 3);
  pull();
  EXPECT_TRUE(line.lostCameras.empty());
  EXPECT_EQ(line.recentIncomplete, 3U);
  send({.missing = {{Dimension::FTr, "no points"}}, .lostCamera = 2}, 20, 3.0);
  pull();
  ASSERT_EQ(line.lostCameras.size(), 1U);
  EXPECT_EQ(line.lostCameras[0].camera, 2);
  EXPECT_EQ(line.lostCameras[0].fromM, 0);
  EXPECT_EQ(line.lostCameras[0].reason, "frame lost");
  ASSERT_EQ(line.unmeasured.size(), 1U);
  EXPECT_EQ(line.unmeasured[0].dimension, Dimension::FTr);
  EXPECT_EQ(line.unmeasured[0].fromM, 3.0);
  send({}, 1);
  pull();
  EXPECT_TRUE(line.lostCameras.empty());
  EXPECT_TRUE(line.unmeasured.empty());
}

TEST_F(RailWatchTest, RatesCountProfilesNotPictures) {
  observer.railBegan(*madeRail());
  pull();
  for (int i = 0; i < 10; ++i) {
    now += milliseconds(150);
    send({}, 10);
    pull();
  }
  EXPECT_NEAR(line.profilesPerS, 66.67, 0.1);
  for (int i = 0; i < 30; ++i) {
    now += milliseconds(150);
    pull();
  }
  EXPECT_EQ(line.profilesPerS, 0);
}

TEST_F(RailWatchTest, PassedRailsAreKeptWithTheirVerdicts) {
  for (int rail = 1; rail <= 20; ++rail) {
    const auto begin = madeRail("V1-" + std::to_string(rail));
    observer.railBegan(*begin);
    const double wt = rail % 5 == 0 ? 1.4 : 0.1;
    for (int i = 0; i < 6; ++i) observer.profileMeasured(makeProfile({.deviationMm = {{Dimension::WT, wt}}}, begin));
    TriggerLedger ledger;
    ledger.seen = ledger.measured = 6;
    observer.railEnded(*begin, ledger);
  }
  pull();
  EXPECT_FALSE(watch.railUnderWay());
  EXPECT_EQ(line.railsPassed, 20U);
  EXPECT_EQ(line.railsGood, 16U);
  ASSERT_EQ(line.passed.size(), 12U);
  EXPECT_EQ(line.passed.back().id, "V1-20");
  EXPECT_EQ(line.passed.back().verdict, Verdict::Fail);
  EXPECT_EQ(line.passed.front().id, "V1-9");
}

TEST_F(RailWatchTest, TheEndIsTold) {
  EXPECT_FALSE(watch.ended());
  observer.ended("camera 2 went away");
  EXPECT_EQ(watch.ended(), "camera 2 went away");
  watch.restart();
  EXPECT_FALSE(watch.ended());
}

}  // namespace
}  // namespace vignole
