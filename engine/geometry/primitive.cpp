#include "engine/geometry/primitive.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace vignole {

namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;
constexpr double kOnPrimitiveMm = 1e-9;  // two computed points closer than this are the same point

Point2 rightOf(const Point2& v) { return {v.y(), -v.x()}; }
double cross(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }
Point2 onCircle(double angleRad) { return {std::cos(angleRad), std::sin(angleRad)}; }
double turn(const Arc& arc) { return arc.sweepRad < 0 ? -1.0 : 1.0; }

Point2 unitDirection(const Segment& s) {
  const Point2 d = s.end - s.start;
  const double n = d.norm();
  return n > 0 ? Point2(d / n) : Point2(1, 0);
}

/// How far one has to turn from the arc's start, its own way round, to see `direction`: 0 .. 2 pi.
double turnTo(const Arc& arc, const Point2& direction) {
  double t = turn(arc) * (std::atan2(direction.y(), direction.x()) - arc.startAngleRad);
  t = std::fmod(t, kTwoPi);
  return t < 0 ? t + kTwoPi : t;
}

/// The distance's sign says on which side of the tangent the query lies, also beyond an end.
Nearest at(const Point2& foot, const Point2& normal, const Point2& query, double arcLengthMm, bool atEnd) {
  const Point2 d = query - foot;
  return {foot, normal, d.dot(normal) < 0 ? -d.norm() : d.norm(), arcLengthMm, atEnd};
}

Nearest nearestTo(const Segment& s, const Point2& query) {
  const Point2 t = unitDirection(s);
  const double whole = (s.end - s.start).norm();
  const double along = t.dot(query - s.start);
  const double clamped = std::clamp(along, 0.0, whole);
  return at(s.start + clamped * t, rightOf(t), query, clamped, along != clamped);
}

Nearest nearestTo(const Arc& arc, const Point2& query) {
  const Point2 radial = query - arc.centre;
  const double sweep = std::abs(arc.sweepRad);
  const double distance = radial.norm();
  if (distance > 0) {
    const double t = turnTo(arc, radial);
    if (t <= sweep) {
      const Point2 out = radial / distance;
      return {arc.centre + arc.radiusMm * out, turn(arc) * out, turn(arc) * (distance - arc.radiusMm), t * arc.radiusMm,
              false};
    }
  }
  // Beyond the ends (or in the centre, where every point of the arc is as near as the start).
  const Point2 out0 = onCircle(arc.startAngleRad), out1 = onCircle(arc.startAngleRad + arc.sweepRad);
  const Point2 p0 = arc.centre + arc.radiusMm * out0, p1 = arc.centre + arc.radiusMm * out1;
  if ((query - p0).squaredNorm() <= (query - p1).squaredNorm()) return at(p0, turn(arc) * out0, query, 0, distance > 0);
  return at(p1, turn(arc) * out1, query, sweep * arc.radiusMm, true);
}

std::vector<Point2> carrierIntersections(const Segment& s, const Point2& point, const Point2& direction) {
  const Point2 along = s.end - s.start;
  const double d = cross(direction, along);
  if (std::abs(d) <= 1e-14 * direction.norm() * along.norm()) return {};
  return {point + cross(s.start - point, along) / d * direction};
}

std::vector<Point2> carrierIntersections(const Arc& arc, const Point2& point, const Point2& direction) {
  const double n = direction.norm();
  if (n == 0) return {};
  const Point2 u = direction / n;
  const double middle = u.dot(arc.centre - point);
  const Point2 foot = point + middle * u;
  const double h2 = arc.radiusMm * arc.radiusMm - (foot - arc.centre).squaredNorm();
  const double touching = 2 * arc.radiusMm * kOnPrimitiveMm;  // the line misses by less than the tolerance
  if (h2 < -touching) return {};
  if (h2 <= 0) return {foot};
  const double h = std::sqrt(h2);
  return {foot - h * u, foot + h * u};
}

std::vector<Point2> carrierIntersections(const Arc& a, const Arc& b) {
  const Point2 d = b.centre - a.centre;
  const double distance = d.norm();
  if (distance < kOnPrimitiveMm) return {};
  const double along = (distance * distance + a.radiusMm * a.radiusMm - b.radiusMm * b.radiusMm) / (2 * distance);
  const Point2 foot = a.centre + along / distance * d;
  const double h2 = a.radiusMm * a.radiusMm - along * along;
  if (h2 < -2 * a.radiusMm * kOnPrimitiveMm) return {};
  const Point2 across = rightOf(d / distance) * std::sqrt(std::max(h2, 0.0));
  return {foot + across, foot - across};
}

std::vector<Point2> carrierIntersections(const Primitive& a, const Primitive& b) {
  if (const auto* s = std::get_if<Segment>(&a)) return intersectLine(b, s->start, s->end - s->start, true);
  if (const auto* s = std::get_if<Segment>(&b)) return intersectLine(a, s->start, s->end - s->start, true);
  return carrierIntersections(std::get<Arc>(a), std::get<Arc>(b));
}

bool liesOn(const Primitive& p, const Point2& point) {
  return std::abs(nearest(p, point).distanceMm) <= kOnPrimitiveMm;
}

}  // namespace

Nearest nearest(const Primitive& primitive, const Point2& point) {
  return std::visit([&](const auto& p) { return nearestTo(p, point); }, primitive);
}

double length(const Primitive& primitive) {
  if (const auto* s = std::get_if<Segment>(&primitive)) return (s->end - s->start).norm();
  const auto& arc = std::get<Arc>(primitive);
  return std::abs(arc.sweepRad) * arc.radiusMm;
}

Point2 startPoint(const Primitive& primitive) {
  if (const auto* s = std::get_if<Segment>(&primitive)) return s->start;
  const auto& arc = std::get<Arc>(primitive);
  return arc.centre + arc.radiusMm * onCircle(arc.startAngleRad);
}

Point2 endPoint(const Primitive& primitive) {
  if (const auto* s = std::get_if<Segment>(&primitive)) return s->end;
  const auto& arc = std::get<Arc>(primitive);
  return arc.centre + arc.radiusMm * onCircle(arc.startAngleRad + arc.sweepRad);
}

Point2 pointAt(const Primitive& primitive, double s) {
  if (const auto* segment = std::get_if<Segment>(&primitive)) return segment->start + s * unitDirection(*segment);
  const auto& arc = std::get<Arc>(primitive);
  return arc.centre + arc.radiusMm * onCircle(arc.startAngleRad + turn(arc) * s / arc.radiusMm);
}

Point2 tangentAt(const Primitive& primitive, double s) {
  const Point2 n = normalAt(primitive, s);
  return {-n.y(), n.x()};
}

Point2 normalAt(const Primitive& primitive, double s) {
  if (const auto* segment = std::get_if<Segment>(&primitive)) return rightOf(unitDirection(*segment));
  const auto& arc = std::get<Arc>(primitive);
  return turn(arc) * onCircle(arc.startAngleRad + turn(arc) * s / arc.radiusMm);
}

double curvature(const Primitive& primitive) {
  const auto* arc = std::get_if<Arc>(&primitive);
  return arc == nullptr ? 0.0 : turn(*arc) / arc->radiusMm;
}

Primitive transformed(const Transform2& targetFromSource, const Primitive& primitive) {
  if (const auto* s = std::get_if<Segment>(&primitive))
    return Segment{targetFromSource * s->start, targetFromSource * s->end};
  Arc arc = std::get<Arc>(primitive);
  arc.centre = targetFromSource * arc.centre;
  arc.startAngleRad += targetFromSource.angleRad;
  return arc;
}

std::vector<Point2> intersectLine(const Primitive& primitive, const Point2& point, const Point2& direction,
                                  bool carrier) {
  std::vector<Point2> found =
      std::visit([&](const auto& p) { return carrierIntersections(p, point, direction); }, primitive);
  if (!carrier) std::erase_if(found, [&](const Point2& p) { return !liesOn(primitive, p); });
  std::sort(found.begin(), found.end(),
            [&](const Point2& p, const Point2& q) { return direction.dot(p) < direction.dot(q); });
  return found;
}

std::vector<Point2> intersect(const Primitive& a, const Primitive& b) {
  // The ends are candidates of their own: where two primitives touch or lie on one carrier, carriers alone do not tell.
  std::vector<Point2> candidates = {startPoint(a), endPoint(a), startPoint(b), endPoint(b)};
  const std::vector<Point2> crossings = carrierIntersections(a, b);
  candidates.insert(candidates.end(), crossings.begin(), crossings.end());

  std::vector<Point2> common;
  for (const Point2& p : candidates) {
    const auto same = [&](const Point2& q) { return (p - q).norm() <= 2 * kOnPrimitiveMm; };
    if (liesOn(a, p) && liesOn(b, p) && std::none_of(common.begin(), common.end(), same)) common.push_back(p);
  }
  return common;
}

std::vector<Point2> polyline(const Primitive& primitive, double stepMm) {
  const double whole = length(primitive);
  const int steps =
      std::holds_alternative<Segment>(primitive) ? 1 : std::max(4, static_cast<int>(std::ceil(whole / stepMm)));
  std::vector<Point2> points;
  for (int i = 0; i <= steps; ++i) points.push_back(pointAt(primitive, whole * i / steps));
  return points;
}

}  // namespace vignole
