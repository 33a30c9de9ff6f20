#include "engine/quality/outliers.h"

#include <gtest/gtest.h>
#include <random>

#include "engine/quality/chart_constants.h"
#include "engine/quality/precision.h"
#include "tests/quality/published.h"

namespace vignole {
namespace {

/// Printed tables 4 to 7 of ISO 5725-2, three or two decimals.
TEST(OutlierTests, CriticalValuesAreThoseOfIso5725) {
  EXPECT_NEAR(grubbsCritical(5, 0.05), 1.715, 6e-4);
  EXPECT_NEAR(grubbsCritical(5, 0.01), 1.764, 6e-4);
  EXPECT_NEAR(grubbsCritical(10, 0.05), 2.290, 6e-4);
  EXPECT_NEAR(grubbsCritical(20, 0.01), 3.001, 6e-4);
  EXPECT_NEAR(cochranCritical(5, 2, 0.05), 0.841, 6e-4);
  EXPECT_NEAR(cochranCritical(5, 2, 0.01), 0.928, 6e-4);
  EXPECT_NEAR(cochranCritical(10, 2, 0.05), 0.602, 6e-4);
  EXPECT_NEAR(cochranCritical(5, 3, 0.05), 0.684, 6e-4);
  const std::vector<double> means = {1, 2, 3, 4, 6}, sds = {1, 1, 1, 1, 1};
  const auto m = mandel(means, sds, 2);
  ASSERT_TRUE(m);
  EXPECT_NEAR(m->h5, 1.57, 6e-3);
  EXPECT_NEAR(m->h1, 1.72, 6e-3);
  EXPECT_NEAR(m->k5, 1.81, 6e-3);
  EXPECT_NEAR(m->k1, 2.05, 6e-3);
  EXPECT_NEAR(m->k[0], 1, 1e-15) << "all scatter alike";
}

TEST(OutlierTests, CryWolfAsOftenAsTheySay) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> gauss(100, 0.1);
  constexpr int kTrials = 40000;
  for (const std::size_t n : {5U, 12U}) {
    int one = 0, two = 0, spread = 0;
    std::vector<double> values(n), variances(n);
    for (int t = 0; t < kTrials; ++t) {
      for (double& v : values) v = gauss(random);
      for (double& v : variances) {
        const double d = gauss(random) - gauss(random);
        v = d * d / 2;
      }
      one += grubbs(values)->standout != Standout::None ? 1 : 0;
      two += doubleGrubbs(values)->standout != Standout::None ? 1 : 0;
      spread += cochran(variances, 2)->standout != Standout::None ? 1 : 0;
    }
    EXPECT_NEAR(one, 0.05 * kTrials, 250) << n;
    EXPECT_NEAR(two, 0.05 * kTrials, 250) << n;
    EXPECT_NEAR(spread, 0.05 * kTrials, 250) << n;
  }
}

TEST(OutlierTests, NameTheSuspects) {
  const std::vector<double> one = {10.1, 10.0, 9.9, 10.05, 9.95, 12};
  const auto g = grubbs(one);
  ASSERT_TRUE(g);
  EXPECT_EQ(g->standout, Standout::Outlier);
  EXPECT_EQ(g->where, std::vector<std::size_t>{5});
  const std::vector<double> pair = {10.1, 7.0, 9.9, 10.05, 9.95, 7.1, 10, 10.02};
  EXPECT_EQ(grubbs(pair)->standout, Standout::None) << "two mask each other";
  const auto d = doubleGrubbs(pair);
  ASSERT_TRUE(d);
  EXPECT_EQ(d->standout, Standout::Outlier);
  EXPECT_EQ(d->where, (std::vector<std::size_t>{1, 5}));
  const std::vector<double> variances = {1, 1.2, 0.9, 30, 1.1};
  EXPECT_EQ(cochran(variances, 4)->where, std::vector<std::size_t>{3});
  EXPECT_EQ(cochran(variances, 4)->standout, Standout::Outlier);
  const std::vector<double> same = {1, 1, 1, 1}, none = {0, 0};
  EXPECT_FALSE(grubbs(same));
  EXPECT_FALSE(doubleGrubbs(same));
  EXPECT_FALSE(cochran(none, 3));
}

TEST(Precision, GroupsOfDifferentSize) {
  // By hand: means 1, 3, 5; within 2 + 0 + 8 = 10 over 1 + 1 + 2 = 4 degrees; N = 7, n = (7 - 17/7) / 2 = 16/7.
  const auto r = precisionStudy({{"a", {0, 2}}, {"b", {3, 3}}, {"c", {3, 5, 7}}});
  ASSERT_TRUE(r) << r.error().message();
  EXPECT_NEAR(r->msWithin, 2.5, 1e-14);
  const double mean = 23.0 / 7;
  const double between = (2 * (1 - mean) * (1 - mean) + 2 * (3 - mean) * (3 - mean) + 3 * (5 - mean) * (5 - mean)) / 2;
  EXPECT_NEAR(r->msBetween, between, 1e-13);
  EXPECT_NEAR(r->sL * r->sL, (between - 2.5) / (16.0 / 7), 1e-13);
  EXPECT_NEAR(r->sR * r->sR, r->sr * r->sr + r->sL * r->sL, 1e-13);
  EXPECT_FALSE(r->cochranTest) << "needs groups of one size";
  EXPECT_FALSE(precisionStudy({{"a", {1, 2}}}));
  EXPECT_FALSE(precisionStudy({{"a", {1}}, {"b", {2}}}));
}

TEST(ChartConstants, AreThePrintedOnes) {
  const auto table = CsvTable::load(testing::kQualityData / "control_chart_constants.csv");
  if (!table) GTEST_SKIP() << table.error().message();
  for (std::size_t row = 0; row < table->rows(); ++row) {
    const auto at = [&](const char* column) { return table->number(row, *table->column(column)).value(); };
    const int n = static_cast<int>(at("n"));
    const ChartConstants c = chartConstants(n, ConstantPrecision::Exact);
    EXPECT_NEAR(c.d2, at("d2"), 6e-6) << n;
    EXPECT_NEAR(c.d3, at("d3"), 6e-6) << n;
    EXPECT_NEAR(c.c4, at("c4"), 6e-6) << n;
    EXPECT_NEAR(c.a2, at("A2"), 6e-6) << n;
    EXPECT_NEAR(c.d3Limit, at("D3"), 6e-6) << n;
    EXPECT_NEAR(c.d4Limit, at("D4"), 6e-6) << n;
    EXPECT_NEAR(c.a3, at("A3"), 6e-6) << n;
    EXPECT_NEAR(c.b3Limit, at("B3"), 6e-6) << n;
    EXPECT_NEAR(c.b4Limit, at("B4"), 6e-6) << n;
  }
}

/// AIAG MSA: K1 for 2 and 3 trials, K2 for 2 and 3 appraisers, K3 for 2 to 10 parts.
TEST(ChartConstants, GiveTheConstantsOfTheGaugeStudy) {
  EXPECT_EQ(rounded(1 / chartConstants(2, ConstantPrecision::Exact).d2, 4), 0.8862);
  EXPECT_EQ(rounded(1 / chartConstants(3, ConstantPrecision::Exact).d2, 4), 0.5908);
  const std::vector<double> k = {0.7071, 0.5231, 0.4467, 0.4030, 0.3742, 0.3534, 0.3375, 0.3249, 0.3146};
  for (std::size_t i = 0; i < k.size(); ++i)
    EXPECT_NEAR(1 / averageRangeConstant(static_cast<int>(i) + 2, 1), k[i], 6e-5) << i + 2;
}

TEST(ChartConstants, TabulatedAreThoseOfTheTables) {
  const ChartConstants two = chartConstants(2, ConstantPrecision::Tabulated);
  EXPECT_EQ(two.d2, 1.128);
  EXPECT_EQ(two.d4Limit, 3.267);
  const ChartConstants five = chartConstants(5, ConstantPrecision::Tabulated);
  EXPECT_EQ(five.d2, 2.326);
  EXPECT_EQ(five.a2, 0.577);
  EXPECT_EQ(five.c4, 0.9400);
}

}  // namespace
}  // namespace vignole
