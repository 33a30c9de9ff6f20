// How the definitions read the shapes: the datum, and places on primitives and foot bottom with what moves them.

#include <Eigen/LU>
#include <cmath>

#include "engine/measurement/definitions.h"

namespace vignole {
namespace {

bool reaches(const CurvePiece& piece, double x, double y, double slack = 0) {
  const double s = arcPosition(piece, x, y);
  return s >= piece.fromMm - slack - 1e-6 && s <= piece.toMm + slack + 1e-6;
}

/// Normal of the carrier at a point on it.
Vec normalAt(const CurvePiece& piece, double x, double y) {
  return {-piece.tangent.y - piece.curvature * (x - piece.origin.x),
          piece.tangent.x - piece.curvature * (y - piece.origin.y)};
}

}  // namespace

// ---- datum ----

void Definitions::findDatum() {
  datum_.origin = {};
  datum_.along = {1, 0};
  datum_.reason.clear();
  datum_.fromFoot = placeDatum();
  for (std::size_t p = 0; p < pieces_.size(); ++p)
    if (present(p)) pieces_[p] = inDatum(p);
  if (datum_.fromFoot) linearizeDatum();
}

bool Definitions::placeDatum() {
  for (const std::size_t p : {plan_.footBottom, plan_.footEdge[kLeft], plan_.footEdge[kRight]})
    if (!present(p)) {
      datum_.reason = shapes_->missing[p];
      return false;
    }
  // The edges are read at a height above the base line, and the base line 5 mm inside the edges: three rounds settle.
  std::array<double, 2> edge{};
  for (int round = 0; round < 3; ++round) {
    if (!edgesAt(edge)) return false;
    const Vec left = footBottomPoint(edge[kLeft] + parameters_.baseInsetMm);
    const Vec right = footBottomPoint(edge[kRight] - parameters_.baseInsetMm);
    const double dx = right.x - left.x, dy = right.y - left.y, span = std::sqrt(dx * dx + dy * dy);
    datum_.along = {dx / span, dy / span};
    datum_.origin = left;
  }
  if (!edgesAt(edge)) return false;
  const double axis = (edge[kLeft] + edge[kRight]) * 0.5 + plan_.axisFromFootMiddleMm;
  datum_.origin.x += datum_.along.x * axis;
  datum_.origin.y += datum_.along.y * axis;
  return true;
}

bool Definitions::edgesAt(std::array<double, 2>& edge) {
  for (const std::size_t side : {kLeft, kRight}) {
    const auto x = abscissaAt(inDatum(plan_.footEdge[side]), plan_.footEdgeMidHeightMm[side]);
    if (!x) {
      datum_.reason = "the foot edge is not upright";
      return false;
    }
    edge[side] = *x;
  }
  return true;
}

/// The datum holds three conditions: the foot bottom has height 0 at both ends of the base line, and the axis stands
/// where it should between the edges. When the foot moves, the datum moves so that they go on holding.
void Definitions::linearizeDatum() {
  for (const std::size_t side : {kLeft, kRight}) {
    const double y = plan_.footEdgeMidHeightMm[side];
    edge_[side] = abscissaOf(plan_.footEdge[side], *abscissaAt(pieces_[plan_.footEdge[side]], y), y);
  }
  const std::array<Reading, 3> held = {edge_[kLeft] + edge_[kRight],
                                       footBottomHeight(edge_[kLeft] + parameters_.baseInsetMm),
                                       footBottomHeight(edge_[kRight] - parameters_.baseInsetMm)};
  Eigen::Matrix3d withDatum;
  for (std::size_t i = 0; i < 3; ++i) {
    const Slopes s = held[i].slopesWith(kDatumMover);
    withDatum.row(static_cast<int>(i)) << s[0], s[1], s[2];
  }
  const Eigen::Matrix3d inverse = withDatum.inverse();
  for (std::size_t i = 0; i < 3; ++i) {
    shift_[i] = {};
    for (std::size_t j = 0; j < 3; ++j)
      shift_[i].moveWith(held[j].without(kDatumMover), -inverse(static_cast<int>(i), static_cast<int>(j)));
  }
}

/// Puts what moves the datum in the datum's place.
void Definitions::settle(Reading& reading) const {
  const Slopes s = reading.slopesWith(kDatumMover);
  reading = reading.without(kDatumMover);
  if (!datum_.fromFoot) return;
  for (std::size_t i = 0; i < shift_.size(); ++i) reading.moveWith(shift_[i], s[i]);
}

/// The foot bottom met by the perpendicular to the base line at abscissa x of the datum, in the frame of the shapes.
Vec Definitions::footBottomPoint(double x) const {
  const Vec& o = datum_.origin;
  const Vec& a = datum_.along;
  double X = o.x + a.x * x, Y = shapes_->footBottom.at(X);
  for (int round = 0; round < 2; ++round) {  // the perpendicular leans by less than a degree: two rounds are exact
    const double height = (Y - o.y - a.y * x) * a.x - (X - o.x - a.x * x) * a.y;
    X = o.x + a.x * x - a.y * height;
    Y = shapes_->footBottom.at(X);
  }
  return {X, Y};
}

CurvePiece Definitions::inDatum(std::size_t primitive) const {
  const CurvePiece& piece = shapes_->pieces[primitive];
  return {toFrame(datum_.origin, datum_.along, piece.origin), toFrame({}, datum_.along, piece.tangent), piece.curvature,
          piece.fromMm, piece.toMm};
}

// ---- readings ----

/// How far the primitive moves along the normal where it is read, as it and the datum move.
Reading Definitions::displacement(std::size_t primitive, const Vec& at, const Vec& n) const {
  const Vec& a = datum_.along;
  const double dx = at.x - pieces_[primitive].origin.x, dy = at.y - pieces_[primitive].origin.y;
  Reading r;
  r.move(moverOf(primitive), 1,
         {a.x * n.x - a.y * n.y, a.y * n.x + a.x * n.y, n.y * dx - n.x * dy, 0.5 * (dx * dx + dy * dy)});
  r.move(kDatumMover, -1, {n.x, n.y, n.y * at.x - n.x * at.y, 0});
  return r;
}

Reading Definitions::ordinateOf(std::size_t primitive, const Reading& x, double y) const {
  const Vec n = normalAt(pieces_[primitive], x.value, y);
  Reading r = displacement(primitive, {x.value, y}, n) * (1 / n.y);
  r.moveWith(x, -n.x / n.y);
  r.value = y;
  return r;
}

Reading Definitions::abscissaOf(std::size_t primitive, double x, const Reading& y) const {
  const Vec n = normalAt(pieces_[primitive], x, y.value);
  Reading r = displacement(primitive, {x, y.value}, n) * (1 / n.x);
  r.moveWith(y, -n.y / n.x);
  r.value = x;
  return r;
}

Reading Definitions::footBottomHeight(const Reading& x) const {
  const Vec at = footBottomPoint(x.value);
  const double y = toFrame(datum_.origin, datum_.along, at).y;
  // The normal (-slope, 1) of the parabola, in the datum.
  const Vec n = toFrame({}, datum_.along, {-shapes_->footBottom.slopeAt(at.x), 1});
  Reading r(y);
  r.move(kFootBottomMover, 1 / n.y, {1, at.x, at.x * at.x, 0});
  r.move(kDatumMover, -1 / n.y, {n.x, n.y, n.y * x.value - n.x * y, 0});
  r.moveWith(x, -n.x / n.y);
  return r;
}

std::optional<double> Definitions::plainOrdinate(std::size_t primitive, double x) const {
  const auto y = ordinateAt(pieces_[primitive], x);
  return y && reaches(pieces_[primitive], x, *y, jointSlackMm_) ? y : std::nullopt;
}

std::optional<double> Definitions::plainAbscissa(std::size_t primitive, double y) const {
  const auto x = abscissaAt(pieces_[primitive], y);
  return x && reaches(pieces_[primitive], *x, y) ? x : std::nullopt;
}

}  // namespace vignole
