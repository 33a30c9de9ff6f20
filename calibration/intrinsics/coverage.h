#pragma once
// Where in the picture a calibration has seen points, and what is left there.

#include <vector>

#include "engine/geometry/transform2.h"

namespace vignole {

struct CoverageCell {
  int points = 0;
  double rmsPx = 0;
  Point2 meanErrorPx{0, 0};  ///< predicted less found: what all points there have in common
};

/// A grid over the picture, row by row.
struct Coverage {
  int columns = 0, rows = 0;
  std::vector<CoverageCell> cells;
  /// Share of the cells that have points.
  [[nodiscard]] double share() const;
};

struct CoveragePoint {
  Point2 px{0, 0}, errorPx{0, 0};
};
/// Cells are about square, twelve along the longer side.
[[nodiscard]] Coverage coverageOf(const std::vector<CoveragePoint>& points, int widthPx, int heightPx);

}  // namespace vignole
