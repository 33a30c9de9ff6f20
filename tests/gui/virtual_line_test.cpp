#include "gui/bridge/virtual_line.h"

#include <QAbstractButton>
#include <QMessageBox>
#include <QTest>
#include <algorithm>
#include <cmath>
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

TEST(VirtualLine, OtherStripeSettingsComeWithTheNextRailAndNoRailIsCutShort) {
  VirtualLineSettings s = settings();
  s.railLengthMm = 1500;
  auto line = VirtualLine::create(s);
  ASSERT_TRUE(line) << line.error().message();
  (*line)->start();
  ASSERT_TRUE(waitForState(**line, LineState::Measuring));
  StripeSettings wanted = s.recipe.stripe;
  wanted.sigma = 3.4;
  const std::uint64_t before = (*line)->pull(PullDetail::Everything).railsPassed;
  (*line)->useStripeSettings(wanted);
  {
    const LineSnapshot& now = (*line)->pull(PullDetail::Everything);
    ASSERT_TRUE(now.nextStripe);
    EXPECT_NE(now.recipe->stripe.sigma, 3.4) << "the running rail keeps what it began with";
  }
  bool always = true;
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        const LineSnapshot& now = (*line)->pull(PullDetail::Everything);
        always = always && (*line)->running() && now.state != LineState::Stopped && now.state != LineState::Fault;
        return now.recipe->stripe.sigma == 3.4 && !now.nextStripe;
      },
      30000));
  EXPECT_TRUE(always) << "the line never looks stopped between the two";
  EXPECT_GT((*line)->pull(PullDetail::Everything).railsPassed, before);
  ASSERT_TRUE(QTest::qWaitFor([&] { return (*line)->pull(PullDetail::Everything).railsPassed >= before + 3; }, 30000));
  const LineSnapshot& after = (*line)->pull(PullDetail::Everything);
  for (std::size_t i = 0; i < after.passed.size(); ++i)
    EXPECT_EQ(after.passed[i].id, "V1-" + std::to_string(i + 1)) << "no rail is left out or seen twice";
  EXPECT_EQ(after.triggers.seen, after.triggers.measured + after.triggers.incomplete + after.triggers.lost);
}

TEST(VirtualLine, AnotherRecipeComesWithTheNextRailWhetherItsSectionIsTheSameOrNot) {
  VirtualLineSettings s = settings();
  s.railLengthMm = 1500;
  auto line = VirtualLine::create(s);
  ASSERT_TRUE(line) << line.error().message();
  (*line)->start();
  ASSERT_TRUE(waitForState(**line, LineState::Measuring));
  for (const char* section : {"60E1", "54E1"}) {
    auto other = *makeRecipe(section, "Y", "B");
    other.version = 4;
    const std::string before = (*line)->pull(PullDetail::Everything).recipe->name;
    ASSERT_TRUE((*line)->useRecipe(other));
    EXPECT_EQ((*line)->pull(PullDetail::Everything).recipe->name, before) << "the running rail keeps its own";
    bool always = true;
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
          const LineSnapshot& now = (*line)->pull(PullDetail::Everything);
          always = always && (*line)->running() && now.state != LineState::Stopped && now.state != LineState::Fault;
          return now.recipe->name == other.name && now.nextRecipe.empty() && now.latest && now.rail &&
                 now.rail->dimensions[index(Dimension::RH)].values.count() > 3;
        },
        30000))
        << section;
    EXPECT_TRUE(always) << "nobody has to stop and start";
    const LineSnapshot& now = (*line)->pull(PullDetail::Everything);
    EXPECT_EQ(now.latest->rail->sectionName, section);
    EXPECT_NEAR(now.rail->dimensions[index(Dimension::RH)].meanMm(),
                now.rail->dimensions[index(Dimension::RH)].nominalMm, 1.5);
  }
}

TEST(VirtualLine, AChangeThatAStopOvertakesComesWithTheNextStart) {
  auto line = VirtualLine::create(settings());
  ASSERT_TRUE(line) << line.error().message();
  (*line)->start();
  ASSERT_TRUE(waitForState(**line, LineState::Measuring));
  StripeSettings wanted = settings().recipe.stripe;
  wanted.sigma = 3.4;
  (*line)->useStripeSettings(wanted);
  (*line)->stop();
  ASSERT_TRUE(waitForState(**line, LineState::Stopped));
  EXPECT_FALSE((*line)->running());
  (*line)->start();
  ASSERT_TRUE(waitForState(**line, LineState::Measuring));
  EXPECT_EQ((*line)->pull(PullDetail::Everything).recipe->stripe.sigma, 3.4);
}

TEST(VirtualLine, APictureMadeAgainIsTheOneThatWasMeasured) {
  auto line = VirtualLine::create(settings());
  ASSERT_TRUE(line) << line.error().message();
  const auto frames = (*line)->frames();
  const FramesWatcher watcher(frames);
  (*line)->start();
  ASSERT_TRUE(QTest::qWaitFor([&] { return frames->latest(2) != nullptr; }, 30000));
  const auto held = frames->latest(2);
  const ImageView& was = held->frame.image;
  EXPECT_FALSE(held->stripe.points.empty());
  const auto again = (*line)->pictureAgain()(2, held->frame.trigger, 0);
  ASSERT_TRUE(again);
  ASSERT_EQ(again->image.width, was.width);
  bool equal = true;
  for (int y = 0; y < was.height; ++y)
    equal = equal && std::equal(was.row(y), was.row(y) + was.width, again->image.row(y));
  EXPECT_TRUE(equal);
  const auto darker = (*line)->pictureAgain()(2, held->frame.trigger, 5);
  ASSERT_TRUE(darker);
  const auto sum = [](const ImageView& image) {
    std::uint64_t total = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) total += image.row(y)[x];
    return total;
  };
  EXPECT_LT(sum(darker->image), sum(again->image));
}

TEST(VirtualLine, MeasuresWithAnotherCalibrationFromTheNextStartOn) {
  auto line = VirtualLine::create(settings());
  ASSERT_TRUE(line) << line.error().message();
  RigCalibration other = (*line)->calibration();
  const std::string exact = other.id;
  (*line)->start();
  ASSERT_TRUE(waitForState(**line, LineState::Measuring));
  ASSERT_TRUE(QTest::qWaitFor([&] { return (*line)->pull(PullDetail::Everything).rail != nullptr; }, 30000));
  other.id = "rig-of-a-test";
  other.method = "joint";
  other.rangeFinders[1].cameraFromWorld.translationMm += Eigen::Vector3d(1.5, 0, 0);
  (*line)->useCalibration(other);
  EXPECT_EQ((*line)->calibration().id, other.id);
  EXPECT_EQ((*line)->pull(PullDetail::Everything).rail->calibrationId, exact) << "the running rail keeps its own";
  EXPECT_NE((*line)->pull(PullDetail::Everything).calibrationMethod, "joint");
  const double before = (*line)->pull(PullDetail::Everything).rail->dimensions[index(Dimension::FTr)].meanMm();
  (*line)->stop();
  ASSERT_TRUE(waitForState(**line, LineState::Stopped));
  (*line)->start();
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        const LineSnapshot& now = (*line)->pull(PullDetail::Everything);
        return now.state == LineState::Measuring && now.rail && now.rail->calibrationId == other.id &&
               now.rail->dimensions[index(Dimension::FTr)].values.count() > 5;
      },
      30000));
  const LineSnapshot& now = (*line)->pull(PullDetail::Everything);
  EXPECT_EQ(now.calibrationMethod, "joint");
  EXPECT_GT(std::abs(now.rail->dimensions[index(Dimension::FTr)].meanMm() - before), 0.2)
      << "the camera stands elsewhere";
  ASSERT_TRUE(now.drift);
  EXPECT_TRUE(now.drift->latest.learning);
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
  EXPECT_FALSE(window.close()) << "asks first";
  ASSERT_NE(window.question(), nullptr);
  for (QAbstractButton* button : window.question()->buttons())
    if (button->accessibleName() == "Close now") button->click();
  EXPECT_FALSE(window.isVisible());
  EXPECT_TRUE(QTest::qWaitFor([&] { return !(*line)->running(); }, 10000));
}

}  // namespace
}  // namespace vignole
