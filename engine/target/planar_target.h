#pragma once
// Flat calibration targets as geometry. Frame of a target: x to the right along its columns, y down along its rows, z
// away from who looks at it (so that a camera that faces it has the same handedness), mm; point 0 is the origin.

#include <string>
#include <string_view>
#include <vector>

#include "engine/geometry/expected.h"
#include "engine/geometry/transform2.h"

namespace vignole {

enum class TargetPattern {
  Chessboard,         ///< inner corners
  Circles,            ///< symmetric grid
  AsymmetricCircles,  ///< every second row shifted by half the column distance, which is twice the pitch (OpenCV)
  DotPlate            ///< symmetric grid within a black frame whose one corner is cut off (HALCON-style)
};

struct PlanarTarget {
  TargetPattern pattern = TargetPattern::Chessboard;
  int columns = 0, rows = 0;  ///< inner corners, or circles
  double pitchMm = 0;         ///< side of a square; distance of circles (asymmetric: of rows)
  double diameterMm = 0;      ///< of circles; 0 for a chessboard
  bool lightDots = false;     ///< light on dark
  double uMm = 0;             ///< standard uncertainty of each coordinate of a point

  /// Row by row, columns * rows points.
  [[nodiscard]] std::vector<Point2> points() const;
};

/// "chessboard:COLSxROWS:MM", "circles:COLSxROWS:PITCH[:DIAMETER]", "acircles:COLSxROWS:PITCH[:DIAMETER]",
/// "dotplate:COLSxROWS:PITCH[:DIAMETER]". Without a diameter it is half the pitch.
[[nodiscard]] Expected<PlanarTarget> parseTarget(std::string_view words);
[[nodiscard]] std::string words(const PlanarTarget& target);

}  // namespace vignole
