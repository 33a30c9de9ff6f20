#pragma once
// Direct least-squares fits of ellipses to points, as the paper fits its pins. They shrink on short arcs: a centre of
// 130 degrees of arc lies about 1 px too close to the arc (optics design, finding 1); the adjustment of arcs does
// without them.

#include <span>
#include <string_view>

#include "engine/geometry/expected.h"
#include "engine/geometry/transform2.h"

namespace vignole {

enum class EllipseFitVariant {
  Fitzgibbon,    ///< 4ac - b^2 = 1 in the points' own units (Fitzgibbon, Pilu, Fisher 1999)
  HalirFlusser,  ///< the same, numerically stable: the quadratic part eliminated first (Halir, Flusser 1998)
  Normalised     ///< Halir-Flusser in coordinates of mean 0 and mean square distance 2 of the points
};
/// "fitzgibbon", "halir-flusser", "normalised".
[[nodiscard]] std::string_view name(EllipseFitVariant variant);
[[nodiscard]] Expected<EllipseFitVariant> ellipseFitNamed(std::string_view name);

struct Ellipse {
  Point2 centre{0, 0};
  double majorPx = 0, minorPx = 0;  ///< semi-axes
  double angleRad = 0;              ///< of the major axis
  [[nodiscard]] double axisRatio() const { return minorPx / majorPx; }
  [[nodiscard]] double perimeterPx() const;
};

/// At least 6 points that are not on a line.
[[nodiscard]] Expected<Ellipse> fitEllipse(std::span<const Point2> points, EllipseFitVariant variant);

}  // namespace vignole
