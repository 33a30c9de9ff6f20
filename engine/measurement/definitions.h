#pragma once
// The definitions of rails.md, written once: evaluated with double on a section's own primitives (nominals) and with
// Dual on primitives fitted to data (measured values with their gradients).

#include <array>
#include <bitset>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "engine/measurement/curve_piece.h"
#include "engine/measurement/section_plan.h"

namespace vignole {

inline constexpr std::size_t kMaxPrimitives = 256;
using PrimitiveSet = std::bitset<kMaxPrimitives>;

/// Foot bottom y = c0 + c1 x + c2 x^2 in the frame of the shapes.
template <typename T>
struct Parabola {
  T c0{}, c1{}, c2{};
  [[nodiscard]] T at(const T& x) const { return c0 + x * (c1 + x * c2); }
};

/// What a section or the data are made of; indices are those of Section::primitives.
template <typename T>
struct Shapes {
  std::vector<CurvePiece<T>> pieces;
  std::vector<std::string> missing;  ///< per primitive: empty, or why there is no piece: "no points on SBL"
  Parabola<T> footBottom;
};

/// One dimension as evaluated; HF carries its extremes and the ends of the crown, WT the smallest distance as `second`.
template <typename T>
struct DefinedValue {
  std::optional<T> value;
  std::optional<T> second;
  T left{}, right{};
  bool hasParts = false;
  /// HF: deviation at the ends of the compared width and on both sides of every change from one fit to another: where
  /// an extreme may lie besides where it was found.
  std::vector<T> candidates;
  std::string reason;  ///< why there is no value
  PrimitiveSet used;
  std::array<Vec<double>, 4> anchors{};  ///< datum frame
  std::size_t anchorCount = 0;
};

/// Base line and axis: origin where they meet, unit vector along the base line, both in the frame of the shapes.
template <typename T>
struct Datum {
  Vec<T> origin;
  Vec<T> along{T(1), T(0)};
  bool fromFoot = false;    ///< false: the foot is missing and the frame of the shapes stands in
  std::string reason;       ///< what of the foot is missing
  std::array<T, 2> edge{};  ///< abscissa of the foot edges at their mid height
};

template <typename T>
class Definitions {
 public:
  /// `jointSlackMm`: how far a fitted joint may lie from where the section has it, before a point beside it is refused.
  Definitions(const SectionPlan& plan, const DimensionParameters& parameters, double jointSlackMm)
      : plan_(plan), parameters_(parameters), jointSlackMm_(jointSlackMm) {}

  /// All thirteen; `values` is reused from call to call.
  void evaluate(const Shapes<T>& shapes, PerDimension<DefinedValue<T>>& values) {
    shapes_ = &shapes;
    findDatum();
    moveIntoDatum();
    for (auto& v : values) {
      v.value.reset();
      v.second.reset();
      v.hasParts = false;
      v.reason.clear();
      v.used.reset();
      v.anchorCount = 0;
      v.candidates.clear();
    }
    crownHeight_ = ordinate(plan_.crownOnAxis, T(0), nullptr);
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
  }
  [[nodiscard]] const Datum<T>& datum() const { return datum_; }

 private:
  using Value = DefinedValue<T>;

  void findDatum() {
    datum_ = Datum<T>{};
    for (const std::size_t p : {plan_.footBottom, plan_.footEdge[kLeft], plan_.footEdge[kRight]})
      if (!shapes_->missing[p].empty()) {
        datum_.reason = shapes_->missing[p];
        return;
      }
    // The edges are read at a height above the base line, and the base line 5 mm inside the edges: three rounds settle.
    for (int round = 0; round < 3; ++round) {
      std::array<T, 2> edge;
      if (!readEdges(edge)) return;
      Vec<T> left = footBottomPoint(edge[kLeft] + parameters_.baseInsetMm);
      const Vec<T> right = footBottomPoint(edge[kRight] - parameters_.baseInsetMm);
      using std::sqrt;
      const T dx = right.x - left.x, dy = right.y - left.y, span = sqrt(dx * dx + dy * dy);
      datum_.along = {dx / span, dy / span};
      datum_.origin = left;
    }
    std::array<T, 2> edge;
    if (!readEdges(edge)) return;
    const T axis = (edge[kLeft] + edge[kRight]) * 0.5 + plan_.axisFromFootMiddleMm;
    datum_.origin.x = datum_.origin.x + datum_.along.x * axis;
    datum_.origin.y = datum_.origin.y + datum_.along.y * axis;
    datum_.edge = {edge[kLeft] - axis, edge[kRight] - axis};
    datum_.fromFoot = true;
  }
  bool readEdges(std::array<T, 2>& edge) {
    for (const std::size_t side : {kLeft, kRight}) {
      const auto x = abscissaAt(inDatum(shapes_->pieces[plan_.footEdge[side]]), T(plan_.footEdgeMidHeightMm[side]));
      if (!x) {
        datum_.reason = "the foot edge is not upright";
        return false;
      }
      edge[side] = *x;
    }
    return true;
  }
  /// The foot bottom met by the perpendicular to the base line at abscissa x of the datum, in the frame of the shapes.
  [[nodiscard]] Vec<T> footBottomPoint(const T& x) const {
    T X = datum_.origin.x + datum_.along.x * x;
    T Y = shapes_->footBottom.at(X);
    for (int round = 0; round < 2; ++round) {  // the perpendicular leans by less than a degree: two rounds are exact
      const T height = (Y - datum_.origin.y - datum_.along.y * x) * datum_.along.x -
                       (X - datum_.origin.x - datum_.along.x * x) * datum_.along.y;
      X = datum_.origin.x + datum_.along.x * x - datum_.along.y * height;
      Y = shapes_->footBottom.at(X);
    }
    return {X, Y};
  }
  [[nodiscard]] CurvePiece<T> inDatum(const CurvePiece<T>& piece) const {
    return {toFrame(datum_.origin, datum_.along, piece.origin), toFrame(Vec<T>{}, datum_.along, piece.tangent),
            piece.curvature, piece.fromMm, piece.toMm};
  }
  void moveIntoDatum() {
    const std::size_t n = shapes_->pieces.size();
    pieces_.resize(n);
    for (std::size_t p = 0; p < n; ++p)
      if (shapes_->missing[p].empty()) pieces_[p] = inDatum(shapes_->pieces[p]);
  }

  [[nodiscard]] bool present(std::size_t primitive) const { return shapes_->missing[primitive].empty(); }
  bool need(std::size_t primitive, Value& v) const {
    v.used.set(primitive);
    if (present(primitive)) return true;
    v.reason = shapes_->missing[primitive];
    return false;
  }
  bool needBaseLine(Value& v) const {
    if (datum_.fromFoot) return true;
    v.reason = "no base line: " + datum_.reason;
    return false;
  }
  static bool reaches(const CurvePiece<T>& piece, double x, double y, double slack = 0) {
    const double s = arcPosition(piece, x, y);
    return s >= piece.fromMm - slack - 1e-6 && s <= piece.toMm + slack + 1e-6;
  }
  static std::string number(double mm) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g mm", mm);
    return text;
  }
  std::optional<T> ordinate(std::size_t primitive, const T& x, Value* v) const {
    if (!present(primitive)) {
      if (v != nullptr) v->reason = shapes_->missing[primitive];
      return std::nullopt;
    }
    const auto y = ordinateAt(pieces_[primitive], x);
    if (y && reaches(pieces_[primitive], valueOf(x), valueOf(*y), jointSlackMm_)) return y;
    if (v != nullptr) v->reason = "points do not reach x = " + number(valueOf(x)) + " from the axis";
    return std::nullopt;
  }
  static void anchor(Value& v, double x, double y) { v.anchors[v.anchorCount++] = {x, y}; }

  bool needCrown(Value& v) const {
    if (!need(plan_.crownOnAxis, v)) return false;
    if (crownHeight_) return true;
    v.reason = "points do not reach the crown on the axis";
    return false;
  }
  /// Abscissa of the head's side `depth` below the crown on the axis.
  std::optional<T> headSide(std::size_t side, double depth, Value& v) const {
    const T y = *crownHeight_ - depth;
    std::string missing;
    for (const std::size_t p : plan_.headSide[side]) {
      if (!present(p)) {
        if (missing.empty()) missing = shapes_->missing[p];
        continue;
      }
      const auto x = abscissaAt(pieces_[p], y);
      if (!x || !reaches(pieces_[p], valueOf(*x), valueOf(y))) continue;
      v.used.set(p);
      return x;
    }
    v.reason = missing.empty() ? "points do not reach " + number(depth) + " below the crown" : missing;
    return std::nullopt;
  }

  void railHeight(Value& v) const {
    if (!needBaseLine(v) || !needCrown(v)) return;
    v.value = crownHeight_;
    v.used.set(plan_.footBottom);
    anchor(v, 0, 0);
    anchor(v, 0, valueOf(*crownHeight_));
  }
  void fishingHeight(Value& v) const {
    if (!needBaseLine(v)) return;
    const std::array<double, 2> x = {-parameters_.rfhFromAxisMm.left, parameters_.rfhFromAxisMm.right};
    std::array<T, 2> height;
    for (const std::size_t side : {kLeft, kRight}) {
      const std::size_t upper = plan_.fishingUpper[side], lower = plan_.fishingLower[side];
      if (!need(upper, v) || !need(lower, v)) return;
      const auto top = ordinate(upper, T(x[side]), &v), bottom = ordinate(lower, T(x[side]), &v);
      if (!top || !bottom) return;
      height[side] = *top - *bottom;
      anchor(v, x[side], valueOf(*bottom));
      anchor(v, x[side], valueOf(*top));
    }
    v.left = height[kLeft];
    v.right = height[kRight];
    v.hasParts = true;
    v.value = (height[kLeft] + height[kRight]) * 0.5;
  }
  void footWidth(Value& v) const {
    if (!needBaseLine(v) || !need(plan_.footEdge[kLeft], v) || !need(plan_.footEdge[kRight], v)) return;
    v.value = datum_.edge[kRight] - datum_.edge[kLeft];
    anchor(v, valueOf(datum_.edge[kLeft]), plan_.footEdgeMidHeightMm[kLeft]);
    anchor(v, valueOf(datum_.edge[kRight]), plan_.footEdgeMidHeightMm[kRight]);
  }
  [[nodiscard]] std::optional<T> crownDeviation(const CrownSample& sample, Value& v) const {
    const auto y = ordinate(sample.primitive, T(sample.xMm), &v);
    if (!y) return std::nullopt;
    return *y - *crownHeight_ - sample.nominalDropMm;
  }
  void headForm(Value& v) {
    if (!needBaseLine(v) || !needCrown(v)) return;
    std::size_t highest = 0, lowest = 0;
    double high = -1e300, low = 1e300;
    for (std::size_t k = 0; k < plan_.crown.size(); ++k) {
      const CrownSample& sample = plan_.crown[k];
      if (!need(sample.primitive, v)) return;
      const CurvePiece<double> piece = plain(pieces_[sample.primitive]);
      const auto y = ordinateAt(piece, sample.xMm);
      if (!y || !reaches(pieces_[sample.primitive], sample.xMm, *y, jointSlackMm_)) {
        v.reason = "points do not reach x = " + number(sample.xMm) + " from the axis";
        return;
      }
      const double deviation = *y - valueOf(*crownHeight_) - sample.nominalDropMm;
      if (deviation > high) high = deviation, highest = k;
      if (deviation < low) low = deviation, lowest = k;
    }
    v.value = crownDeviation(plan_.crown[highest], v);
    v.second = crownDeviation(plan_.crown[lowest], v);
    for (std::size_t k = 0; k < plan_.crown.size(); ++k)
      if (plan_.crown[k].candidate) v.candidates.push_back(*crownDeviation(plan_.crown[k], v));
    for (const CrownSample* sample : {&plan_.crown[highest], &plan_.crown[lowest]})
      anchor(v, sample->xMm, *ordinateAt(plain(pieces_[sample->primitive]), sample->xMm));
  }
  static CurvePiece<double> plain(const CurvePiece<T>& p) {
    return {{valueOf(p.origin.x), valueOf(p.origin.y)},
            {valueOf(p.tangent.x), valueOf(p.tangent.y)},
            valueOf(p.curvature),
            p.fromMm,
            p.toMm};
  }
  /// A head alone gives its width too: without the foot the registered head says which way the base line runs, and the
  /// width hardly depends on it (one part in 10,000 a degree).
  void headWidth(Value& v, double depth) const {
    if (!needCrown(v)) return;
    const auto left = headSide(kLeft, depth, v);
    if (!left) return;
    const auto right = headSide(kRight, depth, v);
    if (!right) return;
    v.value = *right - *left;
    anchor(v, valueOf(*left), valueOf(*crownHeight_) - depth);
    anchor(v, valueOf(*right), valueOf(*crownHeight_) - depth);
  }
  void footThickness(Value& v, std::size_t side, double inside) const {
    if (!needBaseLine(v) || !need(plan_.footTop[side], v)) return;
    v.used.set(plan_.footBottom);
    v.used.set(plan_.footEdge[side]);
    const T x = side == kLeft ? datum_.edge[kLeft] + inside : datum_.edge[kRight] - inside;
    const auto top = ordinate(plan_.footTop[side], x, &v);
    if (!top) return;
    const T bottom = footBottomHeight(x);
    v.value = *top - bottom;
    anchor(v, valueOf(x), valueOf(bottom));
    anchor(v, valueOf(x), valueOf(*top));
  }
  [[nodiscard]] T footBottomHeight(const T& x) const {
    return toFrame(datum_.origin, datum_.along, footBottomPoint(x)).y;
  }
  void asymmetry(Value& v, std::size_t side, double depth) const {
    if (!needBaseLine(v) || !needCrown(v) || !need(plan_.footEdge[side], v)) return;
    const auto head = headSide(side, depth, v);
    if (!head) return;
    v.value = side == kLeft ? *head - datum_.edge[kLeft] : datum_.edge[kRight] - *head;
    anchor(v, valueOf(datum_.edge[side]), valueOf(*crownHeight_) - depth);
    anchor(v, valueOf(*head), valueOf(*crownHeight_) - depth);
  }
  [[nodiscard]] std::optional<T> webFace(std::size_t side, const T& y) const {
    for (const std::size_t p : plan_.web[side]) {
      if (!present(p)) continue;
      const auto x = abscissaAt(pieces_[p], y);
      if (x && reaches(pieces_[p], valueOf(*x), valueOf(y))) return x;
    }
    return std::nullopt;
  }
  [[nodiscard]] std::optional<double> plainWebFace(std::size_t side, double y) const {
    for (const std::size_t p : plan_.web[side]) {
      if (!present(p)) continue;
      const auto x = abscissaAt(plain(pieces_[p]), y);
      if (x && reaches(pieces_[p], *x, y)) return x;
    }
    return std::nullopt;
  }
  void webThickness(Value& v) const {
    if (!plan_.webHeightMm) {
      v.reason = "the section has no web";
      return;
    }
    if (!needBaseLine(v)) return;
    for (const std::size_t side : {kLeft, kRight})
      for (const std::size_t p : plan_.web[side])
        if (!need(p, v)) return;
    const T y(*plan_.webHeightMm);
    const auto left = webFace(kLeft, y), right = webFace(kRight, y);
    if (!left || !right) {
      v.reason = "points do not reach " + number(*plan_.webHeightMm) + " above the base line";
      return;
    }
    v.value = *right - *left;
    anchor(v, valueOf(*left), *plan_.webHeightMm);
    anchor(v, valueOf(*right), *plan_.webHeightMm);
    double thinnest = *plan_.webHeightMm, least = valueOf(*v.value);
    for (const double step : {1.0, -1.0})
      for (double h = *plan_.webHeightMm + step;; h += step) {
        const auto l = plainWebFace(kLeft, h), r = plainWebFace(kRight, h);
        if (!l || !r) break;
        if (*r - *l < least) least = *r - *l, thinnest = h;
      }
    const auto l = webFace(kLeft, T(thinnest)), r = webFace(kRight, T(thinnest));
    if (l && r) v.second = *r - *l;
  }
  void headRadius(Value& v) const {
    if (!need(plan_.headTop, v)) return;
    const T& k = pieces_[plan_.headTop].curvature;
    if (!(valueOf(k) > 1e-5)) {
      v.reason = "the crown is flat";
      return;
    }
    v.value = 1.0 / k;
  }
  void footConcavity(Value& v) const {
    if (!needBaseLine(v) || !need(plan_.footBottom, v)) return;
    const T middle = (datum_.edge[kLeft] + datum_.edge[kRight]) * 0.5;
    v.value = footBottomHeight(middle);
    anchor(v, valueOf(middle), 0);
    anchor(v, valueOf(middle), valueOf(*v.value));
  }

  const SectionPlan& plan_;
  const DimensionParameters& parameters_;
  double jointSlackMm_;
  const Shapes<T>* shapes_ = nullptr;
  std::vector<CurvePiece<T>> pieces_;
  Datum<T> datum_;
  std::optional<T> crownHeight_;
};

}  // namespace vignole
