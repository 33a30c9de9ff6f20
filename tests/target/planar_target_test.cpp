// Targets by their words, and where their points lie.

#include "engine/target/planar_target.h"

#include <gtest/gtest.h>

namespace vignole {
namespace {

TEST(PlanarTarget, WordsAreReadAndWrittenBack) {
  for (const char* text :
       {"chessboard:9x6:12.5", "circles:13x9:10:5", "acircles:4x11:20:16", "dotplate:7x7:3.5:1.75"}) {
    const auto target = parseTarget(text);
    ASSERT_TRUE(target.has_value()) << target.error().message();
    EXPECT_EQ(words(*target), text);
  }
  const auto board = parseTarget("chessboard:9x6:12.5");
  EXPECT_EQ(board->pattern, TargetPattern::Chessboard);
  EXPECT_EQ(board->columns, 9);
  EXPECT_EQ(board->rows, 6);
  EXPECT_EQ(board->pitchMm, 12.5);
  EXPECT_EQ(board->diameterMm, 0);
  EXPECT_EQ(parseTarget("circles:13x9:10")->diameterMm, 5) << "half the pitch where none is said";
}

TEST(PlanarTarget, PointsRunRowByRow) {
  const auto grid = parseTarget("circles:3x2:10")->points();
  ASSERT_EQ(grid.size(), 6U);
  EXPECT_EQ(grid[0], Point2(0, 0));
  EXPECT_EQ(grid[2], Point2(20, 0));
  EXPECT_EQ(grid[3], Point2(0, 10));
  // OpenCV's asymmetric grid: column distance twice the pitch, every second row shifted by one pitch.
  const auto shifted = parseTarget("acircles:4x3:20")->points();
  EXPECT_EQ(shifted[1], Point2(40, 0));
  EXPECT_EQ(shifted[4], Point2(20, 20));
  EXPECT_EQ(shifted[8], Point2(0, 40));
}

TEST(PlanarTarget, BadWordsAreRefusedInOneLine) {
  for (const char* bad :
       {"", "board:9x6:10", "chessboard", "chessboard:9x6", "chessboard:9:10", "chessboard:9x6:0", "chessboard:9x6:-3",
        "chessboard:1x6:10", "chessboard:9x6x3:10", "chessboard:9x6:10:5", "circles:9x6:10:11", "circles:9x6:10:0",
        "circles:9x6:ten", "circles:9x6:10:5:3", "circles:900x6:10", "circles:9.5x6:10", "circles:9x6:nan"}) {
    const auto target = parseTarget(bad);
    ASSERT_FALSE(target.has_value()) << bad;
    EXPECT_EQ(target.error().message().find('\n'), std::string::npos);
    EXPECT_NE(target.error().message().find("chessboard:COLSxROWS:MM"), std::string::npos);
  }
}

}  // namespace
}  // namespace vignole
