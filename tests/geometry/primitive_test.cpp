#include "engine/geometry/primitive.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace vignole {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<Primitive> samples() {
  return {Segment{{-3, 1}, {4, 2.5}},        Segment{{2, 2}, {2, -5}},    Arc{{1, 2}, 3, 0.3, 1.1},
          Arc{{1, 2}, 3, 0.3, -1.1},         Arc{{-2, 0}, 1.5, 3.0, 5.5}, Arc{{-2, 0}, 1.5, -3.0, -6.1},
          Arc{{0, -128}, 300, 1.55, 0.06818}};
}

/// Nearest of very many points along the primitive.
double bruteForce(const Primitive& p, const Point2& query) {
  constexpr int kSteps = 20000;
  double best = 1e300;
  for (int i = 0; i <= kSteps; ++i) best = std::min(best, (pointAt(p, length(p) * i / kSteps) - query).norm());
  return best;
}

TEST(Primitive, NearestAgreesWithBruteForce) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-6, 6);
  for (const Primitive& p : samples())
    for (int i = 0; i < 40; ++i) {
      const Point2 query = startPoint(p) + Point2(coordinate(random), coordinate(random));
      const Nearest n = nearest(p, query);
      const double step = length(p) / 20000;
      EXPECT_NEAR(std::abs(n.distanceMm), bruteForce(p, query), step) << "query " << query.transpose();
      EXPECT_NEAR((n.point - query).norm(), std::abs(n.distanceMm), 1e-12);
      EXPECT_NEAR((pointAt(p, n.arcLengthMm) - n.point).norm(), 0, 1e-11);
      EXPECT_NEAR(n.normal.norm(), 1, 1e-12);
      EXPECT_GE(n.distanceMm * n.normal.dot(query - n.point), 0) << "the sign follows the normal";
      if (!n.atEnd) {
        EXPECT_NEAR(std::abs(n.normal.dot(query - n.point)), std::abs(n.distanceMm), 1e-11);
      }
    }
}

TEST(Primitive, RightOfTravelIsPositive) {
  const Primitive bottom = Segment{{-1, 0}, {1, 0}};  // counter-clockwise outline: below is outside
  EXPECT_DOUBLE_EQ(nearest(bottom, {0, -2}).distanceMm, 2);
  EXPECT_DOUBLE_EQ(nearest(bottom, {0, 2}).distanceMm, -2);
  const Primitive convex = Arc{{0, 0}, 2, 0, kPi};
  EXPECT_DOUBLE_EQ(nearest(convex, {0, 3}).distanceMm, 1);
  EXPECT_NEAR(nearest(convex, {0, 3}).normal.y(), 1, 1e-15);
  const Primitive concave = Arc{{0, 0}, 2, kPi, -kPi};
  EXPECT_DOUBLE_EQ(nearest(concave, {0, 3}).distanceMm, -1);
  EXPECT_NEAR(nearest(concave, {0, 3}).normal.y(), -1, 1e-15);
}

TEST(Primitive, EndsAreNearestBeyondThem) {
  const Primitive s = Segment{{0, 0}, {10, 0}};
  EXPECT_TRUE(nearest(s, {-3, -4}).atEnd);
  EXPECT_DOUBLE_EQ(nearest(s, {-3, -4}).distanceMm, 5);
  EXPECT_FALSE(nearest(s, {3, -4}).atEnd);
  const Primitive a = Arc{{0, 0}, 1, 0, kPi / 2};
  EXPECT_TRUE(nearest(a, {1, -1}).atEnd);
  EXPECT_NEAR(nearest(a, {1, -1}).arcLengthMm, 0, 1e-15);
  EXPECT_NEAR(nearest(a, {-1, 1}).arcLengthMm, kPi / 2, 1e-12);
  EXPECT_DOUBLE_EQ(std::abs(nearest(a, {0, 0}).distanceMm), 1) << "the centre is one radius away";
}

TEST(Primitive, TangentIsTheDerivativeAndNormalItsRight) {
  for (const Primitive& p : samples())
    for (const double s : {0.1, 0.5 * length(p), length(p) + 0.3, -0.2}) {
      const double h = 1e-6;
      const Point2 difference = (pointAt(p, s + h) - pointAt(p, s - h)) / (2 * h);
      EXPECT_NEAR((difference - tangentAt(p, s)).norm(), 0, 1e-7);
      EXPECT_NEAR(normalAt(p, s).x(), tangentAt(p, s).y(), 1e-14);
      EXPECT_NEAR(normalAt(p, s).y(), -tangentAt(p, s).x(), 1e-14);
      const Point2 bend = (tangentAt(p, s + h) - tangentAt(p, s - h)) / (2 * h);
      EXPECT_NEAR((bend + curvature(p) * normalAt(p, s)).norm(), 0, 1e-7) << "k > 0 turns left, away from the normal";
    }
}

TEST(Primitive, TransformMovesPointsAndKeepsLength) {
  const Transform2 t{3, -2, 0.7};
  for (const Primitive& p : samples()) {
    const Primitive moved = transformed(t, p);
    EXPECT_NEAR(length(moved), length(p), 1e-12);
    for (const double s : {0.0, 0.4, length(p)}) EXPECT_NEAR((pointAt(moved, s) - t * pointAt(p, s)).norm(), 0, 1e-11);
    const Primitive back = transformed(t.inverse(), moved);
    EXPECT_NEAR((endPoint(back) - endPoint(p)).norm(), 0, 1e-11);
  }
}

TEST(Primitive, LineMeetsArcTwiceInOrderOfItsDirection) {
  const Primitive circle = Arc{{0, 0}, 5, 0, 6.2831};
  const auto hits = intersectLine(circle, {-10, 3}, {2, 0});
  ASSERT_EQ(hits.size(), 2U);
  EXPECT_NEAR(hits[0].x(), -4, 1e-12);
  EXPECT_NEAR(hits[1].x(), 4, 1e-12);
  EXPECT_NEAR(intersectLine(circle, {-10, 3}, {-2, 0})[0].x(), 4, 1e-12);
  EXPECT_TRUE(intersectLine(circle, {0, 5.1}, {1, 0}).empty());
  EXPECT_EQ(intersectLine(circle, {0, 5}, {1, 0}).size(), 1U) << "a tangent touches once";
}

TEST(Primitive, LineMissesThePartButMeetsTheCarrier) {
  const Primitive quarter = Arc{{0, 0}, 5, 0, kPi / 2};
  EXPECT_EQ(intersectLine(quarter, {0, 3}, {1, 0}).size(), 1U);
  EXPECT_EQ(intersectLine(quarter, {0, 3}, {1, 0}, true).size(), 2U);
  const Primitive segment = Segment{{0, 0}, {1, 0}};
  EXPECT_TRUE(intersectLine(segment, {2, 1}, {0, 1}).empty());
  ASSERT_EQ(intersectLine(segment, {2, 1}, {0, 1}, true).size(), 1U);
  EXPECT_TRUE(intersectLine(segment, {0, 1}, {1, 0}, true).empty()) << "parallel";
}

TEST(Primitive, IntersectionsLieOnBoth) {
  const auto all = samples();
  int found = 0;
  for (const Primitive& a : all)
    for (const Primitive& b : all) {
      if (&a == &b) continue;
      for (const Point2& p : intersect(a, b)) {
        ++found;
        EXPECT_LT(std::abs(nearest(a, p).distanceMm), 1e-9);
        EXPECT_LT(std::abs(nearest(b, p).distanceMm), 1e-9);
      }
      EXPECT_EQ(intersect(a, b).size(), intersect(b, a).size());
    }
  EXPECT_GT(found, 4);
}

TEST(Primitive, KnownIntersections) {
  const Primitive s = Segment{{-5, 1}, {5, 1}};
  const Primitive upper = Arc{{0, 0}, 2, 0, kPi};
  EXPECT_EQ(intersect(s, upper).size(), 2U);
  EXPECT_EQ(intersect(Segment{{0, 0}, {0, 5}}, upper).size(), 1U);
  EXPECT_EQ(intersect(upper, Arc{{4, 0}, 2, kPi / 2, kPi}).size(), 1U) << "two circles that touch at (2, 0)";
  EXPECT_TRUE(intersect(upper, Arc{{0, 0}, 3, 0, kPi}).empty()) << "concentric";
  const auto joint = intersect(Segment{{0, 0}, {1, 0}}, Segment{{1, 0}, {2, 0}});
  ASSERT_EQ(joint.size(), 1U) << "collinear neighbours share their joint";
  EXPECT_NEAR((joint[0] - Point2(1, 0)).norm(), 0, 1e-12);
  EXPECT_EQ(intersect(Segment{{0, 0}, {2, 0}}, Segment{{1, 0}, {3, 0}}).size(), 2U) << "ends of an overlap";
}

}  // namespace
}  // namespace vignole
