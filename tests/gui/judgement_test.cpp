#include "gui/monitor/judgement.h"

#include <gtest/gtest.h>

#include "tests/gui/made_line.h"

namespace vignole {
namespace {

using namespace vignole::test;

TEST(Judgement, WaitsWithoutARail) {
  const VerdictText text = railVerdict(emptySnapshot());
  EXPECT_EQ(text.word, QStringLiteral("Waiting for a rail"));
}

TEST(Judgement, AGoodRailSaysHowFarItIsGood) {
  const LineSnapshot line = makeSnapshot();
  const VerdictText text = railVerdict(line);
  EXPECT_EQ(text.symbol, StateSymbol::Good);
  EXPECT_TRUE(text.sentence.contains("41.37 m")) << text.sentence.toStdString();
  EXPECT_TRUE(text.sentence.startsWith("11 dimensions within limits")) << text.sentence.toStdString();
  EXPECT_EQ(gaugeTrust(line).symbol, StateSymbol::Good);
}

TEST(Judgement, OutOfToleranceNamesDimensionExcessAndPlace) {
  const LineSnapshot line = makeSnapshot({.deviationMm = {{Dimension::WT, 1.032}}});
  const VerdictText text = railVerdict(line);
  EXPECT_EQ(text.symbol, StateSymbol::Out);
  EXPECT_TRUE(text.sentence.startsWith("WT 0.032 above the limit from 0.0 m on")) << text.sentence.toStdString();
  EXPECT_EQ(worstOutside(line), Dimension::WT);
}

TEST(Judgement, BelowTheLowerLimitSaysBelow) {
  const VerdictText text = railVerdict(makeSnapshot({.deviationMm = {{Dimension::FW, -1.4}}}));
  EXPECT_TRUE(text.sentence.startsWith("FW 0.400 below the limit")) << text.sentence.toStdString();
}

TEST(Judgement, NearLimitIsNeitherGoodNorOut) {
  const VerdictText text = railVerdict(makeSnapshot({.deviationMm = {{Dimension::RASl, 1.19}}}));
  EXPECT_EQ(text.symbol, StateSymbol::Near);
  EXPECT_TRUE(text.sentence.startsWith("RAS_l 0.010 inside the limit")) << text.sentence.toStdString();
}

TEST(Judgement, ALostCameraMakesTheRailNotValidAndTheGaugeNotTrusted) {
  const LineSnapshot line = makeSnapshot(
      {.missing = {{Dimension::RFH, "SHBR has 0 points"}, {Dimension::FTr, "SBB ends early"}}, .lostCamera = 2});
  const VerdictText text = railVerdict(line);
  EXPECT_EQ(text.symbol, StateSymbol::NotMeasured);
  EXPECT_EQ(text.sentence, QStringLiteral("RFH and FT_r not measured from 23.18 m on: camera 3 lost"));
  EXPECT_EQ(gaugeTrust(line).word, QStringLiteral("Not trusted"));
  EXPECT_TRUE(gaugeTrust(line).cameras.startsWith("3 of 4 cameras"));
}

TEST(Judgement, AStoppedLineHoldsItsValuesWithTheirAge) {
  const VerdictText text = railVerdict(heldSnapshot(134));
  EXPECT_TRUE(text.held);
  EXPECT_TRUE(text.sentence.contains("41.37 m")) << text.sentence.toStdString();
  EXPECT_TRUE(text.sentence.contains("2 min 14 s ago")) << text.sentence.toStdString();
}

TEST(Judgement, SilenceWithARailInTheGaugeMakesItNotValid) {
  LineSnapshot line = makeSnapshot();
  line.state = LineState::Silent;
  line.ageS = 3;
  EXPECT_TRUE(line.held());
  EXPECT_EQ(railVerdict(line).word, QStringLiteral("Not valid")) << "its head was good, the rest passes unseen";
  EXPECT_FALSE(gaugeTrust(line).cameras.contains("4 of 4"));
}

TEST(Judgement, ManyIncompleteTriggersDegradeTheGauge) {
  LineSnapshot line = makeSnapshot();
  line.recentIncomplete = line.rail->profiles / 10;
  EXPECT_EQ(gaugeTrust(line).word, QStringLiteral("Degraded"));
}

TEST(LimitShare, HfIsJudgedByItsSmallestAndFcByWhatIsHollow) {
  DimensionResult hf;
  hf.valueMm = 0.1;
  hf.secondMm = -0.24;
  hf.lowerMm = -0.3;
  hf.upperMm = 0.6;
  EXPECT_NEAR(*limitShare(Dimension::HF, hf), 0.8, 1e-12);
  DimensionResult fc;
  fc.valueMm = -0.9;
  fc.upperMm = 0.3;
  EXPECT_NEAR(*limitShare(Dimension::FC, fc), 0, 1e-12);
  EXPECT_FALSE(limitShare(Dimension::FC, DimensionResult{}));
}

TEST(NearestToLimits, RanksByShareAndKeepsPlaces) {
  const LineSnapshot line = makeSnapshot({.deviationMm = {{Dimension::WT, 0.9}, {Dimension::RASl, 0.8}}});
  const auto first = nearestToLimits(line, 2, {});
  EXPECT_EQ(first, (std::vector{Dimension::WT, Dimension::RASl}));
  // Shown the other way round they stay where they are.
  const std::vector<Dimension> swapped{Dimension::RASl, Dimension::WT};
  EXPECT_EQ(nearestToLimits(line, 2, swapped), swapped);
  // FW comes a little nearer than RAS_l: not enough to throw it out; then clearly nearer.
  const LineSnapshot little =
      makeSnapshot({.deviationMm = {{Dimension::WT, 0.9}, {Dimension::RASl, 0.8}, {Dimension::FW, 0.72}}});
  EXPECT_EQ(nearestToLimits(little, 2, swapped), swapped);
  const LineSnapshot clear =
      makeSnapshot({.deviationMm = {{Dimension::WT, 0.9}, {Dimension::RASl, 0.8}, {Dimension::FW, 0.89}}});
  EXPECT_EQ(nearestToLimits(clear, 2, swapped), (std::vector{Dimension::FW, Dimension::WT}));
}

}  // namespace
}  // namespace vignole
