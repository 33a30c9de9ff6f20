#pragma once
// A pin as a body in the world: a circular cylinder with ends, its cut with the light plane z = 0, and what it hides.

#include "engine/geometry/transform2.h"

namespace vignole::simulator {

class PinBody {
 public:
  /// A cylinder about the line through `onAxis` along `axis` (unit, pointing to the cameras' side), from `below` mm
  /// before that point to `above` mm beyond it.
  PinBody(int number, const Point3& onAxis, const Point3& axis, double radiusMm, double below, double above);

  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] double radiusMm() const { return radius_; }
  /// Where the axis meets the light plane.
  [[nodiscard]] Point2 centre() const { return centre_; }
  /// Point of the cut (an ellipse; counter-clockwise with the angle) and the unit normal of the skin there.
  [[nodiscard]] Point2 cut(double angleRad) const;
  [[nodiscard]] Point3 normal(double angleRad) const;
  /// Whether the line of sight from a point outside this body to another one runs through it.
  [[nodiscard]] bool hides(const Point3& from, const Point3& to) const;
  /// No point of the body is farther from the axis' foot than this, looked at along z.
  [[nodiscard]] double reachMm() const { return reach_; }

 private:
  int number_;
  Point3 onAxis_, axis_, u_, v_;
  double radius_, below_, above_, reach_;
  Point2 centre_;
};

}  // namespace vignole::simulator
