// The renderer's sums of light: what a sample adds is its Gaussian, wherever it lies and however long it is.

#include "engine/simulator/light_kernels.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace vignole::simulator {
namespace {

constexpr int kWidth = 100, kHeight = 80;

/// Standard deviations along and across, px, and the angle of the long one.
SplatKernel kernelOf(double along, double across, double angleRad) {
  const double c = std::cos(angleRad), s = std::sin(angleRad), l = along * along, q = across * across;
  const double xx = l * c * c + q * s * s, yy = l * s * s + q * c * c, xy = (l - q) * c * s, det = xx * yy - xy * xy;
  SplatKernel k;
  k.a = static_cast<float>(yy / det);
  k.b = static_cast<float>(-xy / det);
  k.c = static_cast<float>(xx / det);
  k.bend = std::exp(-k.c);
  k.scale = static_cast<float>(1 / (2 * std::numbers::pi * std::sqrt(det)));
  k.halfWidth = static_cast<float>(4 * std::sqrt(xx));
  k.halfHeight = static_cast<int>(std::ceil(4 * std::sqrt(yy)));
  return k;
}

double gaussian(const SplatKernel& k, double dx, double dy) {
  return k.scale * std::exp(-0.5 * (k.a * dx * dx + 2.0 * k.b * dx * dy + k.c * dy * dy));
}

TEST(Canvas, ASampleAddsItsGaussian) {
  Canvas canvas(kWidth, kHeight);
  for (const double across : {0.43, 0.8, 2.0})
    for (const double along : {1.75, 2.5})
      for (const double angle : {0.0, 0.3, std::numbers::pi / 4, 1.5, 2.5})
        for (const float x : {31.4F, 32.0F, 47.5F, 60.1F}) {
          const SplatKernel k = kernelOf(along, across, angle);
          const float y = 40.3F;
          canvas.add({{x, y, 1000, 0}}, {k});
          double worst = 0;
          for (int r = 0; r < kHeight; ++r)
            for (int c = 0; c < kWidth; ++c) {
              float& got = canvas.row(r)[c];
              const bool within = std::abs(static_cast<float>(c) - x) <= k.halfWidth &&
                                  std::abs(static_cast<float>(r) - y) <= k.halfHeight - 0.5;
              if (within || !std::isfinite(got))
                worst = std::max(
                    worst, std::abs(got - 1000 * gaussian(k, c - static_cast<double>(x), r - static_cast<double>(y))));
              got = 0;
            }
          EXPECT_LT(worst, 1e-4 * 1000 * k.scale) << along << " " << across << " " << angle << " " << x;
        }
}

TEST(Canvas, NotesTheBlocksThatItTouches) {
  Canvas canvas(kWidth, kHeight);
  canvas.add({{47.5F, 40, 1000, 0}, {-5, 20, 1000, 0}, {kWidth + 200.0F, 20, 1000, 0}}, {kernelOf(2, 1, 0.5)});
  for (int r = 0; r < kHeight; ++r)
    for (int c = 0; c < kWidth; ++c) {
      const auto block = static_cast<std::size_t>(r / kBlock * canvas.blocksX + c / kBlock);
      EXPECT_TRUE(canvas.row(r)[c] == 0 || canvas.touched[block] == 1) << c << " " << r;
    }
  EXPECT_NE(canvas.row(20)[-5], 0);
  canvas.clearMargin();
  for (int r = -kMargin; r < 0; ++r)
    for (int c = -kMargin; c < kWidth; ++c) EXPECT_EQ(canvas.row(r)[c], 0);
  EXPECT_EQ(canvas.row(20)[-5], 0);
}

}  // namespace
}  // namespace vignole::simulator
