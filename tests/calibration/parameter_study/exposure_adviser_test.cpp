#include "calibration/parameter_study/exposure_adviser.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>

#include "engine/simulator/rail_motion.h"

namespace vignole {
namespace {

/// A camera whose light grows with the exposure: contrast 8 DN a ms, clipped from 255 on; noise of reading and light.
ExposureReading reading(double exposureMs, double dnPerMs = 8, int camera = 0) {
  ExposureReading r;
  r.exposureMs = exposureMs;
  r.scene = "scene";
  r.camera = camera;
  r.points = 1000;
  r.contrastDn = std::min(240.0, dnPerMs * exposureMs);
  r.weakDn = 0.3 * dnPerMs * exposureMs;
  r.noiseDn = std::sqrt(9 + 0.02 * r.contrastDn);
  r.saturated = dnPerMs * exposureMs > 200 ? 0.1 : 0;
  r.sigmaPx = r.noiseDn / r.contrastDn;
  r.widthPx = 3;
  r.mmPerPx = 0.2;
  return r;
}

std::vector<ExposureReading> readings(const std::vector<double>& exposures, double dnPerMs = 8) {
  std::vector<ExposureReading> all;
  for (const double ms : exposures) all.push_back(reading(ms, dnPerMs));
  return all;
}

std::string reasons(const ExposureAdvice& advice) {
  std::string all;
  for (const std::string& reason : advice.reasons) all += reason + "\n";
  return all;
}

TEST(MotionBlur, IsThatOfAnAveragedSine) {
  RailMotionModel motion{0, 0.05, 23, 0};
  // Variance within a window, averaged over 1000 phases, summed up numerically.
  for (const double exposureMs : {2.0, 15.0, 60.0}) {
    double sum = 0;
    for (int p = 0; p < 1000; ++p) {
      double mean = 0, square = 0;
      for (int i = 0; i < 200; ++i) {
        const double t = exposureMs / 1000 * (i + 0.5) / 200;
        const double x = 0.05 * std::numbers::sqrt2 * std::sin(2 * std::numbers::pi * (23 * t + p / 1000.0));
        mean += x / 200;
        square += x * x / 200;
      }
      sum += (square - mean * mean) / 1000;
    }
    EXPECT_NEAR(motionBlurMm(motion, exposureMs), std::sqrt(sum), 1e-3 * std::sqrt(sum)) << exposureMs;
  }
}

TEST(MotionBlur, AlongTheRailCountsOnlyWhatChangesAlongIt) {
  EXPECT_EQ(motionBlurMm({5, 0, 20, 0}, 15), 0) << "a straight rail slides through the light plane";
  EXPECT_NEAR(motionBlurMm({2, 0, 20, 1}, 15), 2 * 0.015 / std::sqrt(12.0), 1e-12) << "1 mm/m, 30 mm on the way";
}

/// The virtual rail: five sines of 5 to 30 Hz in x and y, 0.05 mm together; their mean square frequency is 18.9^2 Hz^2.
TEST(MotionBlur, AgreesWithTheVirtualRail) {
  for (const double exposureMs : {5.0, 15.0}) {
    double variance = 0;
    int n = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      const simulator::RailMotion rail(seed, {.wander = 0, .vibration = 1, .exposureS = exposureMs / 1000});
      for (double timeS = 0; timeS < 4; timeS += 0.037, ++n) variance += rail.exposed(timeS).covariance(0, 0);
    }
    // The virtual rail takes 8 steps within an exposure: 1 - 1/64 of the variance of a straight way.
    const double model = motionBlurMm({0, 0.05, 18.9, 0}, exposureMs);
    EXPECT_NEAR(std::sqrt(variance / n), model, 0.08 * model) << exposureMs;
  }
}

TEST(HighestRate, IsThePapersSixtySix) {
  EXPECT_NEAR(highestRateHz({}, 15), 66.7, 0.05);
  EXPECT_NEAR(highestRateHz({}, 5), 1000 / 11.5, 1e-9) << "reading out takes longer than the exposure";
  EXPECT_NEAR(highestRateHz({11.5, 0, false}, 15), 1000 / 26.5, 1e-9);
  EXPECT_NEAR(highestRateHz({11.5, 1, true}, 15), 1000 / 16.0, 1e-9);
}

TEST(ExposureAdvice, TakesTheShortestThatIsNearlyAsGoodAsTheBest) {
  ExposureSettings settings;
  settings.tolerance = 0.35;
  const auto advice = adviseExposure(readings({2, 5, 10, 15, 20, 30}), settings);
  ASSERT_TRUE(advice);
  EXPECT_EQ(advice->bestMs, 20) << "30 is saturated: " << reasons(*advice);
  EXPECT_EQ(advice->exposureMs, 15);
  EXPECT_THAT(reasons(*advice),
              testing::AllOf(testing::HasSubstr("30 ms: saturated"), testing::HasSubstr("2 ms: too dark"),
                             testing::HasSubstr("66.7 triggers a second")));
}

TEST(ExposureAdvice, TheWantedRateLimitsTheExposure) {
  ExposureSettings settings;
  settings.rateHz = 80;
  settings.motion.speedMPerS = 1.6;
  const auto advice = adviseExposure(readings({10, 12, 15}), settings);
  ASSERT_TRUE(advice);
  EXPECT_EQ(advice->exposureMs, 12) << reasons(*advice);
  EXPECT_NEAR(advice->rows[1].spacingMm, 20, 1e-9);
  EXPECT_THAT(reasons(*advice), testing::HasSubstr("15 ms: too slow: 66.7"));
}

TEST(ExposureAdvice, TheWorstSurfaceDecides) {
  auto all = readings({5, 10, 15});
  for (const double ms : {5.0, 10.0, 15.0}) {
    all.push_back(reading(ms, 2));  // scale
    all.back().scene = "scale";
  }
  const auto advice = adviseExposure(all, {});
  ASSERT_TRUE(advice);
  EXPECT_THAT(advice->rows[2].weakSnr, testing::DoubleNear(0.3 * 30 / std::sqrt(9.6), 1e-9));
  EXPECT_FALSE(advice->exposureMs) << "the scale is too dark in all";
  EXPECT_THAT(reasons(*advice), testing::HasSubstr("more light"));
}

TEST(ExposureAdvice, SmearIsAddedToPicturesTakenAtRest) {
  ExposureSettings settings;
  settings.motion.vibrationMm = 0.5;
  settings.motion.vibrationHz = 30;
  const auto moving = adviseExposure(readings({5, 20}), settings);
  settings.takenAtRest = true;
  const auto atRest = adviseExposure(readings({5, 20}), settings);
  ASSERT_TRUE(moving && atRest);
  const double b = motionBlurMm(settings.motion, 20) / 0.2;
  EXPECT_GT(b, 1);
  const double v = 9 + 2.2 * 2.2;  // of the line and of the filter
  EXPECT_NEAR(atRest->rows[1].sigmaPx / moving->rows[1].sigmaPx, std::pow((v + b * b) / v, 1.5), 1e-9);
  EXPECT_THAT(reasons(*atRest), testing::HasSubstr("20 ms: motion: smeared"));
}

TEST(ExposureAdvice, PicturesWithoutALineAreCounted) {
  auto all = readings({5, 10});
  all.push_back({5, "dark"});
  all.push_back(reading(10));
  all.back().scene = "dark";
  const auto advice = adviseExposure(all, {});
  ASSERT_TRUE(advice);
  EXPECT_EQ(advice->rows[0].empty, 1);
  EXPECT_NEAR(advice->rows[0].coverage, 0.5, 1e-12);
  EXPECT_EQ(advice->exposureMs, 10);
  EXPECT_THAT(reasons(*advice), testing::HasSubstr("5 ms: no line in 1 of 2 pictures"));
}

TEST(ExposureAdvice, OneExposureIsNoChoice) {
  const auto advice = adviseExposure(readings({5, 5}), {});
  ASSERT_FALSE(advice);
  EXPECT_THAT(advice.error().message(), testing::HasSubstr("two exposures"));
}

}  // namespace
}  // namespace vignole
