// Control charts, their rules, capability.

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <sstream>

#include "engine/quality/capability.h"
#include "engine/quality/control_chart.h"
#include "tests/quality/published.h"

namespace vignole {
namespace {

std::vector<std::size_t> flagged(const std::vector<double>& z, RuleSet rules, int rule) {
  std::vector<std::size_t> points;
  for (const RuleSignal& s : ruleSignals(z, rules))
    if (s.rule == rule) points.push_back(s.index + 1);
  return points;
}

template <typename T>
std::vector<T> words(const std::string& text) {
  std::istringstream in(text);
  std::vector<T> list;
  for (T v; in >> v;) list.push_back(v);
  return list;
}

TEST(RunRules, AnswerThePublishedVectors) {
  const auto table = CsvTable::load(testing::kQualityData / "spc_rule_vectors.csv");
  if (!table) GTEST_SKIP() << table.error().message();
  for (std::size_t row = 0; row < table->rows(); ++row) {
    const std::string name = table->text(row, 0);
    const RuleSet rules = name.starts_with("NEL") ? RuleSet::Nelson : RuleSet::WesternElectric;
    const int rule =
        name.find_first_of("0123456789") != std::string::npos ? name[name.find_first_of("0123456789")] - '0' : 0;
    EXPECT_EQ(flagged(words<double>(table->text(row, 1)), rules, rule), words<std::size_t>(table->text(row, 2)))
        << name;
  }
}

TEST(RunRules, PatternsMustBeWhole) {
  EXPECT_EQ(flagged({2.5, 2.6, 0.1}, RuleSet::WesternElectric, 2), std::vector<std::size_t>{3})
      << "the first three points";
  EXPECT_TRUE(flagged({2.5, -2.6, 0.1}, RuleSet::WesternElectric, 2).empty()) << "on either side";
  EXPECT_TRUE(flagged({1, 1, 1, 1, 0, 1, 1, 1, 1}, RuleSet::Nelson, 2).empty()) << "the centre line is on no side";
  EXPECT_TRUE(flagged({1, 2, 3, 3, 4, 5, 6}, RuleSet::Nelson, 3).empty()) << "equal is not rising";
  EXPECT_TRUE(ruleSignals({}, RuleSet::Nelson).empty());
  EXPECT_EQ(ruleSignals(std::vector<double>{2.5}, RuleSet::Limits, 2).size(), 1U) << "other limits";
}

std::vector<Subgroup> individuals(const std::vector<double>& values) {
  std::vector<Subgroup> groups;
  for (const double v : values) groups.push_back({"", {v}});
  return groups;
}

/// NIST/SEMATECH e-Handbook 6.3.2.3: target 325, sigma 0.635, k = 0.3175, h = 4.1959.
TEST(ControlChart, CusumOfTheNistExample) {
  ControlChartSettings settings;
  settings.kind = ChartKind::Cusum;
  settings.target = 325;
  settings.sigma = 0.635;
  settings.cusumK = 0.5;
  settings.cusumH = 4.1959 / 0.635;
  const auto chart = controlChart(
      individuals({324.925, 324.675, 324.725, 324.350, 325.350, 325.225, 324.125, 324.525, 325.225, 324.600,
                   324.625, 325.150, 328.325, 327.250, 327.825, 328.500, 326.675, 327.775, 326.875, 328.350}),
      settings);
  ASSERT_TRUE(chart) << chart.error().message();
  EXPECT_NEAR(chart->panels[0].ucl, 4.1959, 1e-9);
  EXPECT_NEAR(chart->panels[0].values[12], 3.01, 0.005);
  EXPECT_NEAR(chart->panels[0].values[13], 4.94, 0.005);
  EXPECT_NEAR(chart->panels[0].values[19], 19.04, 0.015);
  ASSERT_FALSE(chart->panels[0].signals.empty());
  EXPECT_EQ(chart->panels[0].signals.front().index, 13U);
  EXPECT_TRUE(chart->panels[1].signals.empty());
}

std::vector<Subgroup> subgroups(std::size_t count, std::size_t size, double mean, double sigma, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> gauss(mean, sigma);
  std::vector<Subgroup> groups(count);
  for (Subgroup& g : groups)
    for (std::size_t i = 0; i < size; ++i) g.values.push_back(gauss(random));
  return groups;
}

TEST(ControlChart, SubgroupsByHand) {
  ControlChartSettings settings;
  settings.kind = ChartKind::XbarR;
  const auto r =
      controlChart({{"1", {9, 10, 11, 10, 10}}, {"2", {10, 12, 10, 9, 9}}, {"3", {11, 11, 10, 8, 10}}}, settings);
  ASSERT_TRUE(r) << r.error().message();
  EXPECT_NEAR(*r->meanRange, 8.0 / 3, 1e-12);
  EXPECT_NEAR(r->centre, 10, 1e-12);
  EXPECT_NEAR(r->panels[0].ucl, 10 + 0.577 * 8 / 3, 1e-12);
  EXPECT_NEAR(r->panels[1].ucl, 2.114 * 8 / 3, 0.003);
  EXPECT_EQ(r->panels[1].lcl, 0);
  settings.kind = ChartKind::XbarS;
  const auto s = controlChart({{"1", {9, 10, 11}}, {"2", {10, 12, 11}}}, settings);
  ASSERT_TRUE(s);
  EXPECT_NEAR(s->panels[0].ucl, s->centre + 1.954 * 1, 1e-9) << "both s are 1";
  EXPECT_NEAR(s->panels[1].ucl, 2.568, 1e-3);
}

TEST(ControlChart, EstimatesOfSigmaAndTheirDegrees) {
  struct Case {
    ChartKind kind;
    std::size_t size;
  };
  for (const Case& c :
       {Case{ChartKind::IndividualsMovingRange, 1}, Case{ChartKind::XbarR, 5}, Case{ChartKind::XbarS, 8}}) {
    ControlChartSettings settings;
    settings.kind = c.kind;
    settings.constants = ConstantPrecision::Exact;
    std::vector<double> sigmas;
    double degrees = 0;
    for (unsigned seed = 1; seed <= 300; ++seed) {
      const auto chart = controlChart(subgroups(30, c.size, 50, 2, seed), settings);
      sigmas.push_back(chart->sigma);
      degrees = chart->sigmaDegrees;
    }
    const Sample s = describe(sigmas);
    EXPECT_NEAR(s.mean, 2, 0.06);
    EXPECT_NEAR(s.sd() / s.mean, 1 / std::sqrt(2 * degrees), 0.15 / std::sqrt(2 * degrees));
  }
}

TEST(ControlChart, SubgroupsOfDifferentSizeHaveTheirOwnLimits) {
  ControlChartSettings settings;
  settings.kind = ChartKind::XbarR;
  const auto r = controlChart({{"1", {9, 11}}, {"2", {10, 12, 10, 9}}, {"3", {11, 10}}}, settings);
  ASSERT_TRUE(r) << r.error().message();
  EXPECT_NEAR(r->panels[0].upper[0] - r->centre, std::sqrt(2.0) * (r->panels[0].upper[1] - r->centre), 1e-9);
}

TEST(ControlChart, ExactEwmaLimitsWidenToTheAsymptote) {
  ControlChartSettings settings;
  settings.kind = ChartKind::Ewma;
  settings.exactLimits = true;
  const auto r = controlChart(subgroups(200, 1, 10, 1, 3), settings);
  ASSERT_TRUE(r);
  const ChartPanel& p = r->panels[0];
  EXPECT_NEAR(p.upper[0] - r->centre, 3 * r->sigma * 0.3, 1e-9);
  EXPECT_NEAR(p.upper[199], p.ucl, 1e-9);
}

TEST(ControlChart, SeesTheShift) {
  auto groups = subgroups(40, 4, 50, 1, 4);
  ControlChartSettings settings;
  settings.kind = ChartKind::XbarS;
  settings.target = 50;
  settings.sigma = 1;
  settings.rules = RuleSet::Limits;
  ASSERT_TRUE(controlChart(groups, settings)->stable());
  for (std::size_t g = 20; g < 40; ++g)
    for (double& v : groups[g].values) v += 2.5;
  const auto chart = controlChart(groups, settings);
  ASSERT_FALSE(chart->stable());
  EXPECT_GE(chart->panels[0].signals.front().index, 20U);
  EXPECT_LE(chart->panels[0].signals.front().index, 22U);
}

TEST(ControlChart, RefusesWhatItCannotChart) {
  ControlChartSettings xbar;
  xbar.kind = ChartKind::XbarR;
  EXPECT_FALSE(controlChart(individuals({1, 2, 3}), xbar));
  EXPECT_FALSE(controlChart(individuals({1})));
  EXPECT_NE(controlChart({{"a", {1, 2}}, {"b", {1}}}).error().message().find("subgroup a"), std::string::npos);
}

/// NIST/SEMATECH e-Handbook 6.1.6: limits 8 and 20, mean 16, s 2: Cp 1.0, Cpk 0.6667.
TEST(Capability, OfTheNistExample) {
  std::vector<double> values;
  for (int i = 0; i < 25; ++i) values.insert(values.end(), {14, 18});
  CapabilitySettings settings;
  settings.lower = 8;
  settings.upper = 20;
  settings.chart.sigma = 2;
  const auto r = capabilityStudy(individuals(values), settings);
  ASSERT_TRUE(r) << r.error().message();
  ASSERT_TRUE(r->stable);
  EXPECT_NEAR(r->cp->value, 1.0, 1e-12);
  EXPECT_NEAR(r->cpk->value, 0.6667, 5e-5);
  EXPECT_NEAR(r->ppk->value, 4 / (3 * std::sqrt(200.0 / 49)), 1e-9);
}

TEST(Capability, IntervalsHoldAsOftenAsTheySay) {
  CapabilitySettings settings;
  settings.lower = 45;
  settings.upper = 56;
  settings.evenIfUnstable = true;
  settings.chart.kind = ChartKind::XbarS;
  settings.chart.constants = ConstantPrecision::Exact;
  int pp = 0, ppk = 0, cp = 0;
  constexpr int kTrials = 1000;
  for (unsigned seed = 1; seed <= kTrials; ++seed) {
    const auto r = capabilityStudy(subgroups(20, 4, 50, 1.5, seed), settings);
    const auto holds = [](const CapabilityIndex& i, double truth) {
      return i.interval.low <= truth && truth <= i.interval.high ? 1 : 0;
    };
    cp += holds(*r->cp, 11 / 9.0);
    pp += holds(*r->pp, 11 / 9.0);
    ppk += holds(*r->ppk, 5 / 4.5);
  }
  EXPECT_NEAR(pp, 950, 25);
  EXPECT_NEAR(ppk, 950, 25);
  EXPECT_NEAR(cp, 950, 30);
}

TEST(Capability, IsRefusedWhereTheProcessIsNotStable) {
  std::vector<double> values;
  for (int i = 0; i < 30; ++i) values.push_back(i % 2 + (i == 20 ? 30 : 0));
  CapabilitySettings settings;
  settings.upper = 100;
  const auto r = capabilityStudy(individuals(values), settings);
  ASSERT_TRUE(r);
  EXPECT_FALSE(r->stable);
  EXPECT_FALSE(r->cpk || r->ppk);
  settings.evenIfUnstable = true;
  const auto forced = capabilityStudy(individuals(values), settings);
  EXPECT_TRUE(forced->cpk);
  EXPECT_FALSE(forced->cp) << "one limit has no width";
  settings.upper.reset();
  EXPECT_FALSE(capabilityStudy(individuals(values), settings));
}

}  // namespace
}  // namespace vignole
