// Gap linking by d and alpha, and what the flags say.

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

#include "engine/stripe/stripe_extractor.h"
#include "tests/synthetic/stripe_scene.h"

namespace vignole {
namespace {

struct Stroke {
  double x0, y0, x1, y1;
  double contrast = 120, sigma = 3;
};

constexpr int kWidth = 400, kHeight = 240;

std::vector<std::uint8_t> drawn(const std::vector<Stroke>& strokes, double noiseDn = 3) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> noise(0, noiseDn);
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      double light = 20 + noise(random);
      for (const Stroke& s : strokes) {
        const double length = std::hypot(s.x1 - s.x0, s.y1 - s.y0), tx = (s.x1 - s.x0) / length,
                     ty = (s.y1 - s.y0) / length;
        const double along = (x - s.x0) * tx + (y - s.y0) * ty, across = (x - s.x0) * ty - (y - s.y0) * tx;
        if (along >= 0 && along <= length) light += s.contrast * std::exp(-across * across / (2 * s.sigma * s.sigma));
      }
      pixels.push_back(static_cast<std::uint8_t>(std::clamp(std::lround(light), 0L, 255L)));
    }
  return pixels;
}

StripeResult extracted(const std::vector<Stroke>& strokes, const StripeSettings& settings = {}, double noiseDn = 3) {
  const auto pixels = drawn(strokes, noiseDn);
  StripeExtractor extractor(settings);
  StripeResult result;
  extractor.extract({pixels.data(), kWidth, kHeight, kWidth}, result);
  return result;
}

/// Two pieces of 120 px, `gap` px apart, the second turned by `angleDeg` and moved aside by `aside` px.
std::vector<Stroke> pieces(double gap, double angleDeg, double aside = 0) {
  const double a = angleDeg * std::numbers::pi / 180, x = 160 + gap, y = 100 + aside;
  return {{40, 100, 160, 100}, {x, y, x + 120 * std::cos(a), y + 120 * std::sin(a)}};
}

TEST(GapLinking, AcrossAGapUpToD) {
  EXPECT_EQ(extracted(pieces(40, 0)).lines.size(), 1U);
  StripeSettings settings;
  settings.gapDistance = 30;
  EXPECT_EQ(extracted(pieces(40, 0), settings).lines.size(), 2U);
  settings.gapDistance = 0;
  EXPECT_EQ(extracted(pieces(40, 0), settings).lines.size(), 2U);
}

TEST(GapLinking, UpToTheAngleAlpha) {
  EXPECT_EQ(extracted(pieces(30, 11)).lines.size(), 1U);
  EXPECT_EQ(extracted(pieces(30, 19)).lines.size(), 2U);
  StripeSettings settings;
  settings.gapAngle = 25;
  EXPECT_EQ(extracted(pieces(30, 19), settings).lines.size(), 1U);
  settings.gapAngle = 5;
  EXPECT_EQ(extracted(pieces(30, 11), settings).lines.size(), 2U);
}

TEST(GapLinking, APieceThatRunsBesideIsNotTheSameLine) { EXPECT_EQ(extracted(pieces(30, 0, 20)).lines.size(), 2U); }

TEST(GapLinking, LinkedPiecesAreOneOrderedLine) {
  const StripeResult result = extracted({{300, 100, 370, 100}, {40, 100, 130, 100}, {160, 100, 270, 100}});
  ASSERT_EQ(result.lines.size(), 1U);
  for (std::size_t i = 1; i < result.points.size(); ++i) EXPECT_GT(result.points[i].x, result.points[i - 1].x);
}

TEST(GapLinking, TheClosestPartnerIsTaken) {
  // The right end may go on straight after 20 px or, further, a little turned: one of them stays alone.
  const StripeResult result = extracted({{40, 100, 160, 100}, {180, 100, 300, 100}, {205, 110, 300, 120}});
  ASSERT_EQ(result.lines.size(), 2U);
  float most = 0;
  for (std::uint32_t i = 0; i < result.lines[0].count; ++i) most = std::max(most, result.points[i].x);
  EXPECT_NEAR(result.points[0].x, 40, 2);
  EXPECT_NEAR(most, 300, 2);
}

TEST(Flags, GapEdgesAndEndsWithinThreeSigma) {
  const StripeResult result = extracted(pieces(40, 0));
  ASSERT_EQ(result.lines.size(), 1U);
  for (const StripePoint& p : result.points) {
    const double toGap = std::min(std::abs(p.x - 160), std::abs(p.x - 200));
    const double toEnd = std::min(std::abs(p.x - 40), std::abs(p.x - 320));
    if (toGap < 7) {
      EXPECT_TRUE((p.flags & kGapEdge) != 0) << p.x;
    }
    if (toGap > 11) {
      EXPECT_FALSE((p.flags & kGapEdge) != 0) << p.x;
    }
    if (toEnd < 7) {
      EXPECT_TRUE((p.flags & kLineEnd) != 0) << p.x;
    }
    if (toEnd > 11) {
      EXPECT_FALSE((p.flags & kLineEnd) != 0) << p.x;
    }
  }
}

TEST(Flags, ClippedStretchIsSaturatedAndStillCentred) {
  const StripeResult result =
      extracted({{40, 100.3, 150, 100.3}, {150, 100.3, 250, 100.3, 380}, {250, 100.3, 360, 100.3}});
  ASSERT_EQ(result.lines.size(), 1U);
  int saturated = 0;
  for (const StripePoint& p : result.points) {
    const bool flagged = (p.flags & kSaturated) != 0;
    if (p.x > 152 && p.x < 248) {
      EXPECT_TRUE(flagged) << p.x;
    }
    if (p.x < 148 || p.x > 252) {
      EXPECT_FALSE(flagged) << p.x;
    }
    if (p.x > 55 && p.x < 345) {
      EXPECT_NEAR(p.y, 100.3, 0.12) << p.x;
    }
    saturated += flagged ? 1 : 0;
  }
  EXPECT_NEAR(result.saturatedShare, static_cast<float>(saturated) / static_cast<float>(result.points.size()), 1e-6);
}

TEST(Flags, AGhostBesideTheLineIsRejectedAndListedLast) {
  const StripeResult result = extracted({{40, 100, 360, 100, 180}, {120, 125, 280, 126, 35, 4}});
  ASSERT_EQ(result.lines.size(), 2U);
  EXPECT_FALSE(result.lines[0].rejected());
  EXPECT_EQ(result.lines[1].rejection, Rejection::Weaker);
  EXPECT_GT(result.lines[1].first, 0U);
  for (std::uint32_t i = 0; i < result.points.size(); ++i)
    EXPECT_EQ((result.points[i].flags & kRejected) != 0, i >= result.lines[1].first);
}

TEST(Flags, OfTwoLinesTheBroaderShorterAndWeakerIsTheGhost) {
  const StripeResult result = extracted({{40, 100, 360, 100, 180, 3}, {120, 128, 260, 128, 90, 5}});
  ASSERT_EQ(result.lines.size(), 2U);
  EXPECT_EQ(result.lines[0].rejection, Rejection::None);
  EXPECT_EQ(result.lines[1].rejection, Rejection::Broader);
  EXPECT_NE(std::string(reasonOf(Rejection::Broader)), "");
}

TEST(Flags, ASpotManyTimesAsBroadIsNoLine) {
  const StripeResult result = extracted({{40, 60, 360, 60, 100, 2}, {200, 200, 240, 200, 120, 8}});
  ASSERT_GE(result.lines.size(), 2U);
  EXPECT_EQ(result.lines[0].rejection, Rejection::None);
  for (std::size_t l = 1; l < result.lines.size(); ++l) EXPECT_EQ(result.lines[l].rejection, Rejection::Spot);
}

TEST(Flags, ALineWhereTheLightPlaneCannotBeSeenIsRejected) {
  const auto pixels = drawn({{40, 60, 360, 60, 150}, {40, 200, 360, 200, 150}});
  StripeOptics optics;
  optics.field = {{0, 0}, {400, 0}, {400, 120}, {0, 120}};
  StripeResult result;
  StripeExtractor({}, optics).extract({pixels.data(), kWidth, kHeight, kWidth}, result);
  ASSERT_EQ(result.lines.size(), 2U);
  EXPECT_EQ(result.lines[0].rejection, Rejection::None);
  EXPECT_EQ(result.lines[1].rejection, Rejection::OutOfField);
  EXPECT_NEAR(result.points[result.lines[1].first].y, 200, 0.5);
}

TEST(Flags, LightManyTimesWeakerThanItsLineMayBeANeighbours) {
  const StripeResult result = extracted({{40, 100, 220, 100, 200}, {221, 100, 360, 100, 14}});
  ASSERT_EQ(result.lines.size(), 1U);
  for (const StripePoint& p : result.points) {
    if (p.x < 200) {
      EXPECT_EQ(p.flags & kCrosstalk, 0) << p.x;
    } else if (p.x > 240 && p.x < 350) {
      EXPECT_NE(p.flags & kCrosstalk, 0) << p.x;
    }
  }
}

TEST(Flags, DoubtfulCompetitorsAreKept) {
  const auto kept = [](const Stroke& other) {
    const StripeResult result = extracted({{40, 100, 360, 100, 180}, other});
    ASSERT_EQ(result.lines.size(), 2U);
    EXPECT_FALSE(result.lines[0].rejected() || result.lines[1].rejected());
  };
  kept({120, 125, 280, 126, 90});  // half as strong
  kept({120, 170, 280, 171, 35});  // far away
  kept({120, 125, 200, 205, 35});  // not parallel
}

}  // namespace
}  // namespace vignole
