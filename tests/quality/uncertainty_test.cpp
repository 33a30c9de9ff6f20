// Budgets, their Monte Carlo, models as text, conformity.

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "engine/quality/conformity.h"
#include "engine/quality/model_expression.h"
#include "engine/quality/uncertainty_budget.h"

namespace vignole {
namespace {

double evaluated(const std::string& text) {
  const auto model = ModelExpression::parse(text, {"a", "b_2"});
  EXPECT_TRUE(model) << (model ? "" : model.error().message());
  const std::vector<double> values = {2, 3};
  return model ? (*model)(values) : std::nan("");
}

TEST(ModelExpression, FollowsTheRules) {
  EXPECT_EQ(evaluated("1 + 2 * 3 - 4 / 2"), 5);
  EXPECT_EQ(evaluated("-a^2"), -4) << "the power binds before the sign";
  EXPECT_EQ(evaluated("a^b_2^2"), 512) << "to the right";
  EXPECT_EQ(evaluated("2^-1"), 0.5);
  EXPECT_EQ(evaluated("a - b_2 - 1"), -2) << "to the left";
  EXPECT_EQ(evaluated("(a + 1) * -(b_2)"), -9);
  EXPECT_NEAR(evaluated("sqrt(a) * exp(log(3)) + cos(pi) + 1e-3"), 3 * std::sqrt(2.0) - 1 + 1e-3, 1e-12);
}

TEST(ModelExpression, SaysWhereItIsWrong) {
  for (const auto& [text, said] : {std::pair{"a +", "ends"}, std::pair{"a + c", "'c' is no symbol"},
                                   std::pair{"(a", "')'"}, std::pair{"a b_2", "character 3"}, std::pair{"sin a", "'('"},
                                   std::pair{"", "ends"}, std::pair{"a $ 2", "'$'"}}) {
    const auto model = ModelExpression::parse(text, {"a", "b_2"});
    ASSERT_FALSE(model) << text;
    EXPECT_NE(model.error().message().find(said), std::string::npos) << model.error().message();
  }
  EXPECT_FALSE(ModelExpression::parse(std::string(100000, '('), {"a"})) << "no overflow of the stack";
  EXPECT_FALSE(ModelExpression::parse(std::string(100000, '-'), {"a"}));
}

UncertaintyBudget additive(const std::vector<double>& u, InputDistribution distribution) {
  UncertaintyBudget budget;
  for (const double v : u) {
    BudgetInput input;
    input.symbol = "x";
    input.u = v;
    input.distribution = distribution;
    budget.inputs.push_back(input);
  }
  return budget;
}

/// JCGM 101, 9.2: sums of four inputs.
TEST(Uncertainty, AdditiveModelsOfJcgm101) {
  const auto normal = uncertaintyStudy(additive({1, 1, 1, 1}, InputDistribution::Normal));
  ASSERT_TRUE(normal) << normal.error().message();
  EXPECT_NEAR(normal->uc, 2, 1e-12);
  EXPECT_NEAR(normal->monteCarlo->interval95.high, 3.92, 0.02);
  EXPECT_NEAR(*normal->monteCarlo->u, 2, 0.01);
  EXPECT_TRUE(normal->monteCarlo->agrees);
  const auto rectangular = uncertaintyStudy(additive({1, 1, 1, 1}, InputDistribution::Rectangular));
  EXPECT_NEAR(rectangular->monteCarlo->interval95.high, 3.88, 0.02);
  EXPECT_TRUE(rectangular->monteCarlo->agrees);
  const auto dominated = uncertaintyStudy(additive({1, 1, 1, 10}, InputDistribution::Rectangular));
  EXPECT_NEAR(dominated->uc, std::sqrt(103.0), 1e-12);
  EXPECT_NEAR(dominated->u95, 19.9, 0.05);
  EXPECT_NEAR(dominated->monteCarlo->interval95.high, 17.0, 0.1);
  EXPECT_FALSE(dominated->monteCarlo->agrees) << "not normal";
}

UncertaintySettings quick() {
  UncertaintySettings settings;
  settings.trials = 200000;
  return settings;
}

TEST(Uncertainty, EveryDistributionHasItsStandardDeviation) {
  for (const InputDistribution d : {InputDistribution::Normal, InputDistribution::Rectangular,
                                    InputDistribution::Triangular, InputDistribution::ArcSine, InputDistribution::Auto})
    EXPECT_NEAR(*uncertaintyStudy(additive({3}, d), quick())->monteCarlo->u, 3, 0.02);
}

TEST(Uncertainty, SensitivitiesComeFromTheModel) {
  UncertaintyBudget budget;
  budget.inputs = {{"a", "", "", 3, 0.1}, {"b", "", "", 2, 0.2}};
  budget.model = [](std::span<const double> x) { return x[0] * x[0] * x[1] + std::sin(x[1]); };
  const auto r = uncertaintyStudy(budget);
  ASSERT_TRUE(r);
  EXPECT_NEAR(r->lines[0].sensitivity, 12, 1e-9);
  EXPECT_NEAR(r->lines[1].sensitivity, 9 + std::cos(2.0), 1e-7);
  EXPECT_NEAR(r->value, 18 + std::sin(2.0), 1e-12);
}

TEST(Uncertainty, IsRefusedWhereFirstOrderSaysNothing) {
  UncertaintyBudget budget;
  budget.inputs = {{"x", "", "mm", 0, 0.5}};
  budget.model = [](std::span<const double> x) { return x[0] * x[0]; };
  const auto r = uncertaintyStudy(budget);
  ASSERT_TRUE(r) << r.error().message();
  EXPECT_TRUE(r->refused);
  EXPECT_EQ(r->uc, 0);
  EXPECT_NEAR(r->monteCarlo->mean, 0.25, 0.002) << "the Monte Carlo knows better: u^2";
  EXPECT_NEAR(*r->monteCarlo->u, 0.25 * std::sqrt(2.0), 0.003);
  EXPECT_FALSE(r->monteCarlo->agrees);
}

/// GUM H.1: the second-order terms that its H.1.7 adds bring u from 32 to 34 nm.
TEST(Uncertainty, MonteCarloFindsTheSecondOrderOfTheEndGauge) {
  UncertaintyBudget budget;
  budget.inputs = {{"l_S", "", "nm", 50000623, 25},         {"d", "", "nm", 215, 9.7},
                   {"d_alpha", "", "1/C", 0, 0.58e-6},      {"theta", "", "C", -0.1, 0.41},
                   {"alpha_S", "", "1/C", 11.5e-6, 1.2e-6}, {"d_theta", "", "C", 0, 0.029}};
  std::vector<std::string> symbols;
  for (const BudgetInput& i : budget.inputs) symbols.push_back(i.symbol);
  const auto model = ModelExpression::parse("l_S + d - l_S * (d_alpha * theta + alpha_S * d_theta)", symbols);
  ASSERT_TRUE(model) << model.error().message();
  budget.model = *model;
  const auto r = uncertaintyStudy(budget);
  ASSERT_TRUE(r) << r.error().message();
  EXPECT_NEAR(r->uc, 32, 0.5);
  EXPECT_NEAR(*r->monteCarlo->u, 34, 0.5);
  EXPECT_FALSE(r->monteCarlo->agrees);
}

TEST(Uncertainty, SameSeedSameNumbers) {
  const auto a = uncertaintyStudy(additive({1, 2}, InputDistribution::ArcSine), quick()),
             b = uncertaintyStudy(additive({1, 2}, InputDistribution::ArcSine), quick());
  EXPECT_EQ(*a->monteCarlo->u, *b->monteCarlo->u);
  EXPECT_EQ(a->monteCarlo->interval95.low, b->monteCarlo->interval95.low);
}

TEST(Uncertainty, DegreesOfFreedomAreTruncatedBeforeTheLookUp) {
  UncertaintyBudget budget;
  budget.inputs = {{"a", "", "", 0, 3, 9}, {"b", "", "", 0, 4, 20}};  // u = 5; nu = 625 / (9 + 12.8) = 28.67
  UncertaintySettings settings;
  settings.trials = 0;
  const auto r = uncertaintyStudy(budget, settings);
  EXPECT_NEAR(r->degrees, 625 / 21.8, 1e-9);
  EXPECT_EQ(*r->truncatedDegrees, 28);
  EXPECT_NEAR(r->k95, 2.048, 6e-4);
  EXPECT_EQ(r->expanded, 10);
  budget.inputs.pop_back();
  EXPECT_EQ(*uncertaintyStudy(budget, settings)->truncatedDegrees, 9) << "alone it keeps its own";
  budget.inputs[0].u = -1;
  EXPECT_FALSE(uncertaintyStudy(budget, settings));
}

TEST(ConformityRule, GuardBandsOnBothSidesOfALimit) {
  const ToleranceZone zone{-0.5, 0.5};
  EXPECT_EQ(conformity(0.29, 0.1, zone), Conformity::Conforms);
  EXPECT_EQ(conformity(0.31, 0.1, zone), Conformity::CannotBeDecided);
  EXPECT_EQ(conformity(0.69, 0.1, zone), Conformity::CannotBeDecided);
  EXPECT_EQ(conformity(-0.71, 0.1, zone), Conformity::DoesNotConform);
  EXPECT_EQ(conformity(0, 0.3, zone), Conformity::CannotBeDecided) << "no room left between the guard bands";
  EXPECT_EQ(conformity(0.34, 0.1, zone, 1.5), Conformity::Conforms);
  EXPECT_EQ(conformity(-5, 0.1, {std::nullopt, 0.3}), Conformity::Conforms) << "one limit";
  EXPECT_NEAR(conformanceProbability(0.5, 0.1, zone), 0.5, 1e-9);
  EXPECT_NEAR(conformanceProbability(0.5 - 0.1645, 0.1, zone), 0.95, 1e-4);
}

TEST(ConformityRule, RisksAreThoseOfAMonteCarlo) {
  const ToleranceZone tolerance{-0.5, 0.5};
  const ProcessSpread process{0.1, 0.25};
  const double u = 0.08;
  std::mt19937_64 random(1);
  std::normal_distribution<double> gauss;
  for (const double guard : {0.0, 1.0, 2.0}) {
    const ToleranceZone accepted = acceptanceZone(u, tolerance, guard);
    const ConformityRisks risks = conformityRisks(process, u, tolerance, accepted);
    int consumer = 0, producer = 0, bad = 0;
    constexpr int kTrials = 400000;
    for (int t = 0; t < kTrials; ++t) {
      const double truth = process.mean + process.sd * gauss(random), measured = truth + u * gauss(random);
      const bool good = std::abs(truth) <= 0.5, taken = measured >= *accepted.lower && measured <= *accepted.upper;
      consumer += !good && taken ? 1 : 0;
      producer += good && !taken ? 1 : 0;
      bad += good ? 0 : 1;
    }
    const auto close = [&](double risk, int count) {
      EXPECT_NEAR(count, risk * kTrials, 5 * std::sqrt(risk * kTrials) + 2) << guard;
    };
    close(risks.consumer, consumer);
    close(risks.producer, producer);
    close(risks.bad, bad);
  }
}

TEST(ConformityRule, AnEmptyZoneAcceptsNothing) {
  const ConformityRisks risks = conformityRisks({0, 0.1}, 0.3, {-0.5, 0.5}, acceptanceZone(0.3, {-0.5, 0.5}));
  EXPECT_EQ(risks.consumer, 0);
  EXPECT_NEAR(risks.producer, 1 - risks.bad, 1e-9);
}

}  // namespace
}  // namespace vignole
