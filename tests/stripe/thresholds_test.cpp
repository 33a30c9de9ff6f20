// t_l and t_h in DN of line contrast, hysteresis, noise, lengths, settings that are refused.

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "engine/stripe/stripe_extractor.h"
#include "engine/stripe/uncertainty.h"
#include "tests/synthetic/stripe_scene.h"

namespace vignole {
namespace {

using synthetic::StraightLine;
using synthetic::straightLinePicture;

StripeResult extracted(const std::vector<std::uint8_t>& pixels, int width, int height,
                       const StripeSettings& settings = {}) {
  StripeExtractor extractor(settings);
  StripeResult result;
  extractor.extract({pixels.data(), width, height, width}, result);
  return result;
}

StripeResult extracted(const StraightLine& line, const StripeSettings& settings = {}) {
  return extracted(straightLinePicture(line, 3), line.width, line.height, settings);
}

/// A horizontal line at y = 60 whose contrast is contrastAt(x).
template <class ContrastAt>
std::vector<std::uint8_t> lineOfContrast(int width, const ContrastAt& contrastAt) {
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < width; ++x)
      pixels.push_back(
          static_cast<std::uint8_t>(std::lround(20 + contrastAt(x) * std::exp(-(y - 60.0) * (y - 60.0) / 18))));
  return pixels;
}

TEST(Thresholds, AreContrastsOfALineAsWideAsTheFilter) {
  StraightLine line;
  line.angleRad = 1.5;
  StripeSettings settings;
  settings.low = 20;
  settings.high = 30;
  line.contrast = 28.5;
  EXPECT_TRUE(extracted(line, settings).lines.empty());
  line.contrast = 31.5;
  EXPECT_EQ(extracted(line, settings).lines.size(), 1U);
}

TEST(Thresholds, AWiderLineNeedsMoreContrastByItsSecondDerivative) {
  StripeSettings settings;
  settings.low = 20;
  settings.high = 30;
  StraightLine line;
  line.sigma = 5;
  const double needed = 30 * ridgePerContrast(3, 3) / ridgePerContrast(5, 3);
  line.contrast = 0.94 * needed;
  EXPECT_TRUE(extracted(line, settings).lines.empty());
  line.contrast = 1.06 * needed;
  EXPECT_EQ(extracted(line, settings).lines.size(), 1U);
}

TEST(Thresholds, WeakPointsConnectedToStrongOnesAreAccepted) {
  StripeSettings settings;
  settings.low = 15;
  settings.high = 40;
  // 60 DN on the left, fading to nothing at x = 360: accepted down to 15 DN, at x = 300
  const auto pixels = lineOfContrast(400, [](int x) { return x < 120 ? 60.0 : std::max(0.0, 60 - (x - 120) * 0.25); });
  const StripeResult result = extracted(pixels, 400, 120, settings);
  ASSERT_EQ(result.lines.size(), 1U);
  float reach = 0;
  for (const StripePoint& p : result.points) reach = std::max(reach, p.x);
  EXPECT_NEAR(reach, 300, 6);
}

TEST(Thresholds, WeakPointsAloneAreRejected) {
  StripeSettings settings;
  settings.low = 15;
  settings.high = 40;
  EXPECT_TRUE(extracted(lineOfContrast(400, [](int) { return 30.0; }), 400, 120, settings).lines.empty());
}

TEST(Thresholds, ALineShorterThanMinLengthIsDropped) {
  StraightLine line;
  line.firstPx = -12;
  line.lastPx = 12;
  StripeSettings settings;
  settings.minLength = 60;
  EXPECT_TRUE(extracted(line, settings).lines.empty());
  settings.minLength = 15;
  EXPECT_EQ(extracted(line, settings).lines.size(), 1U);
}

TEST(Thresholds, NoiseAloneMakesNoLine) {
  for (const double noise : {1.0, 4.0, 12.0, 30.0}) {
    StraightLine line;
    line.width = 700;
    line.height = 500;
    line.contrast = 0;
    line.backgroundDn = 100;
    line.noiseDn = noise;
    const StripeResult result = extracted(line);
    EXPECT_TRUE(result.lines.empty()) << noise;
    EXPECT_FALSE(result.overloaded) << noise;
    EXPECT_NEAR(result.noiseDn, noise, 0.05 * noise + 0.05);
    EXPECT_NEAR(result.backgroundDn, 100, 1);
  }
}

TEST(Thresholds, FlatFramesHaveNoLine) {
  for (const int dn : {0, 1, 128, 255}) {
    const std::vector<std::uint8_t> pixels(640 * 480, static_cast<std::uint8_t>(dn));
    const StripeResult result = extracted(pixels, 640, 480);
    EXPECT_TRUE(result.points.empty()) << dn;
    EXPECT_FALSE(result.overloaded) << dn;
    EXPECT_EQ(result.backgroundDn, static_cast<float>(dn));
    EXPECT_EQ(result.saturatedShare, 0);
  }
}

TEST(Thresholds, ABrighteningBackgroundIsNoLine) {
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < 480; ++y)
    for (int x = 0; x < 640; ++x) pixels.push_back(static_cast<std::uint8_t>(20 + x / 4 + y / 8));
  EXPECT_TRUE(extracted(pixels, 640, 480).lines.empty());
}

TEST(Thresholds, NoPictureNoStripe) {
  StripeExtractor extractor({});
  StripeResult result;
  result.points.resize(3);
  extractor.extract({}, result);
  EXPECT_TRUE(result.points.empty());
  EXPECT_TRUE(result.lines.empty());
}

TEST(Overload, TextureEverywhereIsCappedAndTold) {
  std::mt19937_64 random(5);
  std::vector<std::uint8_t> pixels(1400 * 1024);
  // Blobs of 9 px, bright and dark: every block stands out somewhere.
  for (int y = 0; y < 1024; ++y)
    for (int x = 0; x < 1400; ++x)
      pixels[static_cast<std::size_t>(y * 1400 + x)] = static_cast<std::uint8_t>(
          128 + 60 * std::sin(x * 0.35) * std::sin(y * 0.31) + static_cast<double>(random() % 8));
  StripeSettings settings;
  settings.maxBlocks = 2000;
  EXPECT_TRUE(extracted(pixels, 1400, 1024, settings).overloaded);
  settings.maxBlocks = 30000;
  EXPECT_FALSE(extracted(pixels, 1400, 1024, settings).overloaded);
}

TEST(Overload, TheStripeBrighterThanTheTextureSurvives) {
  StraightLine line;
  line.width = 1400;
  line.height = 1024;
  line.x0 = 700;
  line.y0 = 512;
  line.angleRad = 1.4;
  line.backgroundDn = 60;
  auto pixels = straightLinePicture(line, 1);
  for (int y = 0; y < line.height; ++y)
    for (int x = 0; x < line.width; ++x)
      pixels[static_cast<std::size_t>(y * 1400 + x)] = static_cast<std::uint8_t>(std::min(
          255.0, pixels[static_cast<std::size_t>(y * 1400 + x)] + 20 * std::sin(x * 0.35) * std::sin(y * 0.31)));
  StripeSettings settings;
  settings.maxBlocks = 1500;
  const StripeResult result = extracted(pixels, 1400, 1024, settings);
  EXPECT_TRUE(result.overloaded);
  int onLine = 0;
  for (const StripePoint& p : result.points)
    if (std::abs((p.x - 700) * std::cos(1.4) + (p.y - 512) * std::sin(1.4)) < 1) ++onLine;
  EXPECT_GT(onLine, 1250);
}

TEST(Settings, OutOfRangeIsRefusedByName) {
  const auto refused = [](auto change, const char* field) {
    StripeSettings settings;
    change(settings);
    const auto result = checked(settings);
    ASSERT_FALSE(result.has_value()) << field;
    EXPECT_EQ(result.error().where, std::string("stripe.") + field);
  };
  EXPECT_TRUE(checked({}).has_value());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused([](StripeSettings& s) { s.sigma = 0.9; }, "sigma");
  refused([](StripeSettings& s) { s.sigma = 8.1; }, "sigma");
  refused([nan](StripeSettings& s) { s.sigma = nan; }, "sigma");
  refused([](StripeSettings& s) { s.low = 0; }, "low");
  refused([nan](StripeSettings& s) { s.low = nan; }, "low");
  refused([](StripeSettings& s) { s.high = s.low - 1; }, "high");
  refused([](StripeSettings& s) { s.gapDistance = -1; }, "gapDistance");
  refused([](StripeSettings& s) { s.gapAngle = 91; }, "gapAngle");
  refused([](StripeSettings& s) { s.minLength = 2; }, "minLength");
  refused([](StripeSettings& s) { s.maxBlocks = 0; }, "maxBlocks");
}

}  // namespace
}  // namespace vignole
