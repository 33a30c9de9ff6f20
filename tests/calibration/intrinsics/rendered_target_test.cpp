// Pictures of the virtual rig through finding and adjustment.

#include <gtest/gtest.h>

#include "calibration/intrinsics/intrinsics_calibration.h"
#include "calibration/intrinsics/reprojection.h"
#include "calibration/parallel_for.h"
#include "engine/simulator/virtual_target.h"

namespace vignole {
namespace {

std::vector<TargetView> renderedViews(const VirtualTargetSettings& settings, int count) {
  const auto target = VirtualTarget::create(settings);
  EXPECT_TRUE(target.has_value()) << target.error().message();
  const Intrinsics& in = settings.camera.intrinsics;
  const std::vector<Extrinsics> poses = usualViews(settings.target, in, count, settings.seed);
  std::vector<TargetView> views(poses.size());
  parallelFor(poses.size(), [&](std::size_t v) {
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(in.widthPx) * static_cast<std::size_t>(in.heightPx));
    (*target)->render(poses[v], static_cast<int>(v), false, {pixels.data(), in.widthPx, in.heightPx, in.widthPx});
    views[v] = findTarget({pixels.data(), in.widthPx, in.heightPx, in.widthPx}, settings.target);
    views[v].file = "view " + std::to_string(v + 1);
  });
  return views;
}

/// (error / u)^2 over f, principal point and what distortion was estimated; 99.9 % of chi^2 lies below the limit.
void expectTruth(const IntrinsicsCalibration& c, const Intrinsics& truth) {
  double sum = 0;
  int count = 0;
  const IntrinsicVector off = toVector(c.camera.intrinsics) - toVector(truth);
  for (const CameraParameter p : freeParameters(c.variant)) {
    const auto i = static_cast<int>(p);
    sum += off[i] * off[i] / c.camera.covariance(i, i);
    ++count;
  }
  EXPECT_LT(sum / count, 6) << "of " << count;
}

/// The paper's Table III has a mean of 0.141 to 0.169 px with a plate of this tolerance.
TEST(RenderedTarget, APlateWithinFiftyMicrometresIsSeenThrough) {
  VirtualTargetSettings settings;
  settings.target = *parseTarget("circles:13x9:12:6");
  settings.camera.intrinsics.kappa = -4e-4;
  settings.camera.intrinsics.focalMm = 16.2;
  settings.targetErrorMm = 0.05;
  settings.seed = 12;
  const auto c = calibrateIntrinsics(renderedViews(settings, 10), settings.target);
  ASSERT_TRUE(c.has_value());
  EXPECT_TRUE(c->accepted());
  EXPECT_LT(c->camera.meanPx, 0.1);
  EXPECT_EQ(c->variant.model, DistortionModel::Division);
  EXPECT_NEAR(c->targetErrorMm, 0.0289, 0.006);
  expectTruth(*c, settings.camera.intrinsics);
}

TEST(RenderedTarget, ATiltedLensIsNoticedOnAChessboard) {
  VirtualTargetSettings settings;
  settings.target = *parseTarget("chessboard:11x8:13");
  Intrinsics& in = settings.camera.intrinsics;
  in.model = DistortionModel::Polynomial;
  in.k1 = 3e-4;
  in.p1 = 0.008 / 16;
  settings.seed = 13;
  const auto c = calibrateIntrinsics(renderedViews(settings, 10), settings.target);
  ASSERT_TRUE(c.has_value());
  EXPECT_TRUE(c->accepted());
  EXPECT_TRUE(c->variant.tangential) << name(c->variant);
  EXPECT_LT(c->camera.meanPx, 0.1);
  ASSERT_TRUE(c->division && c->polynomial);
  EXPECT_GT(c->division->rmsPx, 3 * c->polynomial->rmsPx);
  expectTruth(*c, in);
}

}  // namespace
}  // namespace vignole
