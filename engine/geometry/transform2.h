#pragma once
// Points and rigid transforms of the plane, millimetres and radians.

#include <Eigen/Core>
#include <cmath>

namespace vignole {

using Point2 = Eigen::Vector2d;
using Point3 = Eigen::Vector3d;

/// Rigid transform of the plane, named targetFromSource: rotate by `angleRad` about the source's origin, then shift.
struct Transform2 {
  double xMm = 0;
  double yMm = 0;
  double angleRad = 0;

  [[nodiscard]] Point2 rotate(const Point2& v) const {
    const double c = std::cos(angleRad), s = std::sin(angleRad);
    return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
  }
  [[nodiscard]] Point2 operator*(const Point2& p) const { return rotate(p) + Point2(xMm, yMm); }
  [[nodiscard]] Transform2 operator*(const Transform2& b) const {
    const Point2 t = *this * Point2(b.xMm, b.yMm);
    return {t.x(), t.y(), angleRad + b.angleRad};
  }
  [[nodiscard]] Transform2 inverse() const {
    const Transform2 back{0, 0, -angleRad};
    const Point2 t = back.rotate(Point2(-xMm, -yMm));
    return {t.x(), t.y(), -angleRad};
  }
};

}  // namespace vignole
