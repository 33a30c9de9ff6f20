#include "calibration/parameter_study/analysis_of_variance.h"

#include <array>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>

namespace vignole {
namespace {

Factor factor(const std::string& name, int levels) {
  Factor f{name, {}};
  for (int i = 0; i < levels; ++i) f.levels.emplace_back(static_cast<double>(i));
  return f;
}

std::string remarksOf(const VarianceAnalysis& analysis) {
  std::string all;
  for (const std::string& remark : analysis.remarks) all += remark + "\n";
  return all;
}

const VarianceLine& line(const VarianceAnalysis& analysis, const std::string& name) {
  for (const VarianceLine& l : analysis.terms)
    if (l.name == name) return l;
  ADD_FAILURE() << "no line " << name;
  return analysis.error;
}

const Effect& effect(const VarianceAnalysis& analysis, const std::string& name) {
  for (const Effect& e : analysis.effects)
    if (e.name == name) return e;
  ADD_FAILURE() << "no effect " << name;
  return analysis.effects.front();
}

/// Montgomery, Design and Analysis of Experiments: the pilot plant filtration rate, 2^4 without replicates.
VarianceAnalysis filtrationRate() {
  const std::array<double, 16> standardOrder{45, 71, 48, 65, 68, 60, 80, 65, 43, 100, 45, 104, 75, 86, 70, 96};
  std::vector<Observation> observations;
  for (int i = 0; i < 16; ++i)
    observations.push_back(
        {{i & 1, i >> 1 & 1, i >> 2 & 1, i >> 3 & 1}, 0, standardOrder[static_cast<std::size_t>(i)]});
  auto analysis = analyseVariance({factor("A", 2), factor("B", 2), factor("C", 2), factor("D", 2)}, observations);
  EXPECT_TRUE(analysis);
  return *analysis;
}

TEST(AnalysisOfVariance, FiltrationRateInMontgomery) {
  const VarianceAnalysis analysis = filtrationRate();
  struct Row {
    const char* name;
    double effect, squares, percent;
  };
  // Effects, sums of squares and per cent contributions as printed.
  for (const Row& r : {Row{"A", 21.625, 1870.56, 32.6397}, Row{"B", 3.125, 39.0625, 0.681608},
                       Row{"C", 9.875, 390.062, 6.80626}, Row{"D", 14.625, 855.563, 14.9288},
                       Row{"A x B", 0.125, 0.0625, 0.00109057}, Row{"A x C", -18.125, 1314.06, 22.9293},
                       Row{"A x D", 16.625, 1105.56, 19.2911}, Row{"B x C", 2.375, 22.5625, 0.393696},
                       Row{"B x D", -0.375, 0.5625, 0.00981515}, Row{"C x D", -1.125, 5.0625, 0.0883363}}) {
    EXPECT_NEAR(effect(analysis, r.name).contrast, r.effect, 1e-9) << r.name;
    EXPECT_NEAR(line(analysis, r.name).squares, r.squares, 0.005) << r.name;
    EXPECT_NEAR(100 * line(analysis, r.name).share, r.percent, 1e-4) << r.name;
  }
  EXPECT_NEAR(analysis.total.squares, 5730.94, 0.005);
  EXPECT_EQ(analysis.error.dof, 5) << "the interactions of three and four factors";
  EXPECT_NEAR(analysis.error.squares, 14.0625 + 68.0625 + 10.5625 + 27.5625 + 7.5625, 1e-9);
  EXPECT_TRUE(analysis.balanced);
  EXPECT_EQ(analysis.blocks.dof, 0);
  std::vector<std::string> firstFive;
  for (int i = 0; i < 5; ++i)
    firstFive.push_back(analysis.terms[static_cast<std::size_t>(analysis.ranking[static_cast<std::size_t>(i)])].name);
  EXPECT_THAT(firstFive, testing::ElementsAre("A", "A x C", "A x D", "D", "C"));
}

/// Montgomery, life of batteries: three materials at three temperatures, four replicates each.
TEST(AnalysisOfVariance, BatteryLifeInMontgomery) {
  const std::array<std::array<std::array<double, 4>, 3>, 3> life{
      {{{{130, 155, 74, 180}, {34, 40, 80, 75}, {20, 70, 82, 58}}},
       {{{150, 188, 159, 126}, {136, 122, 106, 115}, {25, 70, 58, 45}}},
       {{{138, 110, 168, 160}, {174, 120, 150, 139}, {96, 104, 82, 60}}}}};
  std::vector<Observation> observations;
  for (int m = 0; m < 3; ++m)
    for (int t = 0; t < 3; ++t)
      for (const double y : life[static_cast<std::size_t>(m)][static_cast<std::size_t>(t)])
        observations.push_back({{m, t}, 0, y});
  const auto analysis = analyseVariance({factor("material", 3), factor("temperature", 3)}, observations);
  ASSERT_TRUE(analysis);
  EXPECT_NEAR(line(*analysis, "material").squares, 10683.72, 0.005);
  EXPECT_NEAR(line(*analysis, "temperature").squares, 39118.72, 0.005);
  EXPECT_NEAR(line(*analysis, "material x temperature").squares, 9613.78, 0.005);
  EXPECT_NEAR(analysis->error.squares, 18230.75, 0.005);
  EXPECT_NEAR(analysis->total.squares, 77646.97, 0.005);
  EXPECT_NEAR(line(*analysis, "material").f, 7.91, 0.005);
  EXPECT_NEAR(line(*analysis, "temperature").f, 28.97, 0.005);
  EXPECT_NEAR(line(*analysis, "material x temperature").f, 3.56, 0.005);
  EXPECT_NEAR(line(*analysis, "material").p, 0.0020, 5e-5);
  EXPECT_LT(line(*analysis, "temperature").p, 1e-4);
  EXPECT_NEAR(line(*analysis, "material x temperature").p, 0.0186, 5e-5);
  EXPECT_EQ(analysis->error.dof, 27);
  // Means of the cells and of the levels, and their standard errors by hand: sqrt(675.21 / 4), sqrt(675.21 / 12).
  const Effect& cells = effect(*analysis, "material x temperature");
  EXPECT_NEAR(cells.means[0].mean, 134.75, 1e-9);
  EXPECT_NEAR(cells.means[0].standardError, std::sqrt(675.21 / 4), 1e-3);
  EXPECT_NEAR(effect(*analysis, "material").means[2].mean, 125.08, 0.005);
  EXPECT_NEAR(effect(*analysis, "material").means[2].standardError, std::sqrt(675.21 / 12), 1e-3);
  EXPECT_TRUE(analysis->remarks.empty()) << remarksOf(*analysis);
}

/// Montgomery, vascular grafts: four extrusion pressures in six batches of resin as blocks.
TEST(AnalysisOfVariance, BlocksAreTakenOutOfTheError) {
  const std::array<std::array<double, 6>, 4> yield{{{90.3, 89.2, 98.2, 93.9, 87.4, 97.9},
                                                    {92.5, 89.5, 90.6, 94.7, 87.0, 95.8},
                                                    {85.5, 90.8, 89.6, 86.2, 88.0, 93.4},
                                                    {82.5, 89.5, 85.6, 87.4, 78.9, 90.7}}};
  std::vector<Observation> observations;
  for (int pressure = 0; pressure < 4; ++pressure)
    for (int batch = 0; batch < 6; ++batch)
      observations.push_back(
          {{pressure}, 10 * batch, yield[static_cast<std::size_t>(pressure)][static_cast<std::size_t>(batch)]});
  const auto analysis = analyseVariance({factor("pressure", 4)}, observations);
  ASSERT_TRUE(analysis);
  EXPECT_NEAR(line(*analysis, "pressure").squares, 178.17, 0.005);
  EXPECT_NEAR(analysis->blocks.squares, 192.25, 0.005);
  EXPECT_NEAR(analysis->error.squares, 109.89, 0.005);
  EXPECT_NEAR(analysis->total.squares, 480.31, 0.005);
  EXPECT_NEAR(line(*analysis, "pressure").f, 8.11, 0.005);
  EXPECT_NEAR(line(*analysis, "pressure").p, 0.0019, 5e-5);
  EXPECT_EQ(analysis->blocks.dof, 5);
  EXPECT_EQ(analysis->error.dof, 15);
}

/// Moore and Krupat 1971, unbalanced; table of type II as the manual of R's package car prints it.
TEST(AnalysisOfVariance, UnbalancedIsOfTypeTwo) {
  struct Row {
    int partner, authoritarianism;  // 0 low, 1 medium, 2 high
    double conformity;
  };
  const std::vector<Row> rows{
      {0, 0, 8},  {0, 2, 4},  {0, 2, 8},  {0, 0, 7},  {0, 0, 10}, {0, 0, 6},  {0, 1, 12}, {0, 1, 4},  {0, 0, 13},
      {0, 0, 12}, {0, 1, 4},  {0, 2, 13}, {0, 0, 7},  {0, 1, 9},  {0, 2, 9},  {0, 2, 24}, {0, 0, 6},  {0, 2, 7},
      {0, 2, 23}, {0, 2, 13}, {0, 0, 8},  {0, 0, 12}, {1, 2, 19}, {1, 1, 12}, {1, 0, 21}, {1, 2, 9},  {1, 0, 23},
      {1, 2, 7},  {1, 1, 17}, {1, 1, 14}, {1, 2, 11}, {1, 1, 16}, {1, 0, 15}, {1, 1, 20}, {1, 1, 8},  {1, 0, 12},
      {1, 2, 14}, {1, 1, 14}, {1, 1, 17}, {1, 1, 7},  {1, 1, 17}, {1, 2, 13}, {1, 0, 16}, {1, 2, 10}, {1, 1, 15}};
  std::vector<Observation> observations;
  for (const Row& r : rows) observations.push_back({{r.authoritarianism, r.partner}, 0, r.conformity});
  const auto analysis = analyseVariance({factor("fcategory", 3), factor("partner", 2)}, observations);
  ASSERT_TRUE(analysis);
  EXPECT_NEAR(line(*analysis, "fcategory").squares, 11.614700, 5e-7);
  EXPECT_NEAR(line(*analysis, "partner").squares, 212.213778, 5e-7);
  EXPECT_NEAR(line(*analysis, "fcategory x partner").squares, 175.488928, 5e-7);
  EXPECT_NEAR(analysis->error.squares, 817.763961, 5e-7);
  EXPECT_NEAR(line(*analysis, "fcategory").f, 0.276958, 5e-7);
  EXPECT_NEAR(line(*analysis, "partner").f, 10.120692, 5e-7);
  EXPECT_NEAR(line(*analysis, "fcategory x partner").f, 4.184623, 5e-7);
  EXPECT_NEAR(line(*analysis, "fcategory").p, 0.759564, 5e-7);
  EXPECT_NEAR(line(*analysis, "partner").p, 0.002874, 5e-7);
  EXPECT_NEAR(line(*analysis, "fcategory x partner").p, 0.022572, 5e-7);
  EXPECT_FALSE(analysis->balanced);
  EXPECT_THAT(remarksOf(*analysis), testing::HasSubstr("type II"));
  // Least-squares means: the plain average of the cells' means, not of the observations.
  double low = 0;
  const Effect& cells = effect(*analysis, "fcategory x partner");
  for (const std::size_t cell : {0U, 2U, 4U}) low += cells.means[cell].mean / 3;
  EXPECT_NEAR(effect(*analysis, "partner").means[0].mean, low, 1e-9);
  EXPECT_GT(std::abs(effect(*analysis, "partner").means[0].rawMean - low), 0.1);
}

TEST(AnalysisOfVariance, WithoutReplicatesInteractionsArePooled) {
  std::vector<Observation> observations;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 2; ++b) observations.push_back({{a, b}, 0, 10.0 * a + b + (a == 2 && b == 1 ? 0.5 : 0)});
  const auto analysis = analyseVariance({factor("a", 3), factor("b", 2)}, observations);
  ASSERT_TRUE(analysis);
  EXPECT_EQ(analysis->order, 1);
  EXPECT_EQ(analysis->terms.size(), 2U);
  EXPECT_EQ(analysis->error.dof, 2);
  EXPECT_THAT(remarksOf(*analysis), testing::HasSubstr("pooled"));
}

TEST(AnalysisOfVariance, ACellThatIsEmptyIsSaidAndNotInvented) {
  std::vector<Observation> observations;
  for (int replicate = 0; replicate < 3; ++replicate)
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b)
        if (a + b < 2) observations.push_back({{a, b}, 0, a + 2.0 * b + 0.01 * replicate});
  const auto analysis = analyseVariance({factor("a", 2), factor("b", 2)}, observations);
  ASSERT_TRUE(analysis);
  EXPECT_EQ(line(*analysis, "a x b").dof, 0);
  EXPECT_TRUE(std::isnan(effect(*analysis, "a x b").means[3].mean));
  EXPECT_EQ(effect(*analysis, "a x b").means[3].count, 0);
  EXPECT_NEAR(line(*analysis, "a").squares, 1.5, 1e-9) << "from the rows with b = 0: 6 observations, effect 1";
  EXPECT_THAT(remarksOf(*analysis), testing::HasSubstr("a x b cannot be told apart"));
}

/// Simulated: without any effect p is uniform, so that 5 % of the experiments find one at 5 %.
TEST(AnalysisOfVariance, ChanceIsCalledInfluenceAsOftenAsPSays) {
  std::mt19937 random(5);
  std::normal_distribution<double> gauss(7, 2);
  int found = 0;
  constexpr int kExperiments = 1000;
  for (int e = 0; e < kExperiments; ++e) {
    std::vector<Observation> observations;
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 2; ++b)
        for (int block = 0; block < 4; ++block)
          if (!(a == 1 && b == 1 && block < 2)) observations.push_back({{a, b}, block, gauss(random) + 3 * block});
    found += line(*analyseVariance({factor("a", 3), factor("b", 2)}, observations), "a").p < 0.05 ? 1 : 0;
  }
  EXPECT_NEAR(found, 0.05 * kExperiments, 3.5 * std::sqrt(kExperiments * 0.05 * 0.95));
}

TEST(AnalysisOfVariance, RefusesWhatIsNoNumber) {
  EXPECT_FALSE(analyseVariance({factor("a", 2)}, {{{0}, 0, 1.0}}));
  EXPECT_FALSE(analyseVariance({factor("a", 2)}, {{{0}, 0, 1.0}, {{1}, 0, std::nan("")}}));
}

TEST(Prediction, OfARunThatIsLeftOutComesFromTheOthers) {
  std::vector<Observation> observations;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b)
      if (a != 2 || b != 2) observations.push_back({{a, b}, 0, 5.0 + 2 * a - b});
  const std::vector<Factor> factors{factor("a", 3), factor("b", 3)};
  EXPECT_NEAR(predict(factors, observations, {{2, 2}}, 1).front().value, 7, 1e-9) << "additive";
  EXPECT_TRUE(std::isnan(predict(factors, observations, {{2, 2}}, 2).front().value))
      << "with an interaction nothing is known of a cell that was never run";
}

}  // namespace
}  // namespace vignole
