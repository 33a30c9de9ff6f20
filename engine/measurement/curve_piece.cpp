#include "engine/measurement/curve_piece.h"

#include <cmath>

namespace vignole {

double arcPosition(const CurvePiece& piece, double x, double y) {
  const double dx = x - piece.origin.x, dy = y - piece.origin.y, k = piece.curvature;
  const double along = piece.tangent.x * dx + piece.tangent.y * dy;
  if (k == 0) return along;
  const double across = piece.tangent.x * dy - piece.tangent.y * dx;
  const double angle = std::atan2(k * along, 1 - k * across);
  return std::abs(angle) < 1e-7 ? along : angle / k;
}

std::optional<double> ordinateAt(const CurvePiece& piece, double x) {
  const Vec& t = piece.tangent;
  const double u = x - piece.origin.x;
  const double c = t.y * u + piece.curvature * u * u * 0.5;
  const double discriminant = t.x * t.x - piece.curvature * c * 2.0;
  if (!(discriminant > 0)) return std::nullopt;
  const double root = std::sqrt(discriminant);
  return piece.origin.y + c * 2.0 / (t.x < 0 ? t.x - root : t.x + root);
}

std::optional<double> abscissaAt(const CurvePiece& piece, double y) {
  // Mirrored about the diagonal an outline turns the other way.
  return ordinateAt({{piece.origin.y, piece.origin.x},
                     {piece.tangent.y, piece.tangent.x},
                     -piece.curvature,
                     piece.fromMm,
                     piece.toMm},
                    y);
}

Advance advanced(const CurvePiece& piece, double ds) {
  const double k = piece.curvature, a = k * ds, c = std::cos(a), s = std::sin(a);
  double along = ds * (1 - a * a / 6), across = ds * a * 0.5;
  double alongPerCurvature = -ds * ds * a / 3, acrossPerCurvature = ds * ds * 0.5;
  if (std::abs(a) > 1e-4) {
    along = s / k;
    across = (1 - c) / k;
    alongPerCurvature = (ds * c - along) / k;
    acrossPerCurvature = (ds * s - across) / k;
  }
  const Vec& t = piece.tangent;
  Advance next{
      piece, {t.x * alongPerCurvature - t.y * acrossPerCurvature, t.y * alongPerCurvature + t.x * acrossPerCurvature}};
  next.piece.origin = {piece.origin.x + t.x * along - t.y * across, piece.origin.y + t.y * along + t.x * across};
  next.piece.tangent = {t.x * c - t.y * s, t.y * c + t.x * s};
  return next;
}

CurvePiece pieceOf(const Primitive& primitive, double originMm) {
  const Point2 o = pointAt(primitive, originMm), t = tangentAt(primitive, originMm);
  return {{o.x(), o.y()}, {t.x(), t.y()}, curvature(primitive), -originMm, length(primitive) - originMm};
}

Primitive primitiveOf(const CurvePiece& piece, double fromMm, double toMm) {
  const CurvePiece start = advanced(piece, fromMm).piece;
  const double k = piece.curvature;
  if (std::abs(k) < 1e-9) {
    const CurvePiece end = advanced(piece, toMm).piece;
    return Segment{{start.origin.x, start.origin.y}, {end.origin.x, end.origin.y}};
  }
  Arc arc;
  arc.centre = {start.origin.x - start.tangent.y / k, start.origin.y + start.tangent.x / k};
  arc.radiusMm = 1 / std::abs(k);
  arc.startAngleRad = std::atan2(start.origin.y - arc.centre.y(), start.origin.x - arc.centre.x());
  arc.sweepRad = k * (toMm - fromMm);
  return arc;
}

}  // namespace vignole
