#include "engine/measurement/definitions.h"

#include <cstdio>

namespace vignole {
namespace {

void anchor(DefinedValue& v, double x, double y) { v.anchors[v.anchorCount++] = {x, y}; }

std::string number(double mm) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g mm", mm);
  return text;
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

// ---- needs ----

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
