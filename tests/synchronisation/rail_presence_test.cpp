#include "engine/synchronisation/rail_presence.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace vignole {
namespace {

constexpr int kWidth = 1400, kHeight = 1024;

struct Picture {
  std::vector<std::uint8_t> pixels = std::vector<std::uint8_t>(kWidth * kHeight);
  /// Grey with noise of a simple generator, so that it is the same everywhere.
  Picture(double background, double noise) {
    std::uint32_t state = 12345;
    for (std::uint8_t& p : pixels) {
      double sum = 0;
      for (int i = 0; i < 4; ++i) {
        state = state * 1664525u + 1013904223u;
        sum += static_cast<double>(state >> 8) / static_cast<double>(1u << 24) - 0.5;
      }
      p = static_cast<std::uint8_t>(std::clamp(background + noise * sum * std::sqrt(3.0), 0.0, 255.0));
    }
  }
  void line(double x0, double y0, double x1, double y1, double width, int brightness) {
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const double dx = x1 - x0, dy = y1 - y0, length = std::hypot(dx, dy);
        const double along = ((x - x0) * dx + (y - y0) * dy) / length,
                     across = ((x - x0) * dy - (y - y0) * dx) / length;
        if (along < 0 || along > length || std::abs(across) > width / 2) continue;
        std::uint8_t& p = pixels[static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)];
        p = static_cast<std::uint8_t>(std::min(255, p + brightness));
      }
  }
  [[nodiscard]] ImageView view() const { return {pixels.data(), kWidth, kHeight, kWidth}; }
};

TEST(RailPresence, BackgroundAndItsNoiseAreNoRail) {
  for (const double background : {0.0, 12.0, 60.0}) EXPECT_FALSE(railInView(Picture(background, 5).view(), {}));
}

TEST(RailPresence, AFewHotPixelsAreNoRail) {
  Picture picture(12, 3);
  for (std::size_t i = 0; i < 20; ++i) picture.pixels[i * 70001 % picture.pixels.size()] = 255;
  EXPECT_FALSE(railInView(picture.view(), {}));
}

TEST(RailPresence, AFaintLineInAnyDirectionIsARail) {
  for (int degrees = 0; degrees < 180; degrees += 15) {
    Picture picture(12, 3);
    const double c = std::cos(degrees * M_PI / 180), s = std::sin(degrees * M_PI / 180);
    // Level lines fall between two searched rows at worst, so what is seen of a rail is never one level line: two.
    picture.line(700 - 150 * c, 500 - 150 * s, 700 + 150 * c, 500 + 150 * s, 5, 60);
    picture.line(700 + 150 * c, 500 + 150 * s, 700 + 150 * c - 100 * s, 500 + 150 * s + 100 * c, 5, 60);
    EXPECT_TRUE(railInView(picture.view(), {})) << degrees << " degrees";
  }
}

TEST(RailPresence, AnEmptyPictureIsNoRail) { EXPECT_FALSE(railInView({}, {})); }

}  // namespace
}  // namespace vignole
