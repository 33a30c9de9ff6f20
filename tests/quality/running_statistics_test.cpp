#include "engine/quality/running_statistics.h"

#include <gtest/gtest.h>
#include <numbers>
#include <random>
#include <vector>

namespace vignole {
namespace {

/// Printed tables (NIST/SEMATECH e-Handbook 1.3.6.7.2 and textbooks), three decimals.
TEST(StudentQuantile, AgreesWithPrintedTables) {
  struct Row {
    double df, p900, p950, p975, p990, p995, p999;
  };
  for (const Row& r :
       {Row{1, 3.078, 6.314, 12.706, 31.821, 63.657, 318.309}, Row{2, 1.886, 2.920, 4.303, 6.965, 9.925, 22.327},
        Row{4, 1.533, 2.132, 2.776, 3.747, 4.604, 7.173}, Row{10, 1.372, 1.812, 2.228, 2.764, 3.169, 4.144},
        Row{29, 1.311, 1.699, 2.045, 2.462, 2.756, 3.396}, Row{100, 1.290, 1.660, 1.984, 2.364, 2.626, 3.174}}) {
    EXPECT_NEAR(studentQuantile(0.900, r.df), r.p900, 6e-4) << r.df;
    EXPECT_NEAR(studentQuantile(0.950, r.df), r.p950, 6e-4) << r.df;
    EXPECT_NEAR(studentQuantile(0.975, r.df), r.p975, 6e-4) << r.df;
    EXPECT_NEAR(studentQuantile(0.990, r.df), r.p990, 6e-4) << r.df;
    EXPECT_NEAR(studentQuantile(0.995, r.df), r.p995, 6e-4) << r.df;
    EXPECT_NEAR(studentQuantile(0.999, r.df), r.p999, 6e-4) << r.df;
  }
}

TEST(StudentQuantile, AgreesWithTheClosedFormsOfOneTwoAndFour) {
  for (const double p : {1e-6, 0.001, 0.1, 0.3, 0.49, 0.6, 0.995, 0.999999}) {
    const double cauchy = std::tan(std::numbers::pi * (p - 0.5));
    EXPECT_NEAR(studentQuantile(p, 1), cauchy, 1e-9 * (1 + std::abs(cauchy))) << p;
    const double two = (2 * p - 1) / std::sqrt(2 * p * (1 - p));
    EXPECT_NEAR(studentQuantile(p, 2), two, 1e-9 * (1 + std::abs(two))) << p;
    const double root = std::sqrt(4 * p * (1 - p));
    const double four = (p < 0.5 ? -1 : 1) * 2 * std::sqrt(std::cos(std::acos(root) / 3) / root - 1);
    EXPECT_NEAR(studentQuantile(p, 4), four, 1e-8 * (1 + std::abs(four))) << p;
  }
}

TEST(StudentQuantile, BecomesNormal) {
  EXPECT_NEAR(studentQuantile(0.975, 1e7), 1.959963984540054, 1e-6);
  EXPECT_NEAR(studentQuantile(0.995, 1e12), 2.575829303548901, 1e-6);
  EXPECT_NEAR(studentQuantile(0.995, 1e6), 2.575829303548901 + 4.917e-6, 1e-7) << "z + (z^3 + z) / 4 nu";
}

TEST(StudentQuantile, IsSymmetricAndRefusesNonsense) {
  EXPECT_EQ(studentQuantile(0.5, 7), 0);
  EXPECT_NEAR(studentQuantile(0.025, 3.5), -studentQuantile(0.975, 3.5), 1e-9);
  for (const double p : {0.0, 1.0, -1.0, 2.0}) EXPECT_TRUE(std::isnan(studentQuantile(p, 5)));
  EXPECT_TRUE(std::isnan(studentQuantile(0.9, 0.5)));
  EXPECT_TRUE(std::isnan(studentQuantile(std::nan(""), 5)));
}

/// Critical values as printed (NIST/SEMATECH e-Handbook 1.3.6.7.3), three decimals.
TEST(FisherUpperTail, AgreesWithPrintedTables) {
  struct Row {
    double f, numerator, denominator, p;
  };
  for (const Row& r : {Row{161.448, 1, 1, 0.05}, Row{3.708, 3, 10, 0.05}, Row{3.354, 2, 27, 0.05},
                       Row{4.103, 5, 20, 0.01}, Row{2.979, 10, 30, 0.01}, Row{1.392, 100, 100, 0.05}})
    EXPECT_NEAR(fisherUpperTail(r.f, r.numerator, r.denominator), r.p, 3e-5) << r.f;
}

TEST(FisherUpperTail, OfOneDegreeIsStudentSquared) {
  for (const double nu : {1.0, 3.0, 17.0, 400.0}) {
    const double t = studentQuantile(0.995, nu);
    EXPECT_NEAR(fisherUpperTail(t * t, 1, nu), 0.01, 1e-9) << nu;
  }
  EXPECT_EQ(fisherUpperTail(0, 3, 5), 1);
  EXPECT_TRUE(std::isnan(fisherUpperTail(1, 0, 5)));
}

TEST(RunningStatistics, AgreesWithTwoPasses) {
  std::mt19937 random(1);
  std::normal_distribution<double> gauss(1e6, 0.01);
  std::vector<double> values(1000);
  RunningStatistics running;
  double sum = 0;
  for (double& v : values) {
    v = gauss(random);
    running.add(v);
    sum += v - 1e6;
  }
  const double mean = 1e6 + sum / 1000;
  double squares = 0;
  for (const double v : values) squares += (v - mean) * (v - mean);
  EXPECT_EQ(running.count(), 1000U);
  EXPECT_NEAR(running.mean(), mean, 1e-9);
  EXPECT_NEAR(running.sd(), std::sqrt(squares / 999), 1e-8);
  EXPECT_EQ(running.min(), *std::min_element(values.begin(), values.end()));
  EXPECT_EQ(running.max(), *std::max_element(values.begin(), values.end()));
}

TEST(RunningStatistics, Ucl99OfFiveValues) {
  RunningStatistics s;
  EXPECT_EQ(ucl99(s), 0);
  s.add(2);
  EXPECT_EQ(ucl99(s), 2) << "one value says nothing of the spread";
  for (const double v : {4.0, 4.0, 4.0, 6.0}) s.add(v);
  // mean 4, s = sqrt(2), t(0.995, 4) = 4.604095
  EXPECT_NEAR(ucl99(s), 4 + 4.604095 * std::sqrt(2.0) / std::sqrt(5.0), 1e-5);
}

}  // namespace
}  // namespace vignole
