// The laser's plane from rendered pictures of a target, against the rig's.

#include "calibration/light_plane/light_plane_calibration.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "calibration/detection/target_finder.h"
#include "calibration/light_plane/target_stripe.h"
#include "engine/simulator/rig_geometry.h"
#include "engine/simulator/virtual_target.h"
#include "engine/target/planar_target.h"

namespace vignole {
namespace {

struct TruePlane {
  Eigen::Vector3d normal;
  double distanceMm;
};

/// In the camera's frame, away from the camera.
TruePlane planeOf(const RangeFinderCalibration& camera) {
  TruePlane plane{camera.cameraFromWorld.rotation * camera.lightPlane.normal, 0};
  plane.distanceMm = camera.lightPlane.distanceMm + plane.normal.dot(camera.cameraFromWorld.translationMm);
  if (plane.distanceMm < 0) plane = {-plane.normal, -plane.distanceMm};
  return plane;
}

class RenderedLight {
 public:
  explicit RenderedLight(std::uint64_t seed, bool laserOn = true, int views = 8)
      : camera_(simulator::drawRig(seed).calibration.rangeFinders[seed % kCameraCount]),
        target_(*parseTarget("dotplate:13x9:10")) {
    VirtualTargetSettings settings;
    settings.target = target_;
    settings.camera = camera_;
    settings.seed = seed;
    const auto shown = VirtualTarget::create(settings);
    const Intrinsics& in = camera_.intrinsics;
    const auto poses = usualViews(target_, in, views, seed, &camera_);
    std::vector<std::uint8_t> plate(static_cast<std::size_t>(in.widthPx) * static_cast<std::size_t>(in.heightPx));
    std::vector<std::uint8_t> laser(plate.size());
    for (std::size_t v = 0; v < poses.size(); ++v) {
      (*shown)->render(poses[v], static_cast<int>(v), false, {plate.data(), in.widthPx, in.heightPx, in.widthPx});
      (*shown)->render(poses[v], static_cast<int>(v), laserOn, {laser.data(), in.widthPx, in.heightPx, in.widthPx});
      const TargetView view = findTarget({plate.data(), in.widthPx, in.heightPx, in.widthPx}, target_);
      stripes_.push_back(findTargetStripe({laser.data(), in.widthPx, in.heightPx, in.widthPx}, view, target_, in));
    }
  }
  [[nodiscard]] LightPlaneCalibration calibrate(std::size_t views = 100) const {
    CalibratedIntrinsics stated;
    stated.intrinsics = camera_.intrinsics;
    stated.covariance.setZero();
    return *calibrateLightPlane(std::span(stripes_).first(std::min(views, stripes_.size())), target_, stated);
  }
  [[nodiscard]] TruePlane truth() const { return planeOf(camera_); }

 private:
  RangeFinderCalibration camera_;
  PlanarTarget target_;
  std::vector<TargetStripe> stripes_;
};

/// (error / u)^2 in the directions that are uncertain: three.
double squaredErrors(const LightPlaneCalibration& found, const TruePlane& truth) {
  Eigen::Vector4d error;
  error << found.normal - truth.normal, found.distanceMm - truth.distanceMm;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(found.covariance);
  double sum = 0;
  for (int i = 1; i < 4; ++i)  // the least is the normal's length
    sum += std::pow(solver.eigenvectors().col(i).dot(error), 2) / solver.eigenvalues()[i];
  return sum;
}

TEST(LightPlaneOnRenderings, ErrsAsItSays) {
  constexpr int kRigs = 5;
  double sum = 0;
  for (std::uint64_t seed = 301; seed < 301 + kRigs; ++seed) {
    const RenderedLight rendered(seed);
    const LightPlaneCalibration found = rendered.calibrate();
    ASSERT_TRUE(found.accepted()) << found.refusals.front();
    const TruePlane truth = rendered.truth();
    EXPECT_LT((found.normal - truth.normal).norm(), 3e-4);
    EXPECT_NEAR(found.distanceMm, truth.distanceMm, 0.06);
    EXPECT_LT(found.uNormalMrad, 0.15) << "or the stated uncertainty says nothing";
    sum += squaredErrors(found, truth);
  }
  // 99.9 % interval of chi^2 with 15 degrees of freedom.
  EXPECT_GT(sum, 3.1);
  EXPECT_LT(sum, 39.7);
}

TEST(LightPlaneOnRenderings, WithTheLaserOffIsRefusedWithTheReason) {
  const LightPlaneCalibration found = RenderedLight(311, false, 3).calibrate();
  EXPECT_FALSE(found.accepted());
  for (const LightPlaneView& view : found.views) {
    EXPECT_FALSE(view.used);
    EXPECT_NE(view.reason.find("line"), std::string::npos) << view.reason;
  }
}

TEST(LightPlaneOnRenderings, OneViewIsNotEnoughAndSaysWhy) {
  const LightPlaneCalibration found = RenderedLight(312, true, 1).calibrate();
  ASSERT_FALSE(found.accepted());
  EXPECT_NE(found.refusals.front().find("pose"), std::string::npos) << found.refusals.front();
  for (const LightPlaneView& view : found.views) EXPECT_TRUE(view.used || !view.reason.empty());
}

}  // namespace
}  // namespace vignole
