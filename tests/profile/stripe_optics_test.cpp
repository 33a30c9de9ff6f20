#include "engine/profile/stripe_optics.h"

#include <gtest/gtest.h>

#include "engine/optics/plane_map.h"

namespace vignole {
namespace {

/// 400 mm before the light plane z = 0, looking at it from 45 degrees above.
RangeFinderCalibration finder() {
  RangeFinderCalibration f;
  const double c = std::sqrt(0.5);
  f.cameraFromWorld.rotation << 1, 0, 0, 0, -c, c, 0, -c, -c;
  f.cameraFromWorld.translationMm = {0, 0, 400};
  f.blurPx = 0.6;
  return f;
}

TEST(StripeOptics, TheFieldsCornersAreWhereTheCameraSeesThem) {
  const MeasuringField field{{-60, -40}, {60, 50}};
  const StripeOptics optics = stripeOptics(finder(), field);
  EXPECT_EQ(optics.blurPx, 0.6);
  ASSERT_EQ(optics.field.size(), 4U);
  const PlaneMap map(finder());
  const double xs[] = {-60, 60, 60, -60}, ys[] = {-40, -40, 50, 50};
  for (std::size_t k = 0; k < 4; ++k) {
    const PlanePoint p = map(static_cast<double>(optics.field[k].x), static_cast<double>(optics.field[k].y));
    EXPECT_NEAR(p.x, xs[k], 1e-3);
    EXPECT_NEAR(p.y, ys[k], 1e-3);
  }
}

TEST(StripeOptics, NoFieldWhereTheCameraCannotSeeAllOfIt) {
  EXPECT_TRUE(stripeOptics(finder(), {{-60, -40}, {60, 900}}).field.empty());  // reaches behind the camera
  RangeFinderCalibration edge = finder();
  edge.lightPlane.normal = {0, 1, 0};
  EXPECT_TRUE(stripeOptics(edge, {{-60, -40}, {60, 50}}).field.empty());
}

}  // namespace
}  // namespace vignole
