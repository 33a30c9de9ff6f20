#pragma once
// A piece of constant curvature: line and circle as one smooth family, so that a fit may pass through curvature 0.
// With left normal m, distance d = q - origin and curvature k, the carrier is F(q) = m.d - k |d|^2 / 2 = 0, and the
// signed distance r (> 0 to the left) satisfies r - k r^2 / 2 = F.

#include <optional>

#include "engine/geometry/primitive.h"

namespace vignole {

struct Vec {
  double x = 0, y = 0;
};

/// Origin at arc length 0, unit tangent there, curvature > 0 turning left (1/mm), and the range of arc length (mm from
/// the origin) over which it stands for its primitive.
struct CurvePiece {
  Vec origin;
  Vec tangent{1, 0};
  double curvature = 0;
  double fromMm = 0;
  double toMm = 0;
};

/// Rigid motion into the frame with origin `o` and x axis along the unit vector `ux`.
[[nodiscard]] inline Vec toFrame(const Vec& o, const Vec& ux, const Vec& p) {
  const double dx = p.x - o.x, dy = p.y - o.y;
  return {ux.x * dx + ux.y * dy, ux.x * dy - ux.y * dx};
}

/// Arc length from the origin to the point of the piece nearest to (x, y).
[[nodiscard]] double arcPosition(const CurvePiece& piece, double x, double y);
/// Ordinate of the piece above x, on the branch that continues its origin; empty where the carrier does not reach x.
[[nodiscard]] std::optional<double> ordinateAt(const CurvePiece& piece, double x);
/// Abscissa of the piece at height y; as ordinateAt.
[[nodiscard]] std::optional<double> abscissaAt(const CurvePiece& piece, double y);

/// Where `ds` along a piece leads, and how that place moves with the piece's curvature (mm per 1/mm).
struct Advance {
  CurvePiece piece;  ///< curvature and range are the caller's to set
  Vec perCurvature;
};
[[nodiscard]] Advance advanced(const CurvePiece& piece, double ds);

/// A primitive as a piece, its origin at arc length `originMm` of the primitive; the range is the primitive's.
[[nodiscard]] CurvePiece pieceOf(const Primitive& primitive, double originMm = 0);
/// The piece between two arc lengths as a segment (curvature below 1e-9) or an arc.
[[nodiscard]] Primitive primitiveOf(const CurvePiece& piece, double fromMm, double toMm);

}  // namespace vignole
