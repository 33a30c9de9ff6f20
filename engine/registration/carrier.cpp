#include "engine/registration/carrier.h"

namespace vignole {

Carrier Carrier::of(const Primitive& primitive) {
  Carrier c;
  const Point2 start = startPoint(primitive), end = endPoint(primitive);
  c.startX = start.x();
  c.startY = start.y();
  c.endX = end.x();
  c.endY = end.y();
  c.lengthMm = length(primitive);
  if (const auto* arc = std::get_if<Arc>(&primitive)) {
    c.isArc = true;
    c.x = arc->centre.x();
    c.y = arc->centre.y();
    c.radius = arc->radiusMm;
    c.outward = arc->sweepRad > 0 ? 1 : -1;
    const double middle = arc->startAngleRad + arc->sweepRad / 2;
    c.mx = std::cos(middle);
    c.my = std::sin(middle);
    c.cosHalf = std::cos(arc->sweepRad / 2);
    return c;
  }
  const Point2 t = tangentAt(primitive, 0), n = normalAt(primitive, 0);
  c.x = start.x();
  c.y = start.y();
  c.tx = t.x();
  c.ty = t.y();
  c.nx = n.x();
  c.ny = n.y();
  c.offset = n.dot(start);
  return c;
}

}  // namespace vignole
