// A pin as a cylinder: its cut with the light plane, and what it hides.

#include "engine/simulator/pin_body.h"

#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace vignole::simulator {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

TEST(PinBody, AnUprightPinIsCutInACircleRunThroughCounterClockwise) {
  const PinBody pin(3, {10, 20, -15}, {0, 0, 1}, 5, 0, 23);
  EXPECT_EQ(pin.number(), 3);
  EXPECT_LT((pin.centre() - Point2(10, 20)).norm(), 1e-12);
  double turned = 0;
  for (int i = 0; i < 100; ++i) {
    const Point2 a = pin.cut(2 * std::numbers::pi * i / 100) - pin.centre();
    const Point2 b = pin.cut(2 * std::numbers::pi * (i + 1) / 100) - pin.centre();
    EXPECT_NEAR(a.norm(), 5, 1e-12);
    turned += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    const Point3 normal = pin.normal(2 * std::numbers::pi * i / 100);
    EXPECT_LT((normal.head<2>() - a / 5).norm(), 1e-12);
  }
  EXPECT_NEAR(turned, 2 * std::numbers::pi, 1e-9);
}

TEST(PinBody, ATiltedPinIsCutInItsEllipse) {
  for (const double tilt : {0.5, 2.0, 10.0}) {
    const double t = tilt * kDegree;
    const Point3 axis(std::sin(t), 0, std::cos(t));
    const PinBody pin(1, Point3(-30, 40, 0) - 15 * axis, axis, 6, 0, 23);
    EXPECT_LT((pin.centre() - Point2(-30, 40)).norm(), 1e-9);
    double longest = 0, shortest = 1e9;
    for (int i = 0; i < 720; ++i) {
      const Point2 at = pin.cut(i * kDegree / 2);
      // On the cylinder: the distance from its axis is its radius.
      const Point3 from = Point3(at.x(), at.y(), 0) - Point3(-30, 40, 0);
      EXPECT_NEAR((from - from.dot(axis) * axis).norm(), 6, 1e-9);
      longest = std::max(longest, (at - pin.centre()).norm());
      shortest = std::min(shortest, (at - pin.centre()).norm());
    }
    EXPECT_NEAR(longest, 6 / std::cos(t), 1e-4) << "optics design, section 1.4";
    EXPECT_NEAR(shortest, 6, 1e-4);
  }
}

TEST(PinBody, HidesWhatLiesBehindItAndBelowItsTop) {
  // From 15 mm behind the light plane to 8 mm beyond it.
  const PinBody pin(1, {0, 0, -15}, {0, 0, 1}, 5, 0, 23);
  // Within the light plane: whole.
  EXPECT_TRUE(pin.hides({20, 0, 0}, {-480, 0, 0}));
  EXPECT_TRUE(pin.hides({20, 4.9, 0}, {-480, 4.9, 0}));
  EXPECT_FALSE(pin.hides({20, 5.1, 0}, {-480, 5.1, 0}));
  EXPECT_FALSE(pin.hides({-20, 0, 0}, {-480, 0, 0})) << "it stands before the pin";
  EXPECT_FALSE(pin.hides({20, 0, 0}, {10, 0, 0})) << "the eye stands before the pin";
  // A camera at 40 degrees sees past it from 8 / tan 40 = 9.5 mm behind its face.
  const auto eye = [](double x) { return Point3(x - 300, 0, 300 * std::tan(40 * kDegree)); };
  const double reach = 8 / std::tan(40 * kDegree);
  EXPECT_TRUE(pin.hides({5 + 0.95 * reach, 0, 0}, eye(5 + 0.95 * reach)));
  EXPECT_FALSE(pin.hides({5 + 1.05 * reach, 0, 0}, eye(5 + 1.05 * reach)));
  EXPECT_FALSE(pin.hides({20, 0, -20}, {-480, 0, -20})) << "it runs behind the pin's foot";
}

}  // namespace
}  // namespace vignole::simulator
