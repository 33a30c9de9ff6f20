#pragma once
// A flat target as it was printed: which places are white, black, or off the board.

#include <cstdint>
#include <vector>

#include "engine/target/planar_target.h"

namespace vignole::simulator {

/// What lies within a small area around a place: shares that sum up to 1 with the dark surroundings of the board.
struct PrintedShares {
  double white = 0, black = 0;
};

/// A small parallelogram: its two sides, mm. Borders that cross it are taken as straight.
struct Footprint {
  Point2 a{0, 0}, b{0, 0};
};

/// Immutable. Frame of the target, mm.
class PrintedTarget {
 public:
  /// Each coordinate of a point errs uniformly within +- errorMm.
  PrintedTarget(const PlanarTarget& target, double errorMm, bool mirrored, std::uint64_t seed);

  /// The points as printed, in the order of PlanarTarget::points().
  [[nodiscard]] const std::vector<Point2>& points() const { return points_; }
  /// No border between white, black and surroundings is nearer than this (a lower bound; may be negative).
  [[nodiscard]] double clearanceMm(const Point2& at) const;
  [[nodiscard]] PrintedShares shares(const Point2& at, const Footprint& area) const;

 private:
  [[nodiscard]] double blackOfChessboard(const Point2& at, const Footprint& area) const;
  [[nodiscard]] double blackOfCircles(const Point2& at, const Footprint& area) const;
  [[nodiscard]] double blackOfFrame(const Point2& at, const Footprint& area) const;
  [[nodiscard]] int nearestCircle(const Point2& at) const;
  [[nodiscard]] Point2 shiftAt(const Point2& at) const;
  [[nodiscard]] Point2 asDrawn(const Point2& at) const { return mirrored_ ? Point2(width_ - at.x(), at.y()) : at; }

  PlanarTarget target_;
  double errorMm_;
  bool mirrored_;
  double width_;
  TargetRectangle board_;
  DotPlateFrame frame_;
  TargetRectangle inFrame_;
  std::vector<Point2> points_;  ///< as printed, mirrored back if need be
  std::vector<Point2> drawn_;   ///< as printed, before mirroring
  std::vector<Point2> shifts_;
};

}  // namespace vignole::simulator
