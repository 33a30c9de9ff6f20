#include "engine/measurement/curve_piece.h"

#include <numbers>

namespace vignole {

CurvePiece<double> pieceOf(const Primitive& primitive, double originMm) {
  const Point2 o = pointAt(primitive, originMm), t = tangentAt(primitive, originMm);
  return {{o.x(), o.y()}, {t.x(), t.y()}, curvature(primitive), -originMm, length(primitive) - originMm};
}

Primitive primitiveOf(const CurvePiece<double>& piece, double fromMm, double toMm) {
  const CurvePiece<double> start = advanced(piece, fromMm);
  const double k = piece.curvature;
  if (std::abs(k) < 1e-9) {
    const CurvePiece<double> end = advanced(piece, toMm);
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
