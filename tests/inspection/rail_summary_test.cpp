#include "engine/inspection/rail_summary.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "engine/rail/catalogue.h"

namespace vignole {
namespace {

class RailSummaryTest : public ::testing::Test {
 protected:
  void SetUp() override {
    auto section = findSection("60E1");
    ASSERT_TRUE(section) << section.error().message();
    recipe.name = "test";
    recipe.section = *section;
    recipe.limits[index(Dimension::RH)] = {-0.6, 0.6};
    recipe.limits[index(Dimension::HF)] = {-0.3, 0.6};
    recipe.limits[index(Dimension::FC)] = {{}, 0.3};
    rail.spacingMm = 100;
  }
  /// Profile number i with RH = 172 + deviation, judged with guard band 0.02 as the measurement does.
  ProfileResult profile(std::uint64_t i, std::optional<double> deviation, double u = 0.01) const {
    ProfileResult r;
    r.profile.trigger = i;
    r.profile.positionMm = 100.0 * static_cast<double>(i);
    r.registration.valid = true;
    DimensionResult& rh = r.measurement.dimensions[index(Dimension::RH)];
    rh.nominalMm = 172;
    rh.lowerMm = 171.4;
    rh.upperMm = 172.6;
    rh.uMm = u;
    if (!deviation) {
      rh.reason = "too few points on AHT";
      return r;
    }
    rh.valueMm = 172 + *deviation;
    const double beyond = std::abs(*deviation) - 0.6;
    rh.verdict = beyond > 2 * u ? Verdict::Fail : beyond > -2 * u ? Verdict::Near : Verdict::Pass;
    return r;
  }
  RailSummary summarise(const std::vector<std::optional<double>>& deviations, RailSummarySettings settings = {}) {
    RailSummariser summariser(rail, recipe, "cal", settings);
    for (std::size_t i = 0; i < deviations.size(); ++i) summariser.add(profile(i, deviations[i]));
    return summariser.summary({});
  }
  static const DimensionSummary& rh(const RailSummary& summary) { return summary.dimensions[index(Dimension::RH)]; }

  Recipe recipe;
  RailBegin rail;
};

TEST_F(RailSummaryTest, MeanExtremesAndUncertainty) {
  const RailSummary summary = summarise({0.1, -0.1, 0.3, 0.1});
  EXPECT_EQ(summary.profiles, 4U);
  EXPECT_NEAR(rh(summary).values.mean(), 172.1, 1e-9);
  EXPECT_NEAR(rh(summary).values.min(), 171.9, 1e-9);
  EXPECT_NEAR(rh(summary).values.max(), 172.3, 1e-9);
  EXPECT_NEAR(rh(summary).uMm, 0.01, 1e-12);
  EXPECT_NEAR(*rh(summary).lowerMm, 171.4, 1e-6);
  EXPECT_NEAR(*rh(summary).upperMm, 172.6, 1e-6);
  EXPECT_EQ(rh(summary).verdict, Verdict::Pass);
  EXPECT_NEAR(summary.lengthM, 0.4, 1e-12);
}

TEST(RadiusMean, WeighsCurvaturesWhereThePlainMeanOfTheRadiiIsSkewed) {
  // Every other profile four times as uncertain. The plain mean of radii is off by their u^2 / R.
  constexpr double kRadius = 300, kU = 2.5e-4;
  constexpr int kRails = 2000, kProfiles = 100;
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal(0, 1);
  double plain = 0, error = 0, overU = 0;
  for (int r = 0; r < kRails; ++r) {
    RadiusMean mean;
    for (int i = 0; i < kProfiles; ++i) {
      const double u = i % 2 == 0 ? kU : 4 * kU, curvature = 1 / kRadius + u * normal(random);
      mean.add(1 / curvature, u / (curvature * curvature));
      plain += (1 / curvature - kRadius) / (kRails * kProfiles);
    }
    const double e = mean.radiusMm() - kRadius;
    error += e / kRails;
    overU += e * e / (mean.uMm() * mean.uMm() * kRails);
  }
  // Fifty good profiles and fifty of a sixteenth of their weight: u of a rail's mean is 3.1 mm.
  EXPECT_LT(std::abs(error), 0.3);
  EXPECT_NEAR(overU, 1, 0.12);
  EXPECT_GT(plain, 5);
}

TEST_F(RailSummaryTest, TheHeadsRadiusIsThatOfTheMeanCurvature) {
  RailSummariser summariser(rail, recipe, "cal");
  for (const auto& [radius, u] : {std::pair(250.0, 2.5), std::pair(500.0, 40.0)}) {
    ProfileResult one = profile(0, 0.0);
    one.measurement.dimensions[index(Dimension::HR)].valueMm = radius;
    one.measurement.dimensions[index(Dimension::HR)].uMm = u;
    summariser.add(one);
  }
  const RailSummary summary = summariser.summary({});
  const DimensionSummary& hr = summary.dimensions[index(Dimension::HR)];
  // Curvatures 0.004 with u 4e-5 and 0.002 with u 1.6e-4: weights 16 to 1.
  EXPECT_NEAR(hr.meanMm(), 1 / ((16 * 0.004 + 0.002) / 17), 1e-9);
  EXPECT_NEAR(hr.uOfMeanMm(), hr.meanMm() * hr.meanMm() * 4e-5 * std::sqrt(16 / 17.0), 1e-9);
  EXPECT_NEAR(hr.values.mean(), 375, 1e-9);
}

TEST_F(RailSummaryTest, WhatTheCalibrationLeavesDoesNotAverageOut) {
  RailSummariser summariser(rail, recipe, "cal");
  for (int i = 0; i < 100; ++i) {
    ProfileResult one = profile(static_cast<std::uint64_t>(i), 0.0, std::hypot(0.01, 0.006));
    one.measurement.dimensions[index(Dimension::RH)].uCalibrationMm = 0.006;
    DimensionResult& hr = one.measurement.dimensions[index(Dimension::HR)];
    hr.valueMm = 300;
    hr.uMm = std::hypot(3, 0.5);
    hr.uCalibrationMm = 0.5;
    summariser.add(one);
  }
  const RailSummary summary = summariser.summary({});
  EXPECT_NEAR(rh(summary).uMm, std::hypot(0.01, 0.006), 1e-12);
  EXPECT_EQ(rh(summary).uCalibrationMm, 0.006);
  EXPECT_NEAR(rh(summary).uOfMeanMm(), std::hypot(0.001, 0.006), 1e-12);
  EXPECT_NEAR(summary.dimensions[index(Dimension::HR)].uOfMeanMm(), std::hypot(0.3, 0.5), 1e-9);
}

TEST_F(RailSummaryTest, AMeanOfOtherDimensionsIsPlainAndItsUncertaintyFallsWithTheProfiles) {
  const RailSummary summary = summarise({0.1, -0.1, 0.3, 0.1});
  EXPECT_EQ(rh(summary).meanMm(), rh(summary).values.mean());
  EXPECT_NEAR(rh(summary).uOfMeanMm(), 0.005, 1e-12);
  EXPECT_EQ(summary.dimensions[index(Dimension::HR)].meanMm(), 0);
}

TEST_F(RailSummaryTest, ThreeConsecutiveFailuresAreAnExceptionTwoAreNot) {
  std::vector<std::optional<double>> deviations(40, 0.0);
  deviations[5] = deviations[6] = 0.7;
  EXPECT_EQ(rh(summarise(deviations)).verdict, Verdict::Pass);
  EXPECT_TRUE(rh(summarise(deviations)).exceptions.empty());
  deviations[7] = 0.9;
  deviations[8] = 0.8;
  const RailSummary summary = summarise(deviations);
  ASSERT_EQ(rh(summary).exceptions.size(), 1U);
  EXPECT_NEAR(rh(summary).exceptions[0].fromM, 0.5, 1e-12);
  EXPECT_NEAR(rh(summary).exceptions[0].toM, 0.8, 1e-12);
  EXPECT_NEAR(rh(summary).exceptions[0].worstMm, 172.9, 1e-9);
  EXPECT_EQ(rh(summary).verdict, Verdict::Fail);
  EXPECT_EQ(summary.verdict, Verdict::Fail);
}

TEST_F(RailSummaryTest, ProfilesWithoutAValueNeitherEndNorLengthenAStretch) {
  std::vector<std::optional<double>> deviations(40, 0.0);
  deviations[10] = -0.7;
  deviations[11] = {};
  deviations[12] = -0.8;
  EXPECT_TRUE(rh(summarise(deviations)).exceptions.empty());
  deviations[13] = {};
  deviations[14] = -0.75;
  const RailSummary summary = summarise(deviations);
  ASSERT_EQ(rh(summary).exceptions.size(), 1U);
  EXPECT_NEAR(rh(summary).exceptions[0].toM, 1.4, 1e-12);
  EXPECT_NEAR(rh(summary).exceptions[0].worstMm, 171.2, 1e-9);
  EXPECT_EQ(rh(summary).notMeasured, 2U);
  EXPECT_EQ(rh(summary).reason, "too few points on AHT");
}

TEST_F(RailSummaryTest, AnExceptionThatReachesTheRailsEndIsTold) {
  std::vector<std::optional<double>> deviations(20, 0.0);
  for (std::size_t i = 16; i < 20; ++i) deviations[i] = 0.8;
  EXPECT_EQ(rh(summarise(deviations)).exceptions.size(), 1U);
}

TEST_F(RailSummaryTest, AskingInTheMiddleChangesNothing) {
  RailSummariser summariser(rail, recipe, "cal");
  for (std::uint64_t i = 0; i < 4; ++i) summariser.add(profile(i, 0.8));
  EXPECT_EQ(rh(summariser.summary({})).exceptions.size(), 1U);
  for (std::uint64_t i = 4; i < 6; ++i) summariser.add(profile(i, 0.8));
  EXPECT_EQ(rh(summariser.summary({})).exceptions.size(), 1U);
  EXPECT_NEAR(rh(summariser.summary({})).exceptions[0].toM, 0.5, 1e-12);
}

TEST_F(RailSummaryTest, AShortRailThatFailsFails) {
  EXPECT_EQ(rh(summarise({0.8, 0.8})).verdict, Verdict::Fail);
  EXPECT_EQ(rh(summarise({0.8, 0.0})).verdict, Verdict::Fail);
  EXPECT_EQ(rh(summarise({0.8, 0.0, 0.0})).verdict, Verdict::Pass);
}

TEST_F(RailSummaryTest, NearWhenAStretchCannotBeDecidedOrTheMeanTouchesTheGuardBand) {
  std::vector<std::optional<double>> deviations(30, 0.0);
  deviations[3] = deviations[4] = deviations[5] = 0.59;
  EXPECT_EQ(rh(summarise(deviations)).verdict, Verdict::Near);
  deviations[4] = 0.0;
  EXPECT_EQ(rh(summarise(deviations)).verdict, Verdict::Pass);
  EXPECT_EQ(rh(summarise({0.59, 0.585})).verdict, Verdict::Near);
}

TEST_F(RailSummaryTest, TheRailsVerdictIsTheWorstAndUnmeasuredIsNoPass) {
  EXPECT_EQ(summarise({0.0, 0.0}).verdict, Verdict::NotMeasured) << "HF and FC have limits and no value";
  recipe.limits[index(Dimension::HF)] = {};
  recipe.limits[index(Dimension::FC)] = {};
  EXPECT_EQ(summarise({0.0, 0.0}).verdict, Verdict::Pass);
  EXPECT_EQ(summarise({0.0, 0.0}).dimensions[index(Dimension::HW)].verdict, Verdict::NoLimit);
  recipe.limits = {};
  EXPECT_EQ(summarise({0.0}).verdict, Verdict::NoLimit);
}

TEST_F(RailSummaryTest, ARailOfAnotherSectionIsNamedIfHalfOfItSaysSo) {
  recipe.limits[index(Dimension::HF)] = {};
  recipe.limits[index(Dimension::FC)] = {};
  for (const std::uint64_t others : {3U, 4U, 5U}) {
    RailSummariser summariser(rail, recipe, "cal");
    for (std::uint64_t i = 0; i < 8; ++i) {
      const bool other = i < others;
      ProfileResult r = profile(i, other ? std::nullopt : std::optional(0.0));
      if (other) {
        r.registration.valid = false;
        r.registration.reason = "wrong section: looks like 60E2";
        r.registration.looksLike = OtherSection{"60E2", 0.4, i % 2 == 0 ? 3.0 : 5.0, {}};
      }
      summariser.add(r);
    }
    const RailSummary summary = summariser.summary({});
    EXPECT_EQ(rh(summary).reason, "wrong section: looks like 60E2");
    EXPECT_EQ(summary.looksLike.has_value(), others >= 4);
    EXPECT_EQ(summary.verdict, others >= 4 ? Verdict::NotMeasured : Verdict::Pass);
    if (others != 4) continue;
    EXPECT_EQ(summary.looksLike->section, "60E2");
    EXPECT_EQ(summary.looksLike->profiles, 4U);
    EXPECT_NEAR(summary.looksLike->chi2OfRecipe, 4, 1e-12);
  }
}

TEST_F(RailSummaryTest, HeadFormBelowItsLowerLimitIsToldByItsSmallestDeviation) {
  RailSummariser summariser(rail, recipe, "cal");
  for (std::uint64_t i = 0; i < 3; ++i) {
    ProfileResult r = profile(i, 0.0);
    DimensionResult& hf = r.measurement.dimensions[index(Dimension::HF)];
    hf.valueMm = 0.05;
    hf.secondMm = -0.5 - 0.01 * static_cast<double>(i);
    hf.lowerMm = -0.3;
    hf.upperMm = 0.6;
    hf.uMm = 0.01;
    hf.verdict = Verdict::Fail;
    summariser.add(r);
  }
  const RailSummary summary = summariser.summary({});
  const DimensionSummary& hf = summary.dimensions[index(Dimension::HF)];
  ASSERT_EQ(hf.exceptions.size(), 1U);
  EXPECT_NEAR(hf.exceptions[0].worstMm, -0.52, 1e-12);
}

TEST_F(RailSummaryTest, TheTrackKeepsItsSizeMeansAndExtremesWhateverTheLength) {
  RailSummarySettings settings;
  settings.trackBins = 16;
  RailSummariser summariser(rail, recipe, "cal", settings);
  const auto deviation = [](std::uint64_t i) { return 0.2 * std::sin(0.01 * static_cast<double>(i)); };
  constexpr std::uint64_t kProfiles = 1000;
  for (std::uint64_t i = 0; i < kProfiles; ++i)
    if (i % 7 != 3) summariser.add(profile(i, deviation(i)));
  const RailSummary summary = summariser.summary({});
  const auto& track = rh(summary).track;
  ASSERT_LE(track.size(), 16U);
  ASSERT_GE(track.size(), 8U);
  const double width = track[1].positionM - track[0].positionM;
  std::uint64_t counted = 0;
  for (const TrackBin& bin : track) {
    double sum = 0, min = 1e9, max = -1e9;
    std::uint32_t n = 0;
    for (std::uint64_t i = 0; i < kProfiles; ++i) {
      const double position = 0.1 * static_cast<double>(i);
      if (i % 7 == 3 || position < bin.positionM - width / 2 - 1e-6 || position >= bin.positionM + width / 2 - 1e-6)
        continue;
      const double value = 172 + deviation(i);
      sum += value;
      min = std::min(min, value);
      max = std::max(max, value);
      ++n;
    }
    ASSERT_EQ(bin.count, n) << bin.positionM;
    EXPECT_NEAR(bin.meanMm, sum / n, 1e-9);
    EXPECT_DOUBLE_EQ(bin.minMm, min);
    EXPECT_DOUBLE_EQ(bin.maxMm, max);
    counted += n;
  }
  EXPECT_EQ(counted, rh(summary).values.count());
}

TEST_F(RailSummaryTest, AGapShowsAsABinWithoutValues) {
  rail.lengthMm = 2000;
  std::vector<std::optional<double>> deviations(20, 0.1);
  deviations[7] = {};
  const RailSummary summary = summarise(deviations);
  ASSERT_EQ(rh(summary).track.size(), 20U);
  EXPECT_EQ(rh(summary).track[7].count, 0U);
  EXPECT_EQ(rh(summary).track[8].count, 1U);
}

TEST_F(RailSummaryTest, TooManyExceptionsWidenTheLast) {
  RailSummarySettings settings;
  settings.maxExceptions = 2;
  std::vector<std::optional<double>> deviations;
  for (int k = 0; k < 4; ++k) {
    for (int i = 0; i < 3; ++i) deviations.emplace_back(0.7 + 0.01 * k);
    for (int i = 0; i < 3; ++i) deviations.emplace_back(0.0);
  }
  const RailSummary summary = summarise(deviations, settings);
  ASSERT_EQ(rh(summary).exceptions.size(), 2U);
  EXPECT_NEAR(rh(summary).exceptions[1].fromM, 0.6, 1e-12);
  EXPECT_NEAR(rh(summary).exceptions[1].toM, 2.0, 1e-12);
  EXPECT_NEAR(rh(summary).exceptions[1].worstMm, 172.73, 1e-9);
}

}  // namespace
}  // namespace vignole
