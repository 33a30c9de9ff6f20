#include "calibration/intrinsics/model_choice.h"

#include <gtest/gtest.h>
#include <random>

#include "tests/calibration/synthetic_target/synthetic_observations.h"

namespace vignole {
namespace {

constexpr auto kPolynomial = DistortionModel::Polynomial;

/// Squared residuals as if held out: `scale` times the variance in every view, noise of `random` on top.
HeldOut heldOut(const std::vector<double>& viewScales, unsigned seed) {
  std::mt19937_64 random(seed);
  std::exponential_distribution<double> square(1);
  HeldOut h;
  double sum = 0, count = 0;
  for (const double scale : viewScales) {
    std::vector<double>& view = h.squaresPx2.emplace_back();
    for (int i = 0; i < 50; ++i) {
      view.push_back(0.01 * scale * square(random));
      sum += view.back();
      count += 1;
    }
  }
  h.rmsPx = std::sqrt(sum / count);
  return h;
}

TEST(Worse, IsWhatIsWorseBeyondChance) {
  const std::vector<double> even(12, 1), worseEverywhere(12, 1.6);
  for (const PointErrors errors : {PointErrors::Independent, PointErrors::Shared}) {
    EXPECT_TRUE(worse(heldOut(worseEverywhere, 1), heldOut(even, 2), errors, 0.995));
    EXPECT_FALSE(worse(heldOut(even, 2), heldOut(worseEverywhere, 1), errors, 0.995));
    EXPECT_FALSE(worse(heldOut(even, 3), heldOut(even, 4), errors, 0.995));
  }
}

TEST(Worse, OnePictureDecidesNothingWhereItsErrorsAreShared) {
  std::vector<double> oneView(12, 1);
  oneView[5] = 30;
  EXPECT_TRUE(worse(heldOut(oneView, 1), heldOut(std::vector<double>(12, 1), 2), PointErrors::Independent, 0.995));
  EXPECT_FALSE(worse(heldOut(oneView, 1), heldOut(std::vector<double>(12, 1), 2), PointErrors::Shared, 0.995));
}

TEST(Worse, WhatCannotBePredictedIsWorse) {
  HeldOut broken = heldOut(std::vector<double>(6, 1), 1);
  broken.squaresPx2[2][3] = std::numeric_limits<double>::quiet_NaN();
  broken.rmsPx = std::numeric_limits<double>::infinity();
  const HeldOut good = heldOut(std::vector<double>(6, 1), 2);
  for (const PointErrors errors : {PointErrors::Independent, PointErrors::Shared}) {
    EXPECT_TRUE(worse(broken, good, errors, 0.995));
    EXPECT_FALSE(worse(good, broken, errors, 0.995));
  }
}

TEST(ChooseSimplest, TakesTheBestOfThoseWithAsManyParametersAndTheSimplestThatIsNotWorse) {
  const std::vector<LensVariant> variants = {
      {DistortionModel::Division}, {kPolynomial, 1}, {kPolynomial, 2}, {kPolynomial, 2, true}};
  const std::vector<double> bad(12, 2), good(12, 1);
  const auto chosen = [&](const std::array<std::vector<double>, 4>& scales) {
    std::vector<HeldOut> all;
    for (std::size_t i = 0; i < 4; ++i) all.push_back(heldOut(scales[i], 7));  // the same noise: exact order
    return name(variants[chooseSimplest(variants, all, PointErrors::Independent, 0.995)]);
  };
  EXPECT_EQ(chosen({good, bad, good, good}), "division");
  EXPECT_EQ(chosen({bad, good, good, good}), "k1");
  EXPECT_EQ(chosen({bad, bad, good, good}), "k1 k2");
  EXPECT_EQ(chosen({bad, bad, bad, good}), "k1 k2 p1 p2");
}

TEST(CrossValidate, JudgesEveryPointOfEveryView) {
  SyntheticSettings settings{.target = chessboard(9, 6, 20), .camera = usualCamera()};
  settings.camera.kappa = -6e-3;
  settings.views = 7;
  std::mt19937_64 random(21);
  const SyntheticViews views = syntheticViews(settings, random);
  TargetObservations observations = observationsOf(views, settings.target);
  observations.views[3].clear();  // a view that was rejected
  const std::vector<LensVariant> variants = {{DistortionModel::Division}, {kPolynomial, 1}};
  std::vector<TargetFit> fits;
  for (const LensVariant& v : variants)
    fits.push_back(adjust(observations, v, truthAsStart(views, settings.target, settings.camera, v)));
  const auto heldOut = crossValidate(observations, variants, fits, {}, {});
  ASSERT_TRUE(heldOut.has_value());
  for (const HeldOut& h : *heldOut)
    for (std::size_t v = 0; v < 7; ++v) EXPECT_EQ(h.squaresPx2[v].size(), observations.views[v].size());
  EXPECT_NEAR((*heldOut)[0].rmsPx, 0.05 * std::sqrt(2), 0.01) << "the noise, and a little for the pose";
  EXPECT_GT((*heldOut)[1].rmsPx, 0.1) << "k1 alone does not say a division lens";

  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(crossValidate(observations, variants, fits, {}, Job{{}, stop.get_token()}).has_value());
}

}  // namespace
}  // namespace vignole
