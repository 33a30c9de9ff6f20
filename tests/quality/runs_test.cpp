// Repeatability and accuracy: the paper's tables, and runs of known noise.

#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <random>

#include "engine/quality/accuracy.h"
#include "engine/quality/repeatability.h"
#include "tests/quality/published.h"

namespace vignole {
namespace {

TEST(Accuracy, OfThePaperIsThatOfItsTableV) {
  const auto table = CsvTable::load(testing::kQualityData / "paper_table_v_accuracy.csv");
  if (!table) GTEST_SKIP() << table.error().message();
  std::map<std::string, std::vector<AccuracyPoint>> points;
  for (std::size_t i = 0; i < table->rows(); ++i)
    for (std::size_t run = 1; run <= 5; ++run)
      points[table->text(i, 0)].push_back(
          {table->number(i, 1).value() / 1000, std::to_string(run), table->number(i, 1 + run).value(), 0, 0, 0});
  struct Row {
    std::string dimension;
    double bias, rms, max;
  };
  for (const Row& row :
       {Row{"HW", 0.0057, 0.0271, -0.06}, Row{"FW", -0.0037, 0.0289, -0.06}, Row{"RH", -0.1480, 0.1533, -0.2}}) {
    const auto r = accuracyStudy(points[row.dimension]);
    ASSERT_TRUE(r) << r.error().message();
    EXPECT_NEAR(r->whole.bias, row.bias, 6e-5) << row.dimension;
    EXPECT_NEAR(r->whole.rms, row.rms, 6e-5) << row.dimension;
    EXPECT_NEAR(r->whole.max, row.max, 1e-12) << row.dimension;
    EXPECT_EQ(r->whole.n, 30U);
    EXPECT_EQ(r->positions, 6U);
    EXPECT_EQ(r->runs, 5U);
    EXPECT_FALSE(r->whole.biasPercent) << "the reference of differences is 0";
  }
}

TEST(Accuracy, NormalisedErrorsAndPercent) {
  const auto r =
      accuracyStudy({{0, "1", 100.3, 100, 0.05, 0.05}, {0, "2", 100.1, 100, 0.05, 0.05}, {1, "1", 50, 50, 0, 0}});
  ASSERT_TRUE(r);
  ASSERT_EQ(r->en.size(), 2U) << "only where both uncertainties are known";
  EXPECT_NEAR(r->enMax, 0.3 / (2 * 0.05 * std::sqrt(2.0)), 1e-9);
  EXPECT_EQ(r->enBeyond1, 1U);
  EXPECT_NEAR(*r->whole.maxPercent, 0.3, 1e-9);
  EXPECT_NEAR(*r->whole.biasPercent, 100 * (0.4 / 3) / (250.0 / 3), 1e-9);
  EXPECT_FALSE(accuracyStudy({}));
}

TEST(Accuracy, BiasIntervalHoldsTheTruthAsOftenAsItSays) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> gauss;
  int inside = 0;
  for (int t = 0; t < 2000; ++t) {
    std::vector<AccuracyPoint> points;
    for (int p = 0; p < 8; ++p) {
      const double here = 0.05 * gauss(random);  // shared by the runs: the position's own error
      for (int run = 0; run < 5; ++run)
        points.push_back({1.0 * p, std::to_string(run), 72.1 + here + 0.01 * gauss(random), 72, 0, 0});
    }
    const auto r = accuracyStudy(points);
    inside += r->biasInterval->low <= 0.1 && r->biasInterval->high >= 0.1 ? 1 : 0;
  }
  EXPECT_NEAR(inside, 1900, 40);
}

/// Runs over the same rail: it varies along its length, every value has its own noise.
std::vector<RepeatabilityRun> runs(std::size_t count, std::size_t positions, double sigma, double startShiftM,
                                   unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> gauss(0, sigma);
  std::vector<RepeatabilityRun> list;
  for (std::size_t r = 0; r < count; ++r) {
    RepeatabilityRun run{"run" + std::to_string(r + 1), {}, {}};
    for (std::size_t i = 0; i < positions; ++i) {
      const double at = 0.015 * static_cast<double>(i) + startShiftM * static_cast<double>(r);
      run.positionM.push_back(at);
      run.valueMm.push_back(72 + 0.1 * std::sin(at) + gauss(random));
    }
    list.push_back(run);
  }
  return list;
}

TEST(Repeatability, FindsTheNoiseUnderTheShapeOfTheRail) {
  const auto r = repeatabilityStudy(runs(5, 4000, 0.02, 0, 1));
  ASSERT_TRUE(r) << r.error().message();
  EXPECT_EQ(r->positionM.size(), 4000U);
  EXPECT_EQ(r->degrees, 16000);
  EXPECT_LE(r->srIntervalMm.low, 0.02);
  EXPECT_GE(r->srIntervalMm.high, 0.02);
  EXPECT_NEAR(r->meanRangeMm, 2.326 * 0.02, 0.001);
  EXPECT_NEAR(r->srFromRangeMm, 0.02, 4e-4);
  EXPECT_NEAR(r->rMm, 2.8 * r->srMm, 1e-12);
  EXPECT_NEAR(r->autocorrelation, 0, 0.05);
  ASSERT_EQ(r->sections.size(), 6U) << "60 m by 10 m";
  for (const RepeatabilitySection& s : r->sections) EXPECT_NEAR(s.meanRangeMm, 2.326 * 0.02, 0.003);
  EXPECT_EQ(r->sections[5].toM, 60);
  EXPECT_EQ(r->grubbsRuns->standout, Standout::None);
}

TEST(Repeatability, ByHand) {
  const auto r = repeatabilityStudy({{"a", {5, 10, 15}, {1, 2, 3}}, {"b", {5, 10, 15}, {1.2, 2.1, 2.6}}});
  ASSERT_TRUE(r) << r.error().message();
  ASSERT_EQ(r->sections.size(), 2U);
  EXPECT_EQ(r->sections[0].positions, 2U) << "(0, 10] holds its end";
  EXPECT_NEAR(r->sections[0].meanRangeMm, 0.15, 1e-12);
  EXPECT_NEAR(r->sections[1].meanRangeMm, 0.4, 1e-12);
  EXPECT_NEAR(r->srMm, std::sqrt((0.02 + 0.005 + 0.08) / 3), 1e-12);
  EXPECT_EQ(r->runs, (std::vector<std::string>{"a", "b"}));
}

TEST(Repeatability, WindowsAverageTheNoiseAway) {
  const auto single = repeatabilityStudy(runs(5, 4000, 0.02, 0, 2));
  RepeatabilitySettings settings;
  settings.windowM = 0.5;
  const auto windows = repeatabilityStudy(runs(5, 4000, 0.02, 0, 2), settings);
  ASSERT_TRUE(single && windows);
  EXPECT_EQ(windows->positionM.size(), 120U);
  EXPECT_NEAR(windows->srMm, single->srMm / std::sqrt(0.5 / 0.015), 3e-4);
}

TEST(Repeatability, AlignsByLengthAndCountsWhatHasNoPartner) {
  auto list = runs(3, 400, 0.001, 0.004, 3);  // each run begins 4 mm later: within half the spacing
  const auto r = repeatabilityStudy(list);
  ASSERT_TRUE(r) << r.error().message();
  EXPECT_NEAR(static_cast<double>(r->positionM.size() + r->dropped), 400, 0);
  EXPECT_LT(r->srMm, 0.0015);
  list[1].valueMm[7] = std::nan("");
  EXPECT_EQ(repeatabilityStudy(list)->dropped, r->dropped + 1) << "not measured in one run";
  for (double& at : list[2].positionM) at += 1000;
  EXPECT_FALSE(repeatabilityStudy(list)) << "nothing in common";
  EXPECT_FALSE(repeatabilityStudy({list[0]}));
  list[0].positionM[1] = list[0].positionM[0];
  EXPECT_NE(repeatabilityStudy(list).error().message().find("twice"), std::string::npos);
}

TEST(Repeatability, ARunThatStandsApartIsFound) {
  auto list = runs(6, 400, 0.002, 0, 4);
  for (double& v : list[2].valueMm) v += 0.05;
  const auto r = repeatabilityStudy(list);
  ASSERT_TRUE(r);
  EXPECT_EQ(r->grubbsRuns->standout, Standout::Outlier);
  EXPECT_EQ(r->grubbsRuns->where, std::vector<std::size_t>{2});
  EXPECT_GT(r->sections[0].consistency->h[2], r->sections[0].consistency->h1);
  std::mt19937_64 random(9);
  std::normal_distribution<double> rough(0, 0.02);
  list = runs(6, 400, 0.002, 0, 4);
  for (double& v : list[4].valueMm) v += rough(random);
  const auto s = repeatabilityStudy(list);
  EXPECT_EQ(s->cochranRuns->where, std::vector<std::size_t>{4});
  EXPECT_EQ(s->cochranRuns->standout, Standout::Outlier);
}

}  // namespace
}  // namespace vignole
