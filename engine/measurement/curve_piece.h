#pragma once
// A piece of constant curvature: line and circle as one smooth family, so that a fit may pass through curvature 0.
// With left normal m, distance d = q - origin and curvature k, the carrier is F(q) = m.d - k |d|^2 / 2 = 0, and the
// signed distance r (> 0 to the left) satisfies r - k r^2 / 2 = F.

#include <cmath>
#include <optional>

#include "engine/geometry/primitive.h"
#include "engine/measurement/dual.h"

namespace vignole {

/// Plane vector over double or Dual.
template <typename T>
struct Vec {
  T x{}, y{};
};

/// Origin at arc length 0, unit tangent there, curvature > 0 turning left (1/mm), and the range of arc length (mm from
/// the origin) over which it stands for its primitive.
template <typename T>
struct CurvePiece {
  Vec<T> origin;
  Vec<T> tangent{T(1), T(0)};
  T curvature{};
  double fromMm = 0;
  double toMm = 0;
};

/// Rigid motion into the frame with origin `o` and x axis along the unit vector `ux`.
template <typename T>
[[nodiscard]] Vec<T> toFrame(const Vec<T>& o, const Vec<T>& ux, const Vec<T>& p) {
  const T dx = p.x - o.x, dy = p.y - o.y;
  return {ux.x * dx + ux.y * dy, ux.x * dy - ux.y * dx};
}

/// Arc length from the origin to the point of the piece nearest to (x, y).
template <typename T>
[[nodiscard]] double arcPosition(const CurvePiece<T>& piece, double x, double y) {
  const double dx = x - valueOf(piece.origin.x), dy = y - valueOf(piece.origin.y);
  const double tx = valueOf(piece.tangent.x), ty = valueOf(piece.tangent.y), k = valueOf(piece.curvature);
  const double along = tx * dx + ty * dy, across = tx * dy - ty * dx;
  const double angle = std::atan2(k * along, 1 - k * across);
  return std::abs(angle) < 1e-7 ? along : angle / k;
}

/// Ordinate of the piece above x, on the branch that continues its origin; empty where the carrier does not reach x.
template <typename T>
[[nodiscard]] std::optional<T> ordinateAt(const CurvePiece<T>& piece, const T& x) {
  using std::sqrt;
  const T u = x - piece.origin.x;
  const T c = piece.tangent.y * u + piece.curvature * u * u * 0.5;
  const T discriminant = piece.tangent.x * piece.tangent.x - piece.curvature * c * 2.0;
  if (!(valueOf(discriminant) > 0)) return std::nullopt;
  const T root = sqrt(discriminant);
  const T denominator = valueOf(piece.tangent.x) < 0 ? piece.tangent.x - root : piece.tangent.x + root;
  return piece.origin.y + c * 2.0 / denominator;
}

/// Abscissa of the piece at height y; as ordinateAt.
template <typename T>
[[nodiscard]] std::optional<T> abscissaAt(const CurvePiece<T>& piece, const T& y) {
  // Mirrored about the diagonal an outline turns the other way.
  const CurvePiece<T> mirrored{
      {piece.origin.y, piece.origin.x}, {piece.tangent.y, piece.tangent.x}, -piece.curvature, piece.fromMm, piece.toMm};
  return ordinateAt(mirrored, y);
}

/// The frame reached after `ds` along the piece; curvature and range are the caller's to set.
template <typename T>
[[nodiscard]] CurvePiece<T> advanced(const CurvePiece<T>& piece, const T& ds) {
  using std::cos;
  using std::sin;
  const T a = piece.curvature * ds;
  T along = ds, across = ds * a * 0.5;
  if (std::abs(valueOf(a)) > 1e-4) {
    along = sin(a) / piece.curvature;
    across = (1.0 - cos(a)) / piece.curvature;
  } else {
    along = ds * (1.0 - a * a / 6.0);
  }
  const T c = cos(a), s = sin(a);
  CurvePiece<T> next = piece;
  next.origin.x = piece.origin.x + piece.tangent.x * along - piece.tangent.y * across;
  next.origin.y = piece.origin.y + piece.tangent.y * along + piece.tangent.x * across;
  next.tangent.x = piece.tangent.x * c - piece.tangent.y * s;
  next.tangent.y = piece.tangent.y * c + piece.tangent.x * s;
  return next;
}

/// A primitive as a piece, its origin at arc length `originMm` of the primitive; the range is the primitive's.
[[nodiscard]] CurvePiece<double> pieceOf(const Primitive& primitive, double originMm = 0);
/// The piece between two arc lengths as a segment (curvature below 1e-9) or an arc.
[[nodiscard]] Primitive primitiveOf(const CurvePiece<double>& piece, double fromMm, double toMm);

}  // namespace vignole
