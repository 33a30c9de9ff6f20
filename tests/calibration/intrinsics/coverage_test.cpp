#include "calibration/intrinsics/coverage.h"

#include <gtest/gtest.h>

namespace vignole {
namespace {

TEST(Coverage, CountsPointsAndTheirErrorsByCell) {
  const std::vector<CoveragePoint> points = {
      {{0, 0}, {0.3, 0.4}}, {{50, 50}, {-0.3, 0.4}}, {{1399.4, 1023.4}, {1, 0}}, {{-0.4, -0.4}, {0, 0}}};
  const Coverage c = coverageOf(points, 1400, 1024);
  EXPECT_EQ(c.columns, 12);
  EXPECT_EQ(c.rows, 9);
  ASSERT_EQ(c.cells.size(), 108U);
  EXPECT_EQ(c.cells.front().points, 3);
  EXPECT_NEAR(c.cells.front().meanErrorPx.y(), 0.8 / 3, 1e-12);
  EXPECT_NEAR(c.cells.front().meanErrorPx.x(), 0, 1e-12);
  EXPECT_NEAR(c.cells.front().rmsPx, std::sqrt(0.5 / 3), 1e-12);
  EXPECT_EQ(c.cells.back().points, 1);
  EXPECT_NEAR(c.share(), 2.0 / 108, 1e-12);
  EXPECT_EQ(coverageOf({}, 1400, 1024).share(), 0);
  EXPECT_EQ(Coverage{}.share(), 0);
}

}  // namespace
}  // namespace vignole
