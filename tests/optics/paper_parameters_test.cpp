#include "engine/optics/paper_parameters.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace vignole {

namespace {

Eigen::Matrix3d composed(double alpha, double beta, double gamma) {
  return (Eigen::AngleAxisd(alpha, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(beta, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(gamma, Eigen::Vector3d::UnitZ()))
      .toRotationMatrix();
}

}  // namespace

TEST(PaperParameters, EulerAnglesComposeToTheRotation) {
  for (const double alpha : {-2.9, -1.0, 0.2, 3.0})
    for (const double beta : {-1.5, 0.0, 0.7})
      for (const double gamma : {-3.1, -0.4, 2.2}) {
        const Eigen::Vector3d angles = eulerAngles(composed(alpha, beta, gamma));
        EXPECT_LT((angles - Eigen::Vector3d(alpha, beta, gamma)).norm(), 1e-12);
      }
}

TEST(PaperParameters, SixteenByNameWithTheirUncertainty) {
  RangeFinderCalibration finder;
  finder.intrinsics.model = DistortionModel::Polynomial;
  finder.intrinsics.k1 = 2e-4;
  finder.cameraFromWorld.rotation = composed(0.3, -0.2, 1.1);
  finder.cameraFromWorld.translationMm = {1, 2, 3};
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(kCameraParameters, kCameraParameters);
  covariance(0, 0) = 4e-6;
  const int turn = static_cast<int>(CameraParameter::TurnX);
  // A turn about the camera's x is alpha's own.
  covariance(turn, turn) = 1e-6;
  const auto all = paperParameters(finder, covariance);
  ASSERT_EQ(all.size(), 16U);
  EXPECT_EQ(all[0].name, "f");
  EXPECT_NEAR(all[0].u, 2e-3, 1e-12);
  EXPECT_EQ(all[5].name, "k_1");
  EXPECT_EQ(all[10].name, "alpha");
  EXPECT_NEAR(all[10].value, 0.3 * 57.29577951308232, 1e-9);
  EXPECT_NEAR(all[10].u, 1e-3 * 57.29577951308232, 1e-9);
  EXPECT_NEAR(all[11].u, 0, 1e-9);
  EXPECT_NEAR(all[12].u, 0, 1e-9);
  EXPECT_EQ(all[15].name, "t_3");
  EXPECT_EQ(all[15].value, 3);
  finder.intrinsics.model = DistortionModel::Division;
  EXPECT_EQ(paperParameters(finder, {}).size(), 12U);
}

}  // namespace vignole
