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
  DotPlate            ///< symmetric grid within a black frame with one corner filled in (HALCON-style, DotPlateFrame)
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

/// An upright rectangle in the target's frame.
struct TargetRectangle {
  Point2 min{0, 0}, max{0, 0};
};

/// The whole board with its white margin: a chessboard's is one square beyond its outer squares, that of circles one
/// pitch beyond the centres of the outer ones, that of a dot plate an eighth of a pitch beyond its frame.
[[nodiscard]] TargetRectangle board(const PlanarTarget& target);

/// The black frame of a dot plate. Inside it, the corner beside point 0 is black too, up to the line that meets the
/// outer edges `cornerMm` from their corner. As on HALCON's plates with rectangularly arranged marks: the outer edge
/// one pitch beyond the centres of the outer dots, a quarter of a pitch wide, the corner one pitch.
struct DotPlateFrame {
  TargetRectangle outer;
  double widthMm = 0, cornerMm = 0;
};
[[nodiscard]] DotPlateFrame frame(const PlanarTarget& target);

/// "chessboard:COLSxROWS:MM", "circles:COLSxROWS:PITCH[:DIAMETER]", "acircles:COLSxROWS:PITCH[:DIAMETER]",
/// "dotplate:COLSxROWS:PITCH[:DIAMETER]". Without a diameter it is half the pitch.
[[nodiscard]] Expected<PlanarTarget> parseTarget(std::string_view words);
[[nodiscard]] std::string words(const PlanarTarget& target);

}  // namespace vignole
