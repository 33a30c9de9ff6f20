#include "calibration/assessment/plane_motion.h"

#include <cmath>

namespace vignole {

Transform2 laidOnto(std::span<const Point2> from, std::span<const Point2> to) {
  Point2 a(0, 0), b(0, 0);
  for (std::size_t i = 0; i < from.size(); ++i) {
    a += from[i] / static_cast<double>(from.size());
    b += to[i] / static_cast<double>(from.size());
  }
  double cosine = 0, sine = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Point2 p = from[i] - a, q = to[i] - b;
    cosine += p.dot(q);
    sine += p.x() * q.y() - p.y() * q.x();
  }
  Transform2 t{0, 0, std::atan2(sine, cosine)};
  const Point2 shift = b - t.rotate(a);
  t.xMm = shift.x();
  t.yMm = shift.y();
  return t;
}

}  // namespace vignole
