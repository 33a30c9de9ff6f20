#include "calibration/parameter_study/factorial_design.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <set>

#include "calibration/parameter_study/analysis_of_variance.h"

namespace vignole {
namespace {

Factor factor(const std::string& name, int levels) {
  Factor f{name, {}};
  for (int i = 0; i < levels; ++i) f.levels.emplace_back(0.5 * i);
  return f;
}

std::string errorOf(const Expected<FactorialDesign>& design) { return design ? "" : design.error().message(); }

TEST(FactorialDesign, FullDesignHoldsEveryCombinationOnce) {
  const auto design = factorialDesign({{"fit", {"direct", "stable"}}, factor("sigma_px", 3), factor("t_ec", 2)});
  ASSERT_TRUE(design);
  EXPECT_EQ(design->fullRuns, 12U);
  EXPECT_TRUE(design->full());
  EXPECT_EQ(std::set<Combination>(design->runs.begin(), design->runs.end()).size(), 12U);
  EXPECT_EQ(words(design->factors, design->runs[1]), "fit direct, sigma_px 0, t_ec 0.5");
}

TEST(FactorialDesign, RefusesWhatIsTooLargeAndSaysHowLargeItIs) {
  const auto design = factorialDesign({factor("a", 8), factor("b", 8), factor("c", 8)});
  EXPECT_THAT(errorOf(design), testing::AllOf(testing::HasSubstr("512 runs"), testing::HasSubstr("limit of 256"),
                                              testing::HasSubstr("[design] runs")));
  EXPECT_TRUE(factorialDesign({factor("a", 8), factor("b", 8), factor("c", 8)}, {600, {}}));
  std::vector<Factor> many;
  for (int i = 0; i < 40; ++i) many.push_back(factor("f" + std::to_string(i), 4));
  EXPECT_THAT(errorOf(factorialDesign(many)), testing::HasSubstr("more than 20000 runs"));
  EXPECT_THAT(errorOf(factorialDesign(many, {256, 64})), testing::HasSubstr("fewer factors"));
}

TEST(FactorialDesign, RefusesFactorsThatAreNone) {
  EXPECT_THAT(errorOf(factorialDesign({})), testing::HasSubstr("no factor"));
  EXPECT_THAT(errorOf(factorialDesign({factor("a", 1)})), testing::HasSubstr("two or more"));
  EXPECT_THAT(errorOf(factorialDesign({factor("a", 2), factor("a", 3)})), testing::HasSubstr("twice"));
  EXPECT_THAT(errorOf(factorialDesign({{"a", {1.0, 2.0, 1.0}}})), testing::HasSubstr("level twice"));
}

TEST(FactorialDesign, AFractionTellsAllEffectsApart) {
  const std::vector<Factor> factors{factor("a", 4), factor("b", 3), factor("c", 3), factor("d", 2), factor("e", 2)};
  const auto design = factorialDesign(factors, {256, 60});
  ASSERT_TRUE(design) << errorOf(design);
  EXPECT_EQ(design->fullRuns, 144U);
  EXPECT_EQ(design->runs.size(), 60U);
  EXPECT_EQ(std::set<Combination>(design->runs.begin(), design->runs.end()).size(), 60U);
  EXPECT_GT(design->efficiency, 0.85);
  EXPECT_LE(design->efficiency, 1.0 + 1e-12);

  // A response of known effects comes back exactly from the fraction.
  std::vector<Observation> observations;
  const auto response = [](const Combination& c) {
    return 3.0 * c[0] - 2 * c[1] + 1.5 * c[0] * c[4] + 0.25 * c[2] * c[1];
  };
  for (const Combination& run : design->runs) observations.push_back({run, 0, response(run)});
  const auto analysis = analyseVariance(factors, observations);
  ASSERT_TRUE(analysis);
  for (const VarianceLine& line : analysis->terms) EXPECT_GT(line.dof, 0) << line.name;
  EXPECT_NEAR(predict(factors, observations, {{3, 2, 2, 1, 1}}, 2).front().value, response({3, 2, 2, 1, 1}), 1e-8);
  EXPECT_EQ(factorialDesign(factors, {256, 60})->runs, design->runs) << "the same for the same factors";
}

TEST(FactorialDesign, AHalfOfTwoLevelFactorsIsAsGoodAsTheRegularOne) {
  std::vector<Factor> factors;
  for (const char* name : {"a", "b", "c", "d", "e"}) factors.push_back(factor(name, 2));
  const auto design = factorialDesign(factors, {256, 16});
  ASSERT_TRUE(design) << errorOf(design);
  EXPECT_NEAR(design->efficiency, 1, 1e-9) << "2^(5-1) of resolution V: 16 runs for 16 parameters, orthogonal";
  EXPECT_THAT(errorOf(factorialDesign(factors, {256, 15})), testing::HasSubstr("16 main effects and two-factor"));
}

}  // namespace
}  // namespace vignole
