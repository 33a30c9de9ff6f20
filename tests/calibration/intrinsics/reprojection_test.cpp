#include "calibration/intrinsics/reprojection.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/calibration/synthetic_target/synthetic_views.h"

namespace vignole {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

Intrinsics polynomialCamera() {
  Intrinsics in = usualCamera();
  in.pixelHeightMm = 0.00745;
  in.model = DistortionModel::Polynomial;
  in.k1 = 4e-4;
  in.k2 = -3e-7;
  in.k3 = -2e-9;
  in.p1 = 5e-5;
  in.p2 = -6e-5;
  return in;
}

Intrinsics divisionCamera() {
  Intrinsics in = usualCamera();
  in.kappa = -4e-4;
  return in;
}

Extrinsics tiltedPose() {
  Extrinsics pose;
  pose.rotation = Eigen::AngleAxisd(0.6, Eigen::Vector3d(1, -2, 0.3).normalized()).toRotationMatrix();
  pose.translationMm = {-30, 20, 400};
  return pose;
}

/// Central differences of the projection without derivatives.
template <typename Move>
Point2 slope(double step, const Move& at) {
  return (at(step) - at(-step)) / (2 * step);
}

class Derivatives : public testing::TestWithParam<std::tuple<bool, double>> {};

TEST_P(Derivatives, AgreeWithDifferences) {
  const auto [division, radius] = GetParam();
  const Intrinsics in = division ? divisionCamera() : polynomialCamera();
  const Extrinsics pose = tiltedPose();
  const Eigen::Vector3d point(80, 45, 1.5);
  Reprojection r;
  ASSERT_TRUE(reproject(in, pose, point, radius, r));
  EXPECT_LT((r.px - reprojected(in, pose, point, radius)).norm(), 1e-9);

  const IntrinsicVector values = toVector(in);
  IntrinsicVector steps;
  steps << 1e-4, 1e-8, 1e-3, 1e-3, 1e-8, 1e-8, 1e-10, 1e-11, 1e-8, 1e-8;
  for (int i = 0; i < kIntrinsicParameters; ++i) {
    const Point2 d = slope(steps[i], [&](double step) {
      IntrinsicVector changed = values;
      changed[i] += step;
      return reprojected(fromVector(changed, in), pose, point, radius);
    });
    EXPECT_LT((r.byIntrinsics.col(i) - d).norm(), 1e-6 * std::max(1.0, d.norm()))
        << name(static_cast<CameraParameter>(i));
  }
  for (int i = 0; i < 6; ++i) {
    const Point2 d = slope(i < 3 ? 1e-6 : 1e-3, [&](double step) {
      return reprojected(in, moved(pose, step * Vector6::Unit(i)), point, radius);
    });
    EXPECT_LT((r.byPose.col(i) - d).norm(), 1e-6 * std::max(1.0, d.norm())) << "pose " << i;
  }
  for (int i = 0; i < 3; ++i) {
    const Point2 d = slope(
        1e-3, [&](double step) { return reprojected(in, pose, point + step * Eigen::Vector3d::Unit(i), radius); });
    EXPECT_LT((r.byPoint.col(i) - d).norm(), 1e-6 * std::max(1.0, d.norm())) << "point " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(BothModels, Derivatives, testing::Combine(testing::Bool(), testing::Values(0.0, 8.0)));

TEST(Reprojection, SeesTheCentreOfTheEllipseOfACircle) {
  Intrinsics in = usualCamera();  // without distortion the shifted point is exact
  const Extrinsics pose = tiltedPose();
  const Eigen::Vector3d centre(70, 40, 0);
  const Point2 seen = imagedCircleCentre(in, pose, centre, 8);
  EXPECT_GT((seen - reprojected(in, pose, centre, 0)).norm(), 0.2) << "or the test proves nothing";
  EXPECT_LT((seen - reprojected(in, pose, centre, 8)).norm(), 1e-4);
}

TEST(Reprojection, SaysWhatTheCameraCannotSee) {
  Reprojection r;
  Extrinsics pose;
  pose.translationMm = {0, 0, -100};
  EXPECT_FALSE(reproject(usualCamera(), pose, {1, 2, 0}, 0, r));
  EXPECT_FALSE(reprojected(usualCamera(), pose, {1, 2, 0}, 0).allFinite());

  pose.translationMm = {0, 0, 100};
  Intrinsics strong = usualCamera();
  strong.kappa = 0.01;  // 4 kappa r^2 > 1 beyond 5 mm
  EXPECT_TRUE(reproject(strong, pose, {20, 0, 0}, 0, r));
  EXPECT_FALSE(reproject(strong, pose, {40, 0, 0}, 0, r));
  EXPECT_FALSE(reprojected(strong, pose, {40, 0, 0}, 0).allFinite());
}

}  // namespace
}  // namespace vignole
