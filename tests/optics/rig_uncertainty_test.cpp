#include "engine/optics/rig_uncertainty.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <random>

namespace vignole {
namespace {

constexpr int at(int camera, CameraParameter p) { return camera * kCameraParameters + static_cast<int>(p); }

/// A covariance of rank `rank` whose parameters differ in size by orders of magnitude, as real ones do.
Eigen::MatrixXd covarianceOfRank(int rank, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd effects = Eigen::MatrixXd::Zero(kRigParameters, rank);
  for (int i = 0; i < kRigParameters; ++i) {
    if (i % kCameraParameters == static_cast<int>(CameraParameter::K3)) continue;  // was not estimated
    const double scale = std::pow(10.0, -(i % 8));
    for (int j = 0; j < rank; ++j) effects(i, j) = scale * normal(random);
  }
  return effects * effects.transpose();
}

TEST(RigUncertainty, AChangeIsAddedToItsParameterAlone) {
  const RigCalibration before;
  RigChange change = RigChange::Zero();
  change[at(1, CameraParameter::F)] = 0.25;
  change[at(1, CameraParameter::V0)] = 1.5;
  change[at(2, CameraParameter::Kappa)] = 1e-4;
  change[at(3, CameraParameter::P2)] = 2e-5;
  change[at(3, CameraParameter::T3)] = -0.5;
  RigCalibration after = before;
  apply(change, after);
  EXPECT_EQ(after.rangeFinders[0].intrinsics.focalMm, before.rangeFinders[0].intrinsics.focalMm);
  EXPECT_DOUBLE_EQ(after.rangeFinders[1].intrinsics.focalMm, 16.25);
  EXPECT_DOUBLE_EQ(after.rangeFinders[1].intrinsics.cyPx, 513.0);
  EXPECT_EQ(after.rangeFinders[1].intrinsics.cxPx, before.rangeFinders[1].intrinsics.cxPx);
  EXPECT_DOUBLE_EQ(after.rangeFinders[2].intrinsics.kappa, 1e-4);
  EXPECT_DOUBLE_EQ(after.rangeFinders[3].intrinsics.p2, 2e-5);
  EXPECT_EQ(after.rangeFinders[3].cameraFromWorld.translationMm, Eigen::Vector3d(0, 0, -0.5));
  EXPECT_EQ(after.rangeFinders[3].cameraFromWorld.rotation, before.rangeFinders[3].cameraFromWorld.rotation);
}

TEST(RigUncertainty, ATurnIsAboutTheCamerasOwnAxes) {
  RangeFinderCalibration finder;
  finder.cameraFromWorld.rotation = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).matrix();
  finder.cameraFromWorld.translationMm = {10, -20, 400};
  const Eigen::Matrix3d before = finder.cameraFromWorld.rotation;
  CameraChange change = CameraChange::Zero();
  change[static_cast<int>(CameraParameter::TurnZ)] = 0.01;
  apply(change, finder);
  const Eigen::Matrix3d turn = finder.cameraFromWorld.rotation * before.transpose();
  EXPECT_TRUE(turn.isApprox(Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitZ()).matrix(), 1e-14));
  EXPECT_EQ(finder.cameraFromWorld.translationMm, Eigen::Vector3d(10, -20, 400));
}

TEST(RigUncertainty, TheSourceOfARigHasItsCovariance) {
  for (const int rank : {1, 7, 60}) {
    RigCalibration rig;
    rig.covariance = covarianceOfRank(rank, static_cast<std::uint64_t>(rank));
    const ErrorSource source = errorSource(rig);
    EXPECT_EQ(source.effects.cols(), rank);
    const Eigen::MatrixXd again = source.effects * source.effects.transpose();
    const Eigen::VectorXd sd = rig.covariance.diagonal().cwiseSqrt();
    for (int i = 0; i < kRigParameters; ++i)
      for (int j = 0; j < kRigParameters; ++j)
        EXPECT_NEAR(again(i, j), rig.covariance(i, j), 1e-11 * sd[i] * sd[j]) << i << ' ' << j;
  }
}

TEST(RigUncertainty, AnExactRigHasNoEffects) {
  const ErrorSource source = errorSource(RigCalibration{});
  EXPECT_EQ(source.effects.rows(), kRigParameters);
  EXPECT_EQ(source.effects.cols(), 0);
}

TEST(RigUncertainty, EveryParameterHasItsOwnName) {
  for (int a = 0; a < kCameraParameters; ++a)
    for (int b = 0; b < a; ++b) {
      EXPECT_NE(name(static_cast<CameraParameter>(a)), name(static_cast<CameraParameter>(b)));
      EXPECT_NE(longName(static_cast<CameraParameter>(a)), longName(static_cast<CameraParameter>(b)));
    }
}

}  // namespace
}  // namespace vignole
