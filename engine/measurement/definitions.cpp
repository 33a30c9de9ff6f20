#include "engine/measurement/definitions.h"

#include <Eigen/LU>
#include <cmath>

namespace vignole {
namespace {

void anchor(DefinedValue& v, double x, double y) { v.anchors[v.anchorCount++] = {x, y}; }

std::string number(double mm) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g mm", mm);
  return text;
}

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

void Definitions::evaluate(const Shapes& shapes, PerDimension<DefinedValue>& values) {
  shapes_ = &shapes;
  pieces_.resize(shapes.pieces.size());
  findDatum();
  for (Value& v : values) {
    v.value.reset();
    v.second.reset();
    v.hasParts = false;
    v.reason.clear();
    v.used.reset();
    v.anchorCount = 0;
    v.candidates.clear();
  }
  crownHeight_ = ordinate(plan_.crownOnAxis, 0, nullptr);
  railHeight(values[index(Dimension::RH)]);
  fishingHeight(values[index(Dimension::RFH)]);
  footWidth(values[index(Dimension::FW)]);
  headForm(values[index(Dimension::HF)]);
  headWidth(values[index(Dimension::HW)], parameters_.hwDepthMm);
  headWidth(values[index(Dimension::HWA)], parameters_.hwaDepthMm);
  footThickness(values[index(Dimension::FTl)], kLeft, parameters_.ftInsideMm.left);
  footThickness(values[index(Dimension::FTr)], kRight, parameters_.ftInsideMm.right);
  asymmetry(values[index(Dimension::RASl)], kLeft, parameters_.rasDepthMm.left);
  asymmetry(values[index(Dimension::RASr)], kRight, parameters_.rasDepthMm.right);
  webThickness(values[index(Dimension::WT)]);
  headRadius(values[index(Dimension::HR)]);
  footConcavity(values[index(Dimension::FC)]);
  for (Value& v : values) {
    if (v.value) settle(*v.value);
    if (v.second) settle(*v.second);
    for (Reading& place : v.candidates) settle(place);
  }
}

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

bool Definitions::need(std::size_t primitive, Value& v) const {
  v.used.set(primitive);
  if (present(primitive)) return true;
  v.reason = shapes_->missing[primitive];
  return false;
}

bool Definitions::needBaseLine(Value& v) const {
  if (datum_.fromFoot) return true;
  v.reason = "no base line: " + datum_.reason;
  return false;
}

bool Definitions::needCrown(Value& v) const {
  if (!need(plan_.crownOnAxis, v)) return false;
  if (crownHeight_) return true;
  v.reason = "points do not reach the crown on the axis";
  return false;
}

std::optional<Reading> Definitions::ordinate(std::size_t primitive, const Reading& x, Value* v) const {
  if (!present(primitive)) {
    if (v != nullptr) v->reason = shapes_->missing[primitive];
    return std::nullopt;
  }
  if (const auto y = plainOrdinate(primitive, x.value)) return ordinateOf(primitive, x, *y);
  if (v != nullptr) v->reason = "points do not reach x = " + number(x.value) + " from the axis";
  return std::nullopt;
}

/// Abscissa of the head's side `depth` below the crown on the axis.
std::optional<Reading> Definitions::headSide(std::size_t side, double depth, Value& v) const {
  const Reading y = *crownHeight_ - depth;
  const std::string* missing = nullptr;
  for (const std::size_t p : plan_.headSide[side]) {
    if (!present(p)) {
      if (missing == nullptr) missing = &shapes_->missing[p];
      continue;
    }
    const auto x = plainAbscissa(p, y.value);
    if (!x) continue;
    v.used.set(p);
    return abscissaOf(p, *x, y);
  }
  v.reason = missing == nullptr ? "points do not reach " + number(depth) + " below the crown" : *missing;
  return std::nullopt;
}

std::optional<Reading> Definitions::webFace(std::size_t side, double y) const {
  for (const std::size_t p : plan_.web[side])
    if (present(p))
      if (const auto x = plainAbscissa(p, y)) return abscissaOf(p, *x, y);
  return std::nullopt;
}

std::optional<double> Definitions::plainWebFace(std::size_t side, double y) const {
  for (const std::size_t p : plan_.web[side])
    if (present(p))
      if (const auto x = plainAbscissa(p, y)) return x;
  return std::nullopt;
}

Reading Definitions::crownDeviation(const CrownSample& sample) const {
  const double y = *ordinateAt(pieces_[sample.primitive], sample.xMm);
  return ordinateOf(sample.primitive, sample.xMm, y) - *crownHeight_ - sample.nominalDropMm;
}

// ---- dimensions ----

void Definitions::railHeight(Value& v) const {
  if (!needBaseLine(v) || !needCrown(v)) return;
  v.value = crownHeight_;
  v.used.set(plan_.footBottom);
  anchor(v, 0, 0);
  anchor(v, 0, crownHeight_->value);
}

void Definitions::fishingHeight(Value& v) const {
  if (!needBaseLine(v)) return;
  const std::array<double, 2> x = {-parameters_.rfhFromAxisMm.left, parameters_.rfhFromAxisMm.right};
  std::array<Reading, 2> height;
  for (const std::size_t side : {kLeft, kRight}) {
    const std::size_t upper = plan_.fishingUpper[side], lower = plan_.fishingLower[side];
    if (!need(upper, v) || !need(lower, v)) return;
    const auto top = ordinate(upper, x[side], &v), bottom = ordinate(lower, x[side], &v);
    if (!top || !bottom) return;
    height[side] = *top - *bottom;
    anchor(v, x[side], bottom->value);
    anchor(v, x[side], top->value);
  }
  v.left = height[kLeft].value;
  v.right = height[kRight].value;
  v.hasParts = true;
  v.value = (height[kLeft] + height[kRight]) * 0.5;
}

void Definitions::footWidth(Value& v) const {
  if (!needBaseLine(v) || !need(plan_.footEdge[kLeft], v) || !need(plan_.footEdge[kRight], v)) return;
  v.value = edge_[kRight] - edge_[kLeft];
  for (const std::size_t side : {kLeft, kRight}) anchor(v, edge_[side].value, plan_.footEdgeMidHeightMm[side]);
}

void Definitions::headForm(Value& v) const {
  if (!needBaseLine(v) || !needCrown(v)) return;
  const CrownSample *highest = nullptr, *lowest = nullptr;
  double high = -1e300, low = 1e300;
  for (const CrownSample& sample : plan_.crown) {
    if (!need(sample.primitive, v)) return;
    // Whoever is reached at both ends of its samples is reached between them.
    const auto y = sample.candidate ? plainOrdinate(sample.primitive, sample.xMm)
                                    : ordinateAt(pieces_[sample.primitive], sample.xMm);
    if (!y) {
      v.reason = "points do not reach x = " + number(sample.xMm) + " from the axis";
      return;
    }
    const double deviation = *y - crownHeight_->value - sample.nominalDropMm;
    if (deviation > high) high = deviation, highest = &sample;
    if (deviation < low) low = deviation, lowest = &sample;
  }
  v.value = crownDeviation(*highest);
  v.second = crownDeviation(*lowest);
  for (const CrownSample& sample : plan_.crown)
    if (sample.candidate) v.candidates.push_back(crownDeviation(sample));
  for (const CrownSample* sample : {highest, lowest})
    anchor(v, sample->xMm, *ordinateAt(pieces_[sample->primitive], sample->xMm));
}

/// A head alone gives its width too: without the foot the registered head says which way the base line runs, and the
/// width hardly depends on it (one part in 10,000 a degree).
void Definitions::headWidth(Value& v, double depth) const {
  if (!needCrown(v)) return;
  const auto left = headSide(kLeft, depth, v);
  if (!left) return;
  const auto right = headSide(kRight, depth, v);
  if (!right) return;
  v.value = *right - *left;
  anchor(v, left->value, crownHeight_->value - depth);
  anchor(v, right->value, crownHeight_->value - depth);
}

void Definitions::footThickness(Value& v, std::size_t side, double inside) const {
  if (!needBaseLine(v) || !need(plan_.footTop[side], v)) return;
  v.used.set(plan_.footBottom);
  v.used.set(plan_.footEdge[side]);
  const Reading x = edge_[side] + (side == kLeft ? inside : -inside);
  const auto top = ordinate(plan_.footTop[side], x, &v);
  if (!top) return;
  const Reading bottom = footBottomHeight(x);
  v.value = *top - bottom;
  anchor(v, x.value, bottom.value);
  anchor(v, x.value, top->value);
}

void Definitions::asymmetry(Value& v, std::size_t side, double depth) const {
  if (!needBaseLine(v) || !needCrown(v) || !need(plan_.footEdge[side], v)) return;
  const auto head = headSide(side, depth, v);
  if (!head) return;
  v.value = side == kLeft ? *head - edge_[kLeft] : edge_[kRight] - *head;
  anchor(v, edge_[side].value, crownHeight_->value - depth);
  anchor(v, head->value, crownHeight_->value - depth);
}

void Definitions::webThickness(Value& v) const {
  if (!plan_.webHeightMm) {
    v.reason = "the section has no web";
    return;
  }
  if (!needBaseLine(v)) return;
  for (const std::size_t side : {kLeft, kRight})
    for (const std::size_t p : plan_.web[side])
      if (!need(p, v)) return;
  const double y = *plan_.webHeightMm;
  const auto left = webFace(kLeft, y), right = webFace(kRight, y);
  if (!left || !right) {
    v.reason = "points do not reach " + number(y) + " above the base line";
    return;
  }
  v.value = *right - *left;
  anchor(v, left->value, y);
  anchor(v, right->value, y);
  double thinnest = y, least = v.value->value;
  for (const double step : {1.0, -1.0})
    for (double h = y + step;; h += step) {
      const auto l = plainWebFace(kLeft, h), r = plainWebFace(kRight, h);
      if (!l || !r) break;
      if (*r - *l < least) least = *r - *l, thinnest = h;
    }
  v.second = *webFace(kRight, thinnest) - *webFace(kLeft, thinnest);
}

void Definitions::headRadius(Value& v) const {
  if (!need(plan_.headTop, v)) return;
  const double k = pieces_[plan_.headTop].curvature;
  if (!(k > 1e-5)) {
    v.reason = "the crown is flat";
    return;
  }
  Reading radius(1 / k);
  radius.move(moverOf(plan_.headTop), -1 / (k * k), {0, 0, 0, 1});
  v.value = radius;
}

void Definitions::footConcavity(Value& v) const {
  if (!needBaseLine(v) || !need(plan_.footBottom, v)) return;
  const Reading middle = (edge_[kLeft] + edge_[kRight]) * 0.5;
  v.value = footBottomHeight(middle);
  anchor(v, middle.value, 0);
  anchor(v, middle.value, v.value->value);
}

}  // namespace vignole
