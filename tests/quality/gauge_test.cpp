// Linearity, gauge studies beyond the published one, agreement.

#include "engine/quality/gauge.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "engine/quality/agreement.h"
#include "engine/quality/gauge_rr.h"

namespace vignole {
namespace {

/// AIAG MSA, worked example of linearity: 5 references, 12 values each.
TEST(Linearity, OfTheAiagExample) {
  const std::vector<std::vector<double>> values = {{2.7, 2.5, 2.4, 2.5, 2.7, 2.3, 2.5, 2.5, 2.4, 2.4, 2.6, 2.4},
                                                   {5.1, 3.9, 4.2, 5.0, 3.8, 3.9, 3.9, 3.9, 3.9, 4.0, 4.1, 3.8},
                                                   {5.8, 5.7, 5.9, 5.9, 6.0, 6.1, 6.0, 6.1, 6.4, 6.3, 6.0, 6.1},
                                                   {7.6, 7.7, 7.8, 7.7, 7.8, 7.8, 7.8, 7.7, 7.8, 7.5, 7.6, 7.7},
                                                   {9.1, 9.3, 9.5, 9.3, 9.4, 9.5, 9.5, 9.5, 9.6, 9.2, 9.3, 9.4}};
  std::vector<double> reference, value;
  for (std::size_t i = 0; i < values.size(); ++i)
    for (const double v : values[i]) {
      reference.push_back(2.0 * static_cast<double>(i + 1));
      value.push_back(v);
    }
  const auto r = linearityStudy(reference, value);
  ASSERT_TRUE(r) << r.error().message();
  EXPECT_NEAR(r->line.slope, -0.13167, 5e-6);
  EXPECT_NEAR(r->line.intercept, 0.73667, 5e-6);
  EXPECT_NEAR(r->line.sdResidual, 0.23954, 5e-6);
  EXPECT_NEAR(r->line.r2, 0.714, 5e-4);
  EXPECT_NEAR(r->line.tSlope, -12.043, 5e-4);
  EXPECT_NEAR(r->line.tIntercept, 10.158, 5e-4);
  const std::vector<double> bias = {0.491667, 0.125, 0.025, -0.291667, -0.616667};
  for (std::size_t i = 0; i < bias.size(); ++i) EXPECT_NEAR(r->levels[i].bias.mean, bias[i], 5e-7);
  EXPECT_FALSE(r->zeroInBand) << "the gauge has a linearity problem";
  EXPECT_NEAR(r->percentLinearity, 13.167, 5e-4);
}

TEST(Linearity, OfAGoodGaugeIsAccepted) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> gauss(0, 0.01);
  std::vector<double> reference, value;
  for (int i = 0; i < 50; ++i) {
    reference.push_back(10.0 * (1 + i / 10));
    value.push_back(reference.back() + gauss(random));
  }
  EXPECT_TRUE(linearityStudy(reference, value)->zeroInBand);
}

std::vector<GaugeReading> crossed(int parts, int operators, int trials, double part, double oper, double interaction,
                                  double noise, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> gauss;
  std::vector<double> p(static_cast<std::size_t>(parts)), o(static_cast<std::size_t>(operators));
  for (double& v : p) v = part * gauss(random);
  for (double& v : o) v = oper * gauss(random);
  std::vector<GaugeReading> list;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < o.size(); ++j) {
      const double both = interaction * gauss(random);
      for (int t = 0; t < trials; ++t)
        list.push_back({std::to_string(i), std::to_string(j), 1000 + p[i] + o[j] + both + noise * gauss(random)});
    }
  return list;
}

TEST(GaugeStudy, RecoversKnownComponents) {
  const auto r = grrStudy(crossed(200, 40, 3, 1.0, 0.3, 0.2, 0.1, 1));
  ASSERT_TRUE(r) << r.error().message();
  EXPECT_FALSE(r->pooledMs) << "the interaction is there";
  EXPECT_NEAR(r->repeatability.sd, 0.1, 0.002);
  EXPECT_NEAR(r->interaction.sd, 0.2, 0.005);
  EXPECT_NEAR(r->operatorAlone.sd, 0.3, 0.08);
  EXPECT_NEAR(r->part.sd, 1.0, 0.1);
  EXPECT_NEAR(r->reproducibility.sd, std::hypot(r->operatorAlone.sd, r->interaction.sd), 1e-12);
  EXPECT_NEAR(r->grr.percentContribution + r->part.percentContribution, 100, 1e-9);
}

TEST(GaugeStudy, SumsOfSquaresAddUp) {
  for (const GrrMethod method : {GrrMethod::Anova, GrrMethod::Nested}) {
    GrrSettings settings;
    settings.method = method;
    const auto list = crossed(7, 3, 2, 1, 0.5, 0.5, 0.2, 2);
    const auto r = grrStudy(list, settings);
    ASSERT_TRUE(r);
    std::vector<double> all;
    for (const GaugeReading& g : list) all.push_back(g.value);
    EXPECT_NEAR(r->anova.back().ss, describe(all).sumOfSquares, 1e-9);
    double degrees = 0;
    for (std::size_t i = 0; i + 1 < r->anova.size(); ++i) degrees += r->anova[i].degrees;
    EXPECT_EQ(degrees, r->anova.back().degrees);
  }
}

TEST(GaugeStudy, NestedRecoversKnownComponents) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> gauss;
  std::vector<GaugeReading> list;
  for (int o = 0; o < 60; ++o) {
    const double oper = 0.4 * gauss(random);
    for (int p = 0; p < 20; ++p) {
      const double part = 1.0 * gauss(random);
      // Operators give their parts the same numbers: they are other parts all the same.
      for (int t = 0; t < 2; ++t)
        list.push_back({std::to_string(p), std::to_string(o), oper + part + 0.1 * gauss(random)});
    }
  }
  GrrSettings settings;
  settings.method = GrrMethod::Nested;
  const auto r = grrStudy(list, settings);
  ASSERT_TRUE(r) << r.error().message();
  EXPECT_NEAR(r->repeatability.sd, 0.1, 0.004);
  EXPECT_NEAR(r->part.sd, 1.0, 0.05);
  EXPECT_NEAR(r->reproducibility.sd, 0.4, 0.1);
}

TEST(GaugeStudy, LargeOffsetsTakeNothing) {
  auto list = crossed(5, 3, 3, 1, 0.5, 0, 0.25, 4);
  for (GaugeReading& g : list) g.value = std::round((g.value - 1000) * 1024) / 1024;  // exact at any offset below 2^42
  const auto near = grrStudy(list);
  for (GaugeReading& g : list) g.value += 1e9;
  const auto far = grrStudy(list);
  ASSERT_TRUE(near && far);
  EXPECT_NEAR(far->repeatability.sd, near->repeatability.sd, 1e-12);
  EXPECT_NEAR(far->part.sd, near->part.sd, 1e-12);
}

TEST(GaugeStudy, OneSetUpHasNoReproducibility) {
  const auto r = grrStudy(crossed(10, 1, 3, 1, 0, 0, 0.1, 5));
  ASSERT_TRUE(r) << r.error().message();
  EXPECT_EQ(r->reproducibility.sd, 0);
  EXPECT_EQ(r->grr.sd, r->repeatability.sd);
  EXPECT_GT(r->part.sd, 0.4);
}

TEST(GaugeStudy, NamesTheCellThatIsMissing) {
  auto list = crossed(3, 2, 2, 1, 1, 0, 1, 6);
  list.pop_back();
  EXPECT_NE(grrStudy(list).error().message().find("part 2, operator 1"), std::string::npos)
      << grrStudy(list).error().message();
  list.pop_back();
  EXPECT_NE(grrStudy(list).error().message().find("has 0 trials"), std::string::npos);
  EXPECT_FALSE(grrStudy({}));
  EXPECT_FALSE(grrStudy(crossed(5, 2, 1, 1, 1, 0, 1, 7))) << "one trial";
}

TEST(Type1, WithoutToleranceOrSpreadHasNoCapability) {
  const std::vector<double> same = {2, 2, 2}, few = {1};
  Type1Settings settings;
  settings.reference = 2;
  EXPECT_FALSE(type1Study(same, settings)->cg);
  settings.tolerance = 1;
  EXPECT_FALSE(type1Study(same, settings)->cg) << "no spread: infinite";
  EXPECT_EQ(type1Study(same, settings)->p, 1);
  EXPECT_FALSE(type1Study(few, settings));
}

/// Bland, Altman 1986: peak flow by two meters, first readings.
TEST(Agreement, OfThePeakFlowMeters) {
  const std::vector<double> large = {494, 395, 516, 434, 476, 557, 413, 442, 650,
                                     433, 417, 656, 267, 478, 178, 423, 427};
  const std::vector<double> mini = {512, 430, 520, 428, 500, 600, 364, 380, 658,
                                    445, 432, 626, 260, 477, 259, 350, 451};
  BlandAltmanSettings settings;
  settings.sigmas = 2;
  settings.method = LimitsMethod::BlandAltman1986;
  const auto r = agreementStudy(large, mini, settings);
  ASSERT_TRUE(r) << r.error().message();
  const BlandAltman& d = r->differences;
  EXPECT_NEAR(d.bias, -2.1, 0.05);
  EXPECT_NEAR(d.sd, 38.8, 0.05);
  EXPECT_NEAR(d.limits.low, -79.7, 0.1);
  EXPECT_NEAR(d.limits.high, 75.5, 0.1);
  EXPECT_NEAR(d.biasInterval.low, -22.0, 0.1);
  EXPECT_NEAR(d.biasInterval.high, 17.8, 0.1);
  EXPECT_NEAR(d.lowerInterval.low, -114.3, 0.3);
  EXPECT_NEAR(d.lowerInterval.high, -45.1, 0.3);
  EXPECT_NEAR(d.upperInterval.low, 40.9, 0.3);
  EXPECT_NEAR(d.upperInterval.high, 110.1, 0.3);
  EXPECT_NEAR(r->correlation, 0.94, 0.005);
}

TEST(Agreement, IntervalsOfTheLimitsHoldAsOftenAsTheySay) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> gauss(0.3, 2);
  const double upper = 0.3 + 1.96 * 2;
  for (const LimitsMethod method : {LimitsMethod::Exact, LimitsMethod::BlandAltman1999}) {
    int inside = 0;
    for (int t = 0; t < 2000; ++t) {
      std::vector<double> d(20);
      for (double& v : d) v = gauss(random);
      BlandAltmanSettings settings;
      settings.method = method;
      const auto r = blandAltman(d, settings);
      inside += r->upperInterval.low <= upper && r->upperInterval.high >= upper ? 1 : 0;
    }
    EXPECT_NEAR(inside, 1900, method == LimitsMethod::Exact ? 35 : 60);
  }
}

std::vector<std::string> repeated(const std::vector<std::pair<std::string, int>>& parts) {
  std::vector<std::string> list;
  for (const auto& [word, n] : parts) list.insert(list.end(), static_cast<std::size_t>(n), word);
  return list;
}

TEST(KappaStudy, ByHand) {
  // yes/yes 20, yes/no 5, no/yes 10, no/no 15: p_o = 0.7, p_e = 0.5 x 0.6 + 0.5 x 0.4 = 0.5.
  const auto a = repeated({{"yes", 25}, {"no", 25}}), b = repeated({{"yes", 20}, {"no", 5}, {"yes", 10}, {"no", 15}});
  const auto k = kappaStudy(a, b);
  ASSERT_TRUE(k) << k.error().message();
  EXPECT_NEAR(k->observed, 0.7, 1e-12);
  EXPECT_NEAR(k->expected, 0.5, 1e-12);
  EXPECT_NEAR(k->kappa, 0.4, 1e-12);
  EXPECT_EQ(k->categories, (std::vector<std::string>{"no", "yes"}));
  EXPECT_EQ(kappaStudy(a, a)->kappa, 1);
  EXPECT_FALSE(kappaStudy({"x", "x"}, {"x", "x"}));
}

TEST(KappaStudy, WeightsForgiveNeighbours) {
  const std::vector<std::string> a = {"1", "2", "10", "1", "2", "10"}, b = {"2", "2", "10", "1", "1", "10"};
  const auto plain = kappaStudy(a, b), linear = kappaStudy(a, b, KappaWeights::Linear),
             quadratic = kappaStudy(a, b, KappaWeights::Quadratic);
  ASSERT_TRUE(plain && linear && quadratic);
  EXPECT_EQ(plain->categories, (std::vector<std::string>{"1", "2", "10"})) << "numbers by value";
  EXPECT_LT(plain->kappa, linear->kappa);
  EXPECT_LT(linear->kappa, quadratic->kappa);
}

TEST(KappaStudy, StandardErrorIsTheScatterOfKappa) {
  std::mt19937_64 random(2);
  std::discrete_distribution<int> cell({0.4, 0.1, 0.05, 0.45});
  std::vector<double> kappas;
  double se = 0;
  for (int t = 0; t < 2000; ++t) {
    std::vector<std::string> a, b;
    for (int i = 0; i < 150; ++i) {
      const int c = cell(random);
      a.push_back(c / 2 == 0 ? "good" : "bad");
      b.push_back(c % 2 == 0 ? "good" : "bad");
    }
    const auto k = kappaStudy(a, b);
    kappas.push_back(k->kappa);
    se += k->se / 2000;
  }
  EXPECT_NEAR(se, describe(kappas).sd(), 0.003);
}

}  // namespace
}  // namespace vignole
