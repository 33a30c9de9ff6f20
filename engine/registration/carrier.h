#pragma once
// A primitive as the inner loops of the registration want it: everything precomputed, plain doubles.

#include <cmath>
#include <limits>

#include "engine/geometry/primitive.h"
#include "engine/registration/pose_kernels.h"

namespace vignole {

/// Segment or arc in section coordinates (mm); outward is to the right of travel.
struct Carrier {
  bool isArc = false;
  // Segment: start, unit tangent, outward normal, n.p = offset on the line, length. Arc: centre in x, y.
  double x = 0, y = 0, tx = 1, ty = 0, nx = 0, ny = 1, offset = 0, lengthMm = 0;
  // Arc: radius, +1 where outwards is away from the centre, unit direction to its middle, cosine of half its sweep.
  double radius = 0, outward = 1, mx = 1, my = 0, cosHalf = 1;
  double startX = 0, startY = 0, endX = 0, endY = 0;

  [[nodiscard]] static Carrier of(const Primitive& primitive);

  /// Direction of travel at the start.
  [[nodiscard]] Point2 startTangent() const {
    if (!isArc) return {tx, ty};
    return {-outward * (startY - y) / radius, outward * (startX - x) / radius};
  }
  /// Infinite for a segment.
  [[nodiscard]] double bendRadius() const { return isArc ? radius : std::numeric_limits<double>::infinity(); }

  /// Squared distance to the primitive itself, ends included.
  [[nodiscard]] double squaredDistance(double qx, double qy) const {
    if (!isArc) {
      const double dx = qx - x, dy = qy - y, along = dx * tx + dy * ty;
      if (along < 0) return dx * dx + dy * dy;
      if (along > lengthMm) return squaredDistanceTo(endX, endY, qx, qy);
      const double across = dx * nx + dy * ny;
      return across * across;
    }
    const double dx = qx - x, dy = qy - y, r = std::sqrt(dx * dx + dy * dy);
    if (dx * mx + dy * my >= cosHalf * r) return (r - radius) * (r - radius);
    return std::fmin(squaredDistanceTo(startX, startY, qx, qy), squaredDistanceTo(endX, endY, qx, qy));
  }
  /// The whole line or circle.
  [[nodiscard]] FlatCarrier flat() const {
    const auto narrow = [](double value) { return static_cast<float>(value); };
    if (!isArc) return {narrow(nx), narrow(ny), narrow(offset), 0};
    return {narrow(x), narrow(y), narrow(radius), narrow(outward)};
  }

 private:
  static double squaredDistanceTo(double ax, double ay, double qx, double qy) {
    return (qx - ax) * (qx - ax) + (qy - ay) * (qy - ay);
  }
};

}  // namespace vignole
