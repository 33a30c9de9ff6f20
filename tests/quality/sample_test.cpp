// Certified values of the NIST Statistical Reference Datasets.

#include "engine/quality/sample.h"

#include <cmath>
#include <gtest/gtest.h>

#include "engine/quality/precision.h"
#include "engine/quality/regression.h"

namespace vignole {
namespace {

/// Decimal digits in which a value agrees.
double digits(double value, double certified) {
  const double error = std::abs(value - certified);
  return error == 0 ? 16 : -std::log10(error / (certified == 0 ? 1 : std::abs(certified)));
}

/// NumAcc2-4: base, then 1001 values that lie 0.1 below and above in turn.
std::vector<double> numAcc(double low, double middle, double high) {
  std::vector<double> values = {middle};
  for (int i = 0; i < 500; ++i) values.insert(values.end(), {low, high});
  return values;
}

TEST(Sample, NistNumAcc) {
  struct Set {
    std::vector<double> values;
    double mean, sd, autocorrelation;
    double digits;  ///< what double precision leaves of the values
  };
  for (const Set& set :
       {Set{{10000001, 10000003, 10000002}, 10000002, 1, -0.5, 15}, Set{numAcc(1.1, 1.2, 1.3), 1.2, 0.1, -0.999, 14},
        Set{numAcc(1000000.1, 1000000.2, 1000000.3), 1000000.2, 0.1, -0.999, 9},
        Set{numAcc(10000000.1, 10000000.2, 10000000.3), 10000000.2, 0.1, -0.999, 8}}) {
    const Sample s = describe(set.values);
    EXPECT_GE(digits(s.mean, set.mean), 14.9);
    EXPECT_GE(digits(s.sd(), set.sd), set.digits);
    EXPECT_GE(digits(autocorrelation(set.values), set.autocorrelation), set.digits);
  }
}

/// SmLs01, 04, 07: nine treatments of 21 replicates, offset 1, 10^6, 10^12; F = 21 certified for all.
TEST(Sample, NistOneWayAnalysisOfVariance) {
  struct Set {
    double offset, digits;
  };
  for (const Set& set : {Set{1, 13}, Set{1e6, 9}, Set{1e12, 2.5}}) {
    std::vector<PrecisionGroup> groups;
    for (int g = 0; g < 9; ++g) {
      const int tenths = g == 0 ? 4 : g % 2 == 1 ? 3 : 5;
      const auto value = [&](int t) { return (10 * set.offset + t) / 10; };  // the double nearest to the decimal
      PrecisionGroup group{std::to_string(g), {value(tenths)}};
      for (int i = 0; i < 10; ++i) group.values.insert(group.values.end(), {value(tenths - 1), value(tenths + 1)});
      groups.push_back(group);
    }
    const auto r = precisionStudy(groups);
    ASSERT_TRUE(r) << r.error().message();
    EXPECT_GE(digits(r->f, 21), set.digits) << set.offset;
    EXPECT_GE(digits(r->msBetween, 0.21), set.digits) << set.offset;
    EXPECT_GE(digits(r->msWithin, 0.01), set.digits) << set.offset;
    EXPECT_GE(digits(r->sr, 0.1), set.digits) << set.offset;
  }
}

TEST(Regression, NistNorris) {
  const std::vector<double> y = {0.1, 338.8, 118.1, 888.0, 9.2,   228.1, 668.5, 998.5, 449.1, 778.9, 559.2, 0.3,
                                 0.1, 778.1, 668.8, 339.3, 448.9, 10.8,  557.7, 228.3, 998.0, 888.8, 119.6, 0.3,
                                 0.6, 557.6, 339.3, 888.0, 998.5, 778.9, 10.2,  117.6, 228.9, 668.4, 449.2, 0.2};
  const std::vector<double> x = {0.2, 337.4, 118.2, 884.6, 10.1,  226.5, 666.3, 996.3, 448.6, 777.0, 558.2, 0.4,
                                 0.6, 775.5, 666.9, 338.0, 447.5, 11.6,  556.0, 228.1, 995.8, 887.6, 120.2, 0.3,
                                 0.3, 556.8, 339.1, 887.2, 999.0, 779.0, 11.1,  118.3, 229.2, 669.1, 448.9, 0.5};
  const auto line = regress(x, y);
  ASSERT_TRUE(line) << line.error().message();
  EXPECT_GE(digits(line->slope, 1.00211681802045), 13);
  EXPECT_GE(digits(line->intercept, -0.262323073774029), 12);
  EXPECT_GE(digits(line->sdResidual, 0.884796396144373), 12);
  EXPECT_GE(digits(line->sdSlope, 0.429796848199937E-03), 12);
  EXPECT_GE(digits(line->sdIntercept, 0.232818234301152), 12);
  EXPECT_GE(digits(line->r2, 0.999993745883712), 13);
}

TEST(Regression, RefusesWhatIsNoLine) {
  const std::vector<double> same = {1, 1, 1}, two = {1, 2};
  EXPECT_FALSE(regress(same, same));
  EXPECT_FALSE(regress(two, two));
  const std::vector<double> x = {1, 2, 3}, y = {2, 4, 6};
  const auto exact = regress(x, y);
  ASSERT_TRUE(exact);
  EXPECT_EQ(exact->slope, 2);
  EXPECT_EQ(exact->pSlope, 0) << "nothing scatters: the slope is certain";
  EXPECT_EQ(exact->pIntercept, 1);
}

TEST(Sample, IntervalsAgreeWithTables) {
  const Sample s = describe(std::vector<double>{8, 10, 12});  // s = 2, t(0.975, 2) = 4.303
  EXPECT_NEAR(meanInterval(s, 0.05).high, 10 + 4.3027 * 2 / std::sqrt(3.0), 1e-4);
  const ValueRange sd = sdInterval(1, 10, 0.05);  // chi2(0.975, 10) = 20.483, chi2(0.025, 10) = 3.247
  EXPECT_NEAR(sd.low, std::sqrt(10 / 20.483), 1e-4);
  EXPECT_NEAR(sd.high, std::sqrt(10 / 3.247), 1e-4);
}

}  // namespace
}  // namespace vignole
