// What is claimed about the points against their scatter.

#include "engine/stripe/uncertainty.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "engine/stripe/stripe_extractor.h"
#include "tests/synthetic/stripe_scene.h"
#include "tests/synthetic/stripe_score.h"

namespace vignole {
namespace {

using synthetic::StraightLine;

/// Errors along the normal of the points of a nearly horizontal line, by column; NaN where the line's end is near.
std::vector<std::vector<double>> errorsOverFrames(const StraightLine& line, const StripeSettings& settings, int frames,
                                                  double& meanVariance, double& correlated) {
  std::vector<std::vector<double>> errors;
  double variances = 0, count = 0, correlatedSum = 0;
  StripeExtractor extractor(settings);
  StripeResult result;
  for (int f = 0; f < frames; ++f) {
    const auto pixels = synthetic::straightLinePicture(line, 100 + static_cast<std::uint64_t>(f));
    extractor.extract({pixels.data(), line.width, line.height, line.width}, result);
    errors.emplace_back(static_cast<std::size_t>(line.width), std::nan(""));
    for (const StripePoint& p : result.points) {
      if ((p.flags & kLineEnd) != 0) continue;
      // Of the ridge: its errors are those of the filter.
      const double x = p.x - p.shiftPx * p.nx, y = p.y - p.shiftPx * p.ny;
      const double e = (x - line.x0) * std::cos(line.angleRad) + (y - line.y0) * std::sin(line.angleRad);
      errors.back()[static_cast<std::size_t>(std::lround(x))] = e;
      variances += static_cast<double>(p.ridgeSigmaPx) * p.ridgeSigmaPx;
      ++count;
    }
    correlatedSum += result.correlatedPoints;
  }
  meanVariance = variances / count;
  correlated = correlatedSum / frames;
  return errors;
}

struct Case {
  double sigma, stripe, contrast, noise;
};

class Scatter : public testing::TestWithParam<Case> {};

TEST_P(Scatter, IsWhatSigmaPxSays) {
  const Case c = GetParam();
  StraightLine line{.width = 400, .height = 120, .x0 = 200, .y0 = 60, .angleRad = 1.5};
  line.contrast = c.contrast;
  line.sigma = c.stripe;
  line.noiseDn = c.noise;
  StripeSettings settings;
  settings.sigma = c.sigma;
  double variance = 0, correlated = 0;
  double squares = 0, count = 0;
  for (const auto& frame : errorsOverFrames(line, settings, 40, variance, correlated))
    for (const double e : frame)
      if (!std::isnan(e)) {
        squares += e * e;
        ++count;
      }
  EXPECT_GT(count, 40 * 350);
  EXPECT_NEAR(std::sqrt(squares / count) / std::sqrt(variance), 1, 0.12);
}

INSTANTIATE_TEST_SUITE_P(Stripe, Scatter,
                         testing::Values(Case{3, 3, 150, 4}, Case{3, 3, 40, 4}, Case{3, 2, 60, 3}, Case{3, 4, 100, 6},
                                         Case{4, 3, 100, 8}, Case{2, 3, 120, 4}, Case{1.5, 2, 120, 3}));

TEST(Uncertainty, IsStegersFormula) {
  // sn/A (s^2 + sigma^2)^1.5 / (sqrt(8 pi) sigma^2 s): 0.0150 px for A = 150, sn = 4, s = sigma = 3
  EXPECT_NEAR(4.0 / 150 * gradientNoise(3) / ridgePerContrast(3, 3), 0.0150, 5e-5);
  // sn sqrt(3/(16 pi)) / sigma^3 in DN of line contrast is 0.691 sn / sigma
  EXPECT_NEAR(ridgeNoise(3) / ridgePerContrast(3, 3), 0.691 / 3, 1e-3);
}

TEST(Uncertainty, CorrelatedPointsAreWhatAMeanOverTheLineShows) {
  // The variance of the mean of N points is that of a point times correlatedPoints / N.
  for (const double sigma : {2.0, 3.0, 4.0}) {
    StraightLine line{.width = 400, .height = 120, .x0 = 200, .y0 = 60, .angleRad = 1.57};
    line.noiseDn = 5;
    StripeSettings settings;
    settings.sigma = sigma;
    double variance = 0, correlated = 0, single = 0, singles = 0, means = 0, meanCount = 0;
    for (const auto& frame : errorsOverFrames(line, settings, 60, variance, correlated))
      for (int first = 40; first + 100 <= 360; first += 110) {
        double sum = 0;
        int n = 0;
        for (int x = first; x < first + 100; ++x) {
          const double e = frame[static_cast<std::size_t>(x)];
          if (std::isnan(e)) continue;
          single += e * e;
          ++singles;
          sum += e;
          ++n;
        }
        means += sum / n * sum / n * n;
        ++meanCount;
      }
    EXPECT_NEAR(means / meanCount / (single / singles), correlated, 0.3 * correlated) << sigma;
  }
}

TEST(Uncertainty, OfEveryScene) {
  for (const char* name : synthetic::kSceneNames) {
    double z2 = 0;
    for (std::uint64_t seed = 21; seed < 24; ++seed) {
      const synthetic::StripeScene scene = synthetic::stripeScene(name, seed);
      StripeResult result;
      StripeExtractor({}).extract(scene.view(), result);
      z2 += synthetic::score(scene, result.points).meanSquareZ / 3;
    }
    EXPECT_GT(z2, 1 / (1.3 * 1.3)) << name;
    EXPECT_LT(z2, 1 / (0.7 * 0.7)) << name;
  }
}

TEST(Uncertainty, SpeckleRaisesIt) {
  const auto sigmaOf = [](const char* name) {
    const synthetic::StripeScene scene = synthetic::stripeScene(name, 31);
    StripeResult result;
    StripeExtractor({}).extract(scene.view(), result);
    std::vector<float> sigmas;
    for (const StripePoint& p : result.points) sigmas.push_back(p.ridgeSigmaPx);
    std::sort(sigmas.begin(), sigmas.end());
    return sigmas[sigmas.size() / 2];
  };
  EXPECT_GT(sigmaOf("wide"), 0.12);
  EXPECT_LT(sigmaOf("rail"), 0.05);
}

}  // namespace
}  // namespace vignole
