#include "calibration/next_pose/next_pose.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <numbers>

#include "calibration/intrinsics/reprojection.h"
#include "engine/measurement/measurement.h"
#include "engine/rail/catalogue.h"
#include "tests/calibration/synthetic_target/synthetic_views.h"

namespace vignole {
namespace {

SyntheticSettings usual(int views) {
  SyntheticSettings settings{.target = chessboard(9, 6, 20), .camera = usualCamera()};
  settings.camera.kappa = -4e-4;
  settings.views = views;
  return settings;
}

CalibrationWorth railWorth(const Intrinsics& in) {
  const Section section = *findSection("60E1");
  const auto worth = worthInDimensions(in, section, defaultParameters(section));
  EXPECT_TRUE(worth.has_value()) << worth.error().message();
  return *worth;
}

IntrinsicsCalibration calibrated(const std::vector<TargetView>& views, const PlanarTarget& target) {
  IntrinsicsSettings settings;
  settings.openCvReference = false;
  return *calibrateIntrinsics(views, target, settings);
}

TEST(CalibrationWorth, APoseTakesUpMostOfWhatTheIntrinsicsErr) {
  const CalibrationWorth worth = railWorth(usual(1).camera);
  ASSERT_GE(worth.effects.size(), 10U);
  IntrinsicCovariance covariance = IntrinsicCovariance::Zero();
  covariance(0, 0) = std::pow(5e-4 * 16.2, 2);  // f by 5e-4: HW alone would scale by that, 36 um
  for (const auto& effect : worth.effects) {
    const double uMm = CalibrationWorth::uncertainty(effect, covariance);
    EXPECT_GT(uMm, 0) << name(*effect.dimension);
    if (effect.dimension == Dimension::HW) {
      EXPECT_LT(uMm, 0.01);
    }
  }
}

TEST(CalibrationWorth, OfTheFocalLengthInThePictureIsLittleAtOneDistance) {
  const Intrinsics in = usual(1).camera;
  const CalibrationWorth worth = worthInPicture(in, 400);
  ASSERT_EQ(worth.effects.size(), 1U);
  IntrinsicCovariance covariance = IntrinsicCovariance::Zero();
  covariance(0, 0) = 1e-4;
  EXPECT_LT(CalibrationWorth::uncertainty(worth.effects[0], covariance), 1e-3)
      << "a flat scene moved nearer looks alike";
  covariance.setZero();
  covariance(4, 4) = 1e-12;  // kappa
  EXPECT_GT(CalibrationWorth::uncertainty(worth.effects[0], covariance), 1e-4);
}

TEST(CalibrationWorth, RefusesACameraThatIsNoneOfTheRig) {
  Intrinsics tele = usual(1).camera;
  tele.focalMm = 200;
  const Section section = *findSection("60E1");
  EXPECT_FALSE(worthInDimensions(tele, section, defaultParameters(section)).has_value());
}

/// The advice followed: what is left must be what was foretold, and less than what random views would leave.
TEST(NextPose, KeepsItsPromise) {
  const SyntheticSettings settings = usual(5);
  std::mt19937_64 random(61);
  SyntheticViews views = syntheticViews(settings, random);
  const IntrinsicsCalibration before = calibrated(views.views, settings.target);
  const CalibrationWorth worth = railWorth(before.camera.intrinsics);
  const auto next = nextPose(before, settings.target, worth);
  ASSERT_TRUE(next.has_value()) << next.error().message();
  EXPECT_LT(next->remainingShare, 0.7);

  TargetView followed = views.views.front();
  followed.points.clear();
  std::normal_distribution<double> noise(0, settings.noisePx);
  for (std::size_t i = 0; i < views.points.size(); ++i) {
    const Point2 px =
        reprojected(settings.camera, next->cameraFromTarget, views.points[i], 0) + Point2(noise(random), noise(random));
    if (px.x() > 5 && px.y() > 5 && px.x() < 1394 && px.y() < 1018)
      followed.points.push_back({static_cast<int>(i), px, settings.noisePx});
  }
  followed.file = "followed.png";
  auto more = views.views;
  more.push_back(followed);
  const IntrinsicsCalibration after = calibrated(more, settings.target);
  ASSERT_EQ(after.variant, before.variant);
  EXPECT_TRUE(after.views.back().used) << after.views.back().reason;
  const auto left = [&](const IntrinsicsCalibration& c) {
    double sum = 0;
    for (const auto& effect : worth.effects)
      sum += std::pow(CalibrationWorth::uncertainty(effect, c.camera.covariance) /
                          CalibrationWorth::uncertainty(effect, before.camera.covariance),
                      2);
    return sum / static_cast<double>(worth.effects.size());
  };
  EXPECT_NEAR(left(after), next->remainingShare, 0.15 * next->remainingShare);

  std::mt19937_64 other(62);
  for (const TargetView& chance : syntheticViews(usual(4), other).views) {
    auto with = views.views;
    with.push_back(chance);
    EXPECT_LT(left(after), left(calibrated(with, settings.target)));
  }
}

TEST(NextPose, TellsHowToTiltWhatWasNeverTilted) {
  SyntheticSettings settings = usual(6);
  settings.minTiltDeg = 0;
  settings.maxTiltDeg = 2;
  std::mt19937_64 random(63);
  const IntrinsicsCalibration c = calibrated(syntheticViews(settings, random).views, settings.target);
  EXPECT_FALSE(c.accepted());
  const auto next = nextPose(c, settings.target, railWorth(c.camera.intrinsics));
  ASSERT_TRUE(next.has_value());
  EXPECT_NE(next->words.find("tilt the"), std::string::npos) << next->words;
  EXPECT_LT(next->remainingShare, 0.1);
}

/// Words, pose and outline say the same.
TEST(NextPose, SaysWhatItDraws) {
  const SyntheticSettings settings = usual(5);
  std::mt19937_64 random(64);
  const IntrinsicsCalibration c = calibrated(syntheticViews(settings, random).views, settings.target);
  const CalibrationWorth worth = railWorth(c.camera.intrinsics);
  const Eigen::Vector3d middle(80, 50, 0);
  NextPoseSettings one;
  one.tiltsDeg = {30};
  one.turnsDeg = {0};
  one.distances = {0.5};
  const auto next = nextPose(c, settings.target, worth, one);
  ASSERT_TRUE(next.has_value());
  const Eigen::Matrix3d& r = next->cameraFromTarget.rotation;
  EXPECT_NEAR(std::acos(r(2, 2)) * 180 / std::numbers::pi, 30, 1e-6);
  EXPECT_NE(next->words.find("30 degrees"), std::string::npos);
  // Depth grows towards the side that is tilted away.
  const double right = r(2, 0), down = r(2, 1);
  const auto says = [&](const char* word) {
    return next->words.substr(0, next->words.find(" away")).find(word) != std::string::npos;
  };
  EXPECT_EQ(says("right"), right > 0.1) << next->words;
  EXPECT_EQ(says("left"), right < -0.1) << next->words;
  EXPECT_EQ(says("bottom") || says("lower"), down > 0.1) << next->words;
  EXPECT_EQ(says("top") || says("upper"), down < -0.1) << next->words;
  const Point2 at = reprojected(c.camera.intrinsics, next->cameraFromTarget, middle, 0);
  const std::string place = next->words.substr(next->words.find(" degrees"));
  EXPECT_EQ(place.find("left") != std::string::npos, at.x() < 500) << next->words;
  EXPECT_EQ(place.find("lower") != std::string::npos, at.y() > 680) << next->words;
  Point2 mean(0, 0);
  for (const Point2& p : next->outlinePx) mean += p / static_cast<double>(next->outlinePx.size());
  EXPECT_LT((mean - at).norm(), 60);
  EXPECT_EQ(next->outlinePx.front(), next->outlinePx.back()) << "closed";
}

TEST(NextPose, NeedsACalibration) {
  const SyntheticSettings settings = usual(1);
  std::mt19937_64 random(65);
  const IntrinsicsCalibration c = calibrated(syntheticViews(settings, random).views, settings.target);
  EXPECT_FALSE(nextPose(c, settings.target, worthInPicture(settings.camera, 400)).has_value());
}

}  // namespace
}  // namespace vignole
