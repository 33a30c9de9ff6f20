#pragma once
#include <span>

#include "engine/geometry/transform2.h"

namespace vignole {

/// The motion of the plane that lays `from` onto `to`, point by point, least squares. At least two points.
[[nodiscard]] Transform2 laidOnto(std::span<const Point2> from, std::span<const Point2> to);

}  // namespace vignole
