// Hand-made straight lines whose centre is known to a thousandth of a pixel.

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "engine/stripe/stripe_extractor.h"
#include "tests/synthetic/stripe_scene.h"

namespace vignole {
namespace {

using synthetic::StraightLine;
using synthetic::straightLinePicture;

StripeResult extracted(const StraightLine& line, const StripeSettings& settings = {}, std::uint64_t seed = 1) {
  const auto pixels = straightLinePicture(line, seed);
  StripeExtractor extractor(settings);
  StripeResult result;
  extractor.extract({pixels.data(), line.width, line.height, line.width}, result);
  return result;
}

double errorOf(const StripePoint& p, const StraightLine& line) {
  return (p.x - line.x0) * std::cos(line.angleRad) + (p.y - line.y0) * std::sin(line.angleRad);
}

class EveryAngle : public testing::TestWithParam<int> {};

TEST_P(EveryAngle, CentreNormalStrengthAndWidth) {
  StraightLine line;
  line.angleRad = GetParam() * std::numbers::pi / 180;
  for (const double offset : {0.0, 0.17, 0.5, 0.83}) {
    line.x0 = 100 + offset * std::cos(line.angleRad);
    line.y0 = 80 + offset * std::sin(line.angleRad);
    const StripeResult result = extracted(line);
    ASSERT_EQ(result.lines.size(), 1U) << "offset " << offset;
    double squares = 0;
    int body = 0;
    float way = 0;
    for (std::size_t i = 0; i < result.points.size(); ++i) {
      const StripePoint& p = result.points[i];
      if (i > 0) way += std::hypot(p.x - result.points[i - 1].x, p.y - result.points[i - 1].y);
      EXPECT_NEAR(std::hypot(p.nx, p.ny), 1, 1e-5);
      // At the border the picture's edge is repeated.
      if (p.x < 20 || p.y < 20 || p.x > 179 || p.y > 139) continue;
      ++body;
      squares += errorOf(p, line) * errorOf(p, line);
      EXPECT_NEAR(std::abs(p.nx * std::cos(line.angleRad) + p.ny * std::sin(line.angleRad)), 1, 1e-4);
      EXPECT_NEAR(p.strength, 150, 3);
      EXPECT_NEAR(p.widthPx, 3, 0.06);
    }
    EXPECT_GT(body, 100);
    // Rounding to whole DN repeats along lines at 0, 45 and 90 degrees: 0.29 / 150 * 1.84 = 0.0036 px (1 sd).
    EXPECT_LT(std::sqrt(squares / body), 0.006) << "offset " << offset;
    // In order: the way along the points is hardly longer than from the first to the last.
    const StripePoint &a = result.points.front(), &b = result.points.back();
    EXPECT_LT(way, 1.01F * std::hypot(b.x - a.x, b.y - a.y) + 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Stripe, EveryAngle, testing::Values(0, 7, 22, 30, 45, 60, 85, 90, 101, 135, 160, 179));

TEST(StraightLine, NormalsAllPointToTheSameSide) {
  StraightLine line;
  line.angleRad = 2.0;
  line.noiseDn = 4;
  const StripeResult result = extracted(line);
  ASSERT_EQ(result.lines.size(), 1U);
  for (std::size_t i = 1; i < result.points.size(); ++i)
    EXPECT_GT(result.points[i].nx * result.points[0].nx + result.points[i].ny * result.points[0].ny, 0.9F);
}

TEST(StraightLine, WidthAndStrengthOfOtherStripes) {
  for (const double s : {1.5, 2.0, 4.0, 5.0}) {
    StraightLine line;
    line.sigma = s;
    line.angleRad = 1.2;
    const StripeResult result = extracted(line);
    ASSERT_EQ(result.lines.size(), 1U) << s;
    const StripePoint& p = result.points[result.points.size() / 2];
    EXPECT_NEAR(p.widthPx, s, 0.08) << s;
    EXPECT_NEAR(p.strength, 150, 6) << s;
  }
}

TEST(StraightLine, OddSizesUpToTheBorder) {
  for (const auto& [width, height] : {std::pair{32, 32}, {33, 47}, {61, 39}, {127, 65}, {203, 101}}) {
    StraightLine line;
    line.width = width;
    line.height = height;
    line.x0 = width / 2.0;
    line.y0 = height / 2.0 + 0.3;
    const StripeResult result = extracted(line);
    ASSERT_EQ(result.lines.size(), 1U) << width << " x " << height;
    EXPECT_GE(result.lines[0].count, static_cast<std::uint32_t>(width - 2));
    for (const StripePoint& p : result.points) EXPECT_NEAR(p.y, line.y0, 0.02) << width << " x " << height;
  }
}

TEST(StraightLine, AlongTheBorder) {
  StraightLine line;
  line.y0 = 5.25;  // 1.75 sigma from the upper border: part of the light is missing
  const StripeResult result = extracted(line);
  ASSERT_EQ(result.lines.size(), 1U);
  for (const StripePoint& p : result.points) EXPECT_NEAR(p.y, line.y0, 0.6);
}

TEST(StraightLine, AViewIntoALargerPictureIsWorkedOnAlone) {
  StraightLine line;
  line.angleRad = 1.3;
  const auto pixels = straightLinePicture(line, 1);
  StripeExtractor extractor({});
  StripeResult result;
  const int left = 37, top = 21, width = 101, height = 99;
  extractor.extract({pixels.data() + top * line.width + left, width, height, line.width}, result);
  ASSERT_EQ(result.lines.size(), 1U);
  for (StripePoint p : result.points) {
    EXPECT_LT(p.x, static_cast<float>(width));
    p.x += left;
    p.y += top;
    if ((p.flags & kLineEnd) == 0) {
      EXPECT_NEAR(errorOf(p, line), 0, 0.02);
    }
  }
}

TEST(StraightLine, EndsWhereTheLightEnds) {
  StraightLine line;
  line.angleRad = 1.9;
  line.noiseDn = 4;
  line.firstPx = -60;
  line.lastPx = 45.5;
  const StripeResult result = extracted(line);
  ASSERT_EQ(result.lines.size(), 1U);
  const auto along = [&](const StripePoint& p) {
    return (p.x - line.x0) * std::sin(line.angleRad) - (p.y - line.y0) * std::cos(line.angleRad);
  };
  double least = 1e9, most = -1e9;
  for (const StripePoint& p : result.points) {
    least = std::min(least, along(p));
    most = std::max(most, along(p));
    EXPECT_LT(std::abs(errorOf(p, line)), 0.35) << "no fork at the end";
  }
  EXPECT_NEAR(least, -60, 1.5);
  EXPECT_NEAR(most, 45.5, 1.5);
}

}  // namespace
}  // namespace vignole
