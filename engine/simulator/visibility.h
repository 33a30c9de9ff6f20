#pragma once
// Which parts of a closed outline a point outside sees. The rail is a prism, so what hides it from a camera or a laser
// is decided in the plane.

#include <span>
#include <vector>

#include "engine/geometry/transform2.h"

namespace vignole::simulator {

/// Part of a closed polyline in fractional vertex indices, 0 <= from < to <= number of vertices.
struct Interval {
  double from = 0, to = 0;
};

struct Viewpoint {
  Point2 position{0, 0};
  Point2 direction{1, 0};   ///< unit; everything seen lies before it
  double tanHalfFan = 1e9;  ///< what lies farther aside is not seen
};

/// Scratch of one thread.
struct VisibilityScratch {
  std::vector<double> aside, ahead;
  struct Run {
    std::size_t first, edges;
    double low, high;
    bool rising;
  };
  std::vector<Run> runs;
  std::vector<Interval> hidden;
};

/// Exact for the polyline: its front-facing runs are functions of the viewing direction, and two of them never cross.
/// `outline` counter-clockwise, not repeated at its end; `visible` sorted.
void visibleParts(std::span<const Point2> outline, const Viewpoint& viewpoint, VisibilityScratch& scratch,
                  std::vector<Interval>& visible);

}  // namespace vignole::simulator
