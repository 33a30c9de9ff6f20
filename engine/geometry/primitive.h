#pragma once
// Segments and arcs: what a rail section is made of. Plane coordinates in mm.
// Orientation: an outline runs counter-clockwise, so its outside lies to the RIGHT of the direction of travel.

#include <span>
#include <variant>
#include <vector>

#include "engine/geometry/transform2.h"

namespace vignole {

struct Segment {
  Point2 start{0, 0};
  Point2 end{0, 0};
};

/// Part of a circle from `startAngleRad`, turning by `sweepRad` (> 0 counter-clockwise). |sweep| < 2 pi, radius > 0.
struct Arc {
  Point2 centre{0, 0};
  double radiusMm = 1;
  double startAngleRad = 0;
  double sweepRad = 0;
};

using Primitive = std::variant<Segment, Arc>;

/// Foot of the perpendicular from a point, or the nearest end where the perpendicular misses the primitive.
struct Nearest {
  Point2 point{0, 0};
  Point2 normal{0, 0};     ///< unit, to the right of travel (outwards on an outline), of the primitive at `point`
  double distanceMm = 0;   ///< Euclidean distance, signed: > 0 on the right of travel (outside)
  double arcLengthMm = 0;  ///< position of `point` along the primitive, 0 .. length
  bool atEnd = false;      ///< true where the perpendicular misses and an end is nearest
};

[[nodiscard]] Nearest nearest(const Primitive& primitive, const Point2& point);
[[nodiscard]] double length(const Primitive& primitive);
[[nodiscard]] Point2 startPoint(const Primitive& primitive);
[[nodiscard]] Point2 endPoint(const Primitive& primitive);
/// Point, unit tangent and unit right-hand normal at arc length s; s outside 0..length extends the carrier.
[[nodiscard]] Point2 pointAt(const Primitive& primitive, double s);
[[nodiscard]] Point2 tangentAt(const Primitive& primitive, double s);
[[nodiscard]] Point2 normalAt(const Primitive& primitive, double s);
/// Signed curvature, 1/mm: > 0 where the outline turns left (convex on a counter-clockwise outline), 0 for a segment.
[[nodiscard]] double curvature(const Primitive& primitive);
[[nodiscard]] Primitive transformed(const Transform2& targetFromSource, const Primitive& primitive);
/// Points where the infinite line through `point` along `direction` meets the primitive, or, if `carrier`, its whole
/// line or circle. Sorted by their parameter along `direction`. Empty where they miss.
[[nodiscard]] std::vector<Point2> intersectLine(const Primitive& primitive, const Point2& point,
                                                const Point2& direction, bool carrier = false);
/// Points common to two primitives (ends included, tolerance 1e-9 mm).
[[nodiscard]] std::vector<Point2> intersect(const Primitive& a, const Primitive& b);

/// Points along it from its start to its end, both included, about `stepMm` apart; of a segment the two ends alone.
[[nodiscard]] std::vector<Point2> polyline(const Primitive& primitive, double stepMm);

}  // namespace vignole
