// Integrals over the area as integrals along the outline (Green's theorem), in closed form for segments and arcs.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/rail/section.h"

namespace vignole {

namespace {

constexpr double kDensityKgPerMm3 = 7850e-9;

/// Contributions of one primitive to area, first and second moments about the origin.
struct Moments {
  double area = 0;  // 1/2 (x dy - y dx)
  double ofY = 0;   // -1/2 y^2 dx, the integral of y over the area
  double ofX = 0;   // 1/2 x^2 dy
  double ofYY = 0;  // -1/3 y^3 dx
  double ofXX = 0;  // 1/3 x^3 dy

  void operator+=(const Moments& m) {
    area += m.area;
    ofY += m.ofY;
    ofX += m.ofX;
    ofYY += m.ofYY;
    ofXX += m.ofXX;
  }
};

Moments momentsOf(const Segment& s) {
  const double x0 = s.start.x(), y0 = s.start.y(), x1 = s.end.x(), y1 = s.end.y();
  const double dx = x1 - x0, dy = y1 - y0;
  return {(x0 * y1 - x1 * y0) / 2, -dx * (y0 * y0 + y0 * y1 + y1 * y1) / 6, dy * (x0 * x0 + x0 * x1 + x1 * x1) / 6,
          -dx * (y0 + y1) * (y0 * y0 + y1 * y1) / 12, dy * (x0 + x1) * (x0 * x0 + x1 * x1) / 12};
}

/// Integrals of sin^n (n = 1 .. 4) up to an angle.
struct Powers {
  double one, two, three, four;
};
Powers sinePowers(double a) {
  const double c = std::cos(a), s2 = std::sin(2 * a), s4 = std::sin(4 * a);
  return {-c, a / 2 - s2 / 4, -c + c * c * c / 3, 3 * a / 8 - s2 / 4 + s4 / 32};
}
Powers cosinePowers(double a) {
  const double s = std::sin(a), s2 = std::sin(2 * a), s4 = std::sin(4 * a);
  return {s, a / 2 + s2 / 4, s - s * s * s / 3, 3 * a / 8 + s2 / 4 + s4 / 32};
}
Powers operator-(const Powers& a, const Powers& b) {
  return {a.one - b.one, a.two - b.two, a.three - b.three, a.four - b.four};
}

/// Integrals of (c + r t)^2 r t and (c + r t)^3 r t, where `t` stands for the sine or the cosine.
double secondPower(double c, double r, const Powers& t) {
  return r * (c * c * t.one + 2 * c * r * t.two + r * r * t.three);
}
double thirdPower(double c, double r, const Powers& t) {
  return r * (c * c * c * t.one + 3 * c * c * r * t.two + 3 * c * r * r * t.three + r * r * r * t.four);
}

Moments momentsOf(const Arc& arc) {
  const double from = arc.startAngleRad, to = from + arc.sweepRad;
  const Powers sine = sinePowers(to) - sinePowers(from), cosine = cosinePowers(to) - cosinePowers(from);
  const double cx = arc.centre.x(), cy = arc.centre.y(), r = arc.radiusMm;
  return {(r * (cx * cosine.one + cy * sine.one) + r * r * arc.sweepRad) / 2, secondPower(cy, r, sine) / 2,
          secondPower(cx, r, cosine) / 2, thirdPower(cy, r, sine) / 3, thirdPower(cx, r, cosine) / 3};
}

double kinkDeg(const Primitive& before, const Primitive& after) {
  const Point2 a = tangentAt(before, length(before)), b = tangentAt(after, 0);
  return std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b))) * 180 / std::numbers::pi;
}

}  // namespace

SectionProperties properties(const Section& section) {
  SectionProperties result;
  Moments sum;
  for (std::size_t i = 0; i < section.primitives.size(); ++i) {
    const Primitive& shape = section.primitives[i].shape;
    const Primitive& next = section.primitives[(i + 1) % section.primitives.size()].shape;
    sum += std::visit([](const auto& p) { return momentsOf(p); }, shape);
    result.perimeterMm += length(shape);
    result.maxGapMm = std::max(result.maxGapMm, (startPoint(next) - endPoint(shape)).norm());
    result.maxKinkDeg = std::max(result.maxKinkDeg, kinkDeg(shape, next));
  }
  result.areaMm2 = sum.area;
  if (sum.area == 0) return result;
  result.massKgPerM = sum.area * 1000 * kDensityKgPerMm3;
  result.centroidXMm = sum.ofX / sum.area;
  result.centroidYMm = sum.ofY / sum.area;
  result.ixCm4 = (sum.ofYY - sum.area * result.centroidYMm * result.centroidYMm) / 1e4;
  result.iyCm4 = (sum.ofXX - sum.area * result.centroidXMm * result.centroidXMm) / 1e4;
  return result;
}

}  // namespace vignole
