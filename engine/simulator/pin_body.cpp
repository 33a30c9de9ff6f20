#include "engine/simulator/pin_body.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace vignole::simulator {

PinBody::PinBody(int number, const Point3& onAxis, const Point3& axis, double radiusMm, double below, double above)
    : number_(number), onAxis_(onAxis), axis_(axis), radius_(radiusMm), below_(-below), above_(above) {
  v_ = axis_.cross(Point3::UnitX()).normalized();
  u_ = v_.cross(axis_);
  const Point3 foot = onAxis_ - onAxis_.z() / axis_.z() * axis_;
  centre_ = foot.head<2>();
  // The body is the hull of its two end disks.
  const double ends =
      std::max((onAxis_ + below_ * axis_ - foot).head<2>().norm(), (onAxis_ + above_ * axis_ - foot).head<2>().norm());
  reach_ = ends + radius_;
}

Point3 PinBody::normal(double angleRad) const { return std::cos(angleRad) * u_ + std::sin(angleRad) * v_; }

Point2 PinBody::cut(double angleRad) const {
  const Point3 onSkin = onAxis_ + radius_ * normal(angleRad);
  return (onSkin - onSkin.z() / axis_.z() * axis_).head<2>();
}

bool PinBody::hides(const Point3& from, const Point3& to) const {
  const Point3 p = from - onAxis_, d = to - from;
  const double pAlong = p.dot(axis_), dAlong = d.dot(axis_);
  const Point3 pAcross = p - pAlong * axis_, dAcross = d - dAlong * axis_;
  // |pAcross + t dAcross| < radius for t between the roots.
  const double a = dAcross.squaredNorm(), b = pAcross.dot(dAcross), c = pAcross.squaredNorm() - radius_ * radius_;
  const double root2 = b * b - a * c;
  if (!(root2 > 0)) return false;
  const double root = std::sqrt(root2);
  double enter = std::max(0.0, (-b - root) / a), leave = std::min(1.0, (-b + root) / a);
  // Between the ends.
  if (dAlong != 0) {
    const double t0 = (below_ - pAlong) / dAlong, t1 = (above_ - pAlong) / dAlong;
    enter = std::max(enter, std::min(t0, t1));
    leave = std::min(leave, std::max(t0, t1));
  } else if (pAlong < below_ || pAlong > above_) {
    return false;
  }
  return enter < leave;
}

}  // namespace vignole::simulator
