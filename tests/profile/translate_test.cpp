#include "engine/profile/translate.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace vignole {
namespace {

/// An affine map: mirrored, sheared, 0.2 and 0.3 mm/px.
struct AffineMap {
  PlanePoint operator()(double column, double row) const {
    return {10 + 0.2 * column + 0.05 * row, 5 - 0.3 * row, 0.2, 0.05, 0, -0.3};
  }
};

/// The map of a real camera: perspective, so that its derivatives change from point to point.
struct PerspectiveMap {
  PlanePoint operator()(double column, double row) const {
    const double w = 1 + 1e-4 * column - 2e-4 * row, x = 0.25 * column + 0.02 * row, y = 0.3 * row - 0.03 * column;
    return {x / w,
            y / w,
            (0.25 * w - x * 1e-4) / (w * w),
            (0.02 * w + x * 2e-4) / (w * w),
            (-0.03 * w - y * 1e-4) / (w * w),
            (0.3 * w + y * 2e-4) / (w * w)};
  }
};

StripeResult line(double angleRad, int points, float sigmaPx = 0.1F) {
  StripeResult stripe;
  const double c = std::cos(angleRad), s = std::sin(angleRad);
  for (int i = 0; i < points; ++i) {
    StripePoint p;
    p.x = static_cast<float>(500 + 2.0 * i * c);
    p.y = static_cast<float>(400 + 2.0 * i * s);
    p.nx = static_cast<float>(-s);
    p.ny = static_cast<float>(c);
    p.sigmaPx = sigmaPx;
    p.strength = 40;
    stripe.points.push_back(p);
  }
  stripe.lines.push_back({0, static_cast<std::uint32_t>(points), Rejection::None});
  stripe.backgroundDn = 12;
  return stripe;
}

TEST(Translate, PointsGoThroughTheMapAndKeepWhatTheyCarry) {
  StripeResult stripe = line(0.3, 5);
  stripe.points[2].flags = kSaturated;
  stripe.correlatedPoints = 4;
  stripe.overloaded = true;
  PartialContour contour;
  translateThrough(AffineMap{}, 2, 77, stripe, contour);
  ASSERT_EQ(contour.points.size(), 5U);
  const ProfilePoint& p = contour.points[2];
  EXPECT_DOUBLE_EQ(p.x,
                   10 + 0.2 * static_cast<double>(stripe.points[2].x) + 0.05 * static_cast<double>(stripe.points[2].y));
  EXPECT_DOUBLE_EQ(p.y, 5 - 0.3 * static_cast<double>(stripe.points[2].y));
  EXPECT_EQ(p.flags, kSaturated);
  EXPECT_EQ(p.camera, 2);
  EXPECT_EQ(contour.trigger, 77U);
  EXPECT_EQ(contour.lineEnds, std::vector<std::uint32_t>{5});
  EXPECT_EQ(contour.correlatedPoints, 4);
  EXPECT_TRUE(contour.overloaded) << "noted even where points were found";
  EXPECT_EQ(contour.missing, "");
}

TEST(Translate, TheNormalIsPerpendicularToTheMappedLine) {
  for (const double angle : {0.0, 0.4, 1.2, 2.5}) {
    const StripeResult stripe = line(angle, 3);
    PartialContour contour;
    translateThrough(PerspectiveMap{}, 0, 0, stripe, contour);
    const Eigen::Vector2d along(contour.points[2].x - contour.points[0].x, contour.points[2].y - contour.points[0].y);
    const Eigen::Vector2d normal(static_cast<double>(contour.points[1].nx), static_cast<double>(contour.points[1].ny));
    EXPECT_NEAR(normal.norm(), 1, 1e-6);
    EXPECT_NEAR(normal.dot(along.normalized()), 0, 1e-5);  // float normals
  }
}

TEST(Translate, SigmaAgreesWithMonteCarloAlongTheWorldNormal) {
  const PerspectiveMap map;
  std::mt19937 random(3);
  std::normal_distribution<double> noise;
  for (const double angle : {0.1, 0.9, 2.0}) {
    const StripeResult stripe = line(angle, 1, 0.2F);
    PartialContour contour;
    translateThrough(map, 0, 0, stripe, contour);
    const ProfilePoint& p = contour.points[0];
    const StripePoint& s = stripe.points[0];
    double sum2 = 0;
    constexpr int kDraws = 20000;
    for (int i = 0; i < kDraws; ++i) {
      // Across the line by its uncertainty; along it by much more, which must not matter.
      const double across = 0.2 * noise(random), along = 0.2 * noise(random);
      const PlanePoint q =
          map(static_cast<double>(s.x) + across * static_cast<double>(s.nx) - along * static_cast<double>(s.ny),
              static_cast<double>(s.y) + across * static_cast<double>(s.ny) + along * static_cast<double>(s.nx));
      const double d = (q.x - p.x) * static_cast<double>(p.nx) + (q.y - p.y) * static_cast<double>(p.ny);
      sum2 += d * d;
    }
    const double measured = std::sqrt(sum2 / kDraws);
    EXPECT_NEAR(static_cast<double>(p.sigmaMm) / measured, 1, 0.03) << angle;  // 1 / sqrt(2 n) is 0.5 %
  }
}

TEST(Translate, RejectedLinesAreLeftOutAndLineEndsStayRight) {
  StripeResult stripe = line(0, 6);
  stripe.lines = {{0, 2, Rejection::None}, {2, 3, Rejection::Weaker}, {5, 1, Rejection::None}};
  PartialContour contour;
  contour.points.resize(40);
  contour.lineEnds = {40};
  contour.missing = "old";
  translateThrough(AffineMap{}, 1, 5, stripe, contour);
  ASSERT_EQ(contour.points.size(), 3U);
  EXPECT_EQ(contour.lineEnds, (std::vector<std::uint32_t>{2, 3}));
  EXPECT_EQ(contour.missing, "");
}

TEST(Translate, PointsBeyondTheHorizonAreLeftOut) {
  const auto map = [](double column, double) {
    PlanePoint p{1, 2, 0.2, 0, 0, 0.2};
    if (column > 501) p.x = std::numeric_limits<double>::quiet_NaN();
    return p;
  };
  PartialContour contour;
  translateThrough(map, 1, 5, line(0, 6), contour);
  EXPECT_EQ(contour.points.size(), 1U);
}

TEST(Translate, NothingSaysWhy) {
  PartialContour contour;
  StripeResult stripe;
  stripe.backgroundDn = 12;
  translateThrough(AffineMap{}, 0, 0, stripe, contour);
  EXPECT_EQ(contour.missing, "no stripe");
  stripe.backgroundDn = 0;
  translateThrough(AffineMap{}, 0, 0, stripe, contour);
  EXPECT_EQ(contour.missing, "no stripe (black?)");
  stripe.backgroundDn = 255;
  translateThrough(AffineMap{}, 0, 0, stripe, contour);
  EXPECT_EQ(contour.missing, "no stripe (saturated?)");
  stripe.overloaded = true;
  translateThrough(AffineMap{}, 0, 0, stripe, contour);
  EXPECT_EQ(contour.missing, "overloaded");
  stripe = line(0, 4);
  stripe.lines[0].rejection = Rejection::Weaker;
  translateThrough(AffineMap{}, 0, 0, stripe, contour);
  EXPECT_EQ(contour.missing, "only rejected lines");
}

TEST(Translate, TheRealMapLandsInTheLightPlane) {
  // A camera that looks down -z at the plane z = 0 from 1 m: f 16 mm, 7.4 um, so 0.4625 mm/px.
  RangeFinderCalibration calibration;
  calibration.cameraFromWorld.rotation = Eigen::Vector3d(1, -1, -1).asDiagonal();
  calibration.cameraFromWorld.translationMm = {0, 0, 1000};
  const Translator translator(3, calibration);
  StripeResult stripe = line(0, 1, 0.1F);
  stripe.points[0].x = static_cast<float>(calibration.intrinsics.cxPx + 100);
  stripe.points[0].y = static_cast<float>(calibration.intrinsics.cyPx + 50);
  PartialContour contour;
  translator.translate(9, stripe, contour);
  ASSERT_EQ(contour.points.size(), 1U);
  EXPECT_NEAR(contour.points[0].x, 46.25, 1e-9);
  EXPECT_NEAR(contour.points[0].y, -23.125, 1e-9);
  EXPECT_NEAR(static_cast<double>(contour.points[0].sigmaMm), 0.04625, 1e-6);
  EXPECT_EQ(contour.camera, 3);
}

TEST(Translate, TheRidgeIsFoundBehindThePoint) {
  StripeResult stripe = line(0.4, 5);
  const StripeResult ridge = stripe;
  for (StripePoint& p : stripe.points) {
    p.shiftPx = 0.25F;
    p.ridgeSigmaPx = 2 * p.sigmaPx;
    p.x += p.shiftPx * p.nx;
    p.y += p.shiftPx * p.ny;
  }
  PartialContour moved, straight;
  translateThrough(AffineMap{}, 1, 5, stripe, moved);
  translateThrough(AffineMap{}, 1, 5, ridge, straight);
  ASSERT_EQ(moved.points.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    const ProfilePoint &p = moved.points[i], &q = straight.points[i];
    // Along the contour it may lie elsewhere; across it, where the ridge was.
    EXPECT_NEAR((p.x - p.shiftMm * p.nx - q.x) * q.nx + (p.y - p.shiftMm * p.ny - q.y) * q.ny, 0, 1e-5);
    EXPECT_NEAR(p.ridgeSigmaMm, 2 * p.sigmaMm, 1e-6);
    EXPECT_GT(std::abs(p.shiftMm), 0.01);
  }
}

}  // namespace
}  // namespace vignole
