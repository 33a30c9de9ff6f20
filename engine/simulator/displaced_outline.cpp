#include "engine/simulator/displaced_outline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace vignole::simulator {

namespace {

std::optional<double> yAt(const Primitive& primitive, double x, bool upper) {
  const auto hits = intersectLine(primitive, {x, 0}, {0, 1});
  if (hits.empty()) return {};
  return upper ? hits.back().y() : hits.front().y();
}

std::optional<double> xAt(const Primitive& primitive, double y) {
  const auto hits = intersectLine(primitive, {0, y}, {1, 0});
  if (hits.empty()) return {};
  return hits.front().x();
}

Primitive shifted(const Primitive& primitive, const Point2& by) {
  return transformed(Transform2{by.x(), by.y(), 0}, primitive);
}

double cross(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }
Point2 leftOf(const Point2& v) { return {-v.y(), v.x()}; }

double angleOf(const Point2& v) { return std::atan2(v.y(), v.x()); }

/// Arc about a centre from one point to another, turning left (+1) or right (-1), less than a full turn.
Arc arcBetween(const Point2& centre, const Point2& from, const Point2& to, double turn) {
  Arc arc;
  arc.centre = centre;
  arc.radiusMm = (from - centre).norm();
  arc.startAngleRad = angleOf(from - centre);
  double sweep = turn * (angleOf(to - centre) - arc.startAngleRad);
  while (sweep < 0) sweep += 2 * M_PI;
  while (sweep >= 2 * M_PI) sweep -= 2 * M_PI;
  arc.sweepRad = turn * sweep;
  return arc;
}

Primitive reversed(const Arc& arc) {
  Arc back = arc;
  back.startAngleRad = arc.startAngleRad + arc.sweepRad;
  back.sweepRad = -arc.sweepRad;
  return back;
}

/// y of the crown at x, from the pieces that lie there.
std::optional<double> crownY(const std::vector<OutlinePiece>& pieces, const std::vector<std::size_t>& candidates,
                             double x) {
  for (const std::size_t i : candidates)
    if (const auto y = yAt(pieces[i].base, x, true)) return y;
  return {};
}

}  // namespace

Point2 OutlinePiece::at(double share) const {
  Point2 point = pointAt(base, share * length(base));
  if (!carried) return point;
  const double t = from + share * (to - from), t2 = t * t, t3 = t2 * t;
  return point + (2 * t3 - 3 * t2 + 1) * d0 + (t3 - 2 * t2 + t) * m0 + (3 * t2 - 2 * t3) * d1 + (t3 - t2) * m1;
}

Expected<OutlineShaper> OutlineShaper::create(const Section& section, const DimensionParameters& parameters) {
  OutlineShaper shaper;
  shaper.section_ = section;
  shaper.parameters_ = parameters;
  if (auto found = shaper.findParts(); !found) return tl::unexpected<Error>(found.error());
  return shaper;
}

Expected<void> OutlineShaper::findParts() {
  const auto bottom = section_.find("SBB"), top = section_.find("AHT");
  if (!bottom || !top || !std::holds_alternative<Arc>(section_.primitives[*top].shape))
    return inputError("section " + section_.name, "has no SBB or no arc AHT; the virtual rig cannot steer it");
  bottom_ = *bottom;
  top_ = *top;
  for (const auto& [letter, side] : {std::pair{'R', &right_}, std::pair{'L', &left_}}) {
    auto found = findSide(letter);
    if (!found) return tl::unexpected<Error>(found.error());
    *side = *std::move(found);
  }
  axisX_ = (edgeX(right_) + edgeX(left_)) / 2 + section_.axisFromFootMiddleMm;
  // The waist: where the nominal web is thinnest, the middle of a straight part.
  const double low = std::max(startPoint(section_.primitives[right_.lowerFishing].shape).y(),
                              endPoint(section_.primitives[right_.lowerFishing].shape).y());
  const double high = endPoint(section_.primitives[right_.upperFishing].shape).y();
  const auto thickness = [&](double y) -> std::optional<double> {
    std::optional<double> r, l;
    for (const std::size_t i : walk(right_.lowerFishing, right_.upperFishing, 1))
      if (auto x = xAt(section_.primitives[i].shape, y)) r = x;
    for (const std::size_t i : walk(left_.lowerFishing, left_.upperFishing, -1))
      if (auto x = xAt(section_.primitives[i].shape, y)) l = x;
    if (!r || !l) return {};
    return *r - *l;
  };
  double thinnest = 1e9, first = 0, last = 0;
  constexpr double kStepMm = 0.05;
  const int steps = static_cast<int>(std::ceil((high - low) / kStepMm));
  for (int i = 0; i < steps; ++i) {
    const double y = low + kStepMm * i;
    if (const auto t = thickness(y)) {
      if (*t < thinnest - 1e-6) thinnest = *t, first = y;
      if (*t < thinnest + 1e-6) last = y;
    }
  }
  waistY_ = parameters_.wtHeightMm.value_or((first + last) / 2);
  for (Side* side : {&right_, &left_})
    for (const std::size_t i : walk(side->lowerFishing, side->upperFishing, side->sign)) {
      const double a = startPoint(section_.primitives[i].shape).y(), b = endPoint(section_.primitives[i].shape).y();
      if (std::min(a, b) < waistY_ + 1 && std::max(a, b) > waistY_ - 1) side->web.push_back(i);
    }
  return {};
}

/// Indices strictly between two primitives, going up the side: with the outline on the right, against it on the left.
std::vector<std::size_t> OutlineShaper::walk(std::size_t from, std::size_t to, double sign) const {
  std::vector<std::size_t> between;
  const std::size_t n = section_.primitives.size();
  for (std::size_t i = from; i != to;) {
    i = sign > 0 ? (i + 1) % n : (i + n - 1) % n;
    if (i != to) between.push_back(i);
  }
  return between;
}

double OutlineShaper::edgeX(const Side& side) const {
  const Primitive& edge = section_.primitives[side.edge].shape;
  return (startPoint(edge).x() + endPoint(edge).x()) / 2;
}

CrownLatitude OutlineShaper::latitude() const {
  const Primitive& top = section_.primitives[top_].shape;
  const double radius = std::get<Arc>(top).radiusMm;
  const double half = length(top) / 2;
  CrownLatitude latitude{1, 2 * 0.0035 * radius * radius / (half * half)};
  for (const Side* side : {&right_, &left_}) {
    if (side->crown.size() != 2) latitude.hfShare = 0;
    if (side->crown.empty()) continue;
    const Point2 join = side->sign > 0 ? startPoint(top) : endPoint(top);
    const double p = side->sign > 0 ? parameters_.hfHalfWidthMm.right : parameters_.hfHalfWidthMm.left;
    const double reach = p - side->sign * (join.x() - axisX_);
    const double share = reach / length(section_.primitives[side->crown.front()].shape);
    latitude.hfShare = std::min(latitude.hfShare, share > 0 ? share * share : 0);
  }
  return latitude;
}

Expected<OutlineShaper::Side> OutlineShaper::findSide(char letter) const {
  Side side;
  side.sign = letter == 'R' ? 1 : -1;
  const auto need = [&](std::string name, std::size_t& at) -> Expected<void> {
    name += letter;
    const auto found = section_.find(name);
    if (!found) return inputError("section " + section_.name, "has no " + name + "; the virtual rig cannot steer it");
    at = *found;
    return {};
  };
  for (const auto& [name, at] : {std::pair{"SB", &side.edge}, std::pair{"SWB", &side.lowerFishing},
                                 std::pair{"SHB", &side.upperFishing}, std::pair{"SH", &side.headSide}})
    if (auto found = need(name, *at); !found) return tl::unexpected<Error>(found.error());
  if (!std::holds_alternative<Segment>(section_.primitives[side.headSide].shape))
    return inputError("section " + section_.name, "has a head side that is no segment");

  side.crown = walk(side.headSide, top_, side.sign);
  std::reverse(side.crown.begin(), side.crown.end());

  // The foot top moves as one from its first straight part to the primitive on which FT is taken. If that touches the
  // fishing surface, this moves along and RFH is kept by moving the upper fishing surface, too.
  const double inside = letter == 'R' ? parameters_.ftInsideMm.right : parameters_.ftInsideMm.left;
  const double x = edgeX(side) - side.sign * inside;
  std::vector<std::size_t> top = walk(side.edge, side.lowerFishing, side.sign);
  top.push_back(side.lowerFishing);
  const auto at = std::find_if(top.begin(), top.end(),
                               [&](std::size_t i) { return yAt(section_.primitives[i].shape, x, true).has_value(); });
  if (at == top.end())
    return inputError("section " + section_.name,
                      "has no foot top " + std::to_string(inside) + " mm inside its edge, where FT is to be taken");
  auto first = std::find_if(top.begin(), at, [&](std::size_t i) { return section_.primitives[i].name.front() == 'S'; });
  auto last = at + 1;
  if (last != top.end() && *last == side.lowerFishing) ++last;
  side.footTop.assign(first, last);
  return side;
}

Expected<std::vector<OutlinePiece>> OutlineShaper::displaced(const OutlineDeviation& deviation) const {
  std::vector<OutlinePiece> pieces(section_.primitives.size());
  std::vector<char> placed(pieces.size(), 0);
  for (std::size_t i = 0; i < pieces.size(); ++i) pieces[i].base = section_.primitives[i].shape;

  // Foot bottom: a parabola that meets y = 0 where the base line is taken, so that the base line stays y = 0.
  const double widen = deviation.mm[index(Dimension::FW)] / 2;
  const double middle = (edgeX(right_) + edgeX(left_)) / 2;
  const double reach = (edgeX(right_) - edgeX(left_)) / 2 + widen - parameters_.baseInsetMm;
  const double rise = deviation.mm[index(Dimension::FC)];
  const auto bottomAt = [&](double x) { return rise * (1 - (x - middle) * (x - middle) / (reach * reach)); };
  const auto slopeAt = [&](double x) { return -2 * rise * (x - middle) / (reach * reach); };
  OutlinePiece& bottom = pieces[bottom_];
  const Point2 from = startPoint(bottom.base), to = endPoint(bottom.base);
  bottom.carried = true;
  bottom.d0 = {0, bottomAt(from.x())};
  bottom.d1 = {0, bottomAt(to.x())};
  bottom.m0 = {0, slopeAt(from.x()) * (to.x() - from.x())};
  bottom.m1 = {0, slopeAt(to.x()) * (to.x() - from.x())};
  placed[bottom_] = 1;

  for (const Side* side : {&right_, &left_}) {
    const double inside = side->sign > 0 ? parameters_.ftInsideMm.right : parameters_.ftInsideMm.left;
    moveSide(*side, deviation, bottomAt(edgeX(*side) + side->sign * (widen - inside)), pieces, placed);
  }

  // Crown: the arc AHT with its own radius through the raised point on the axis.
  const Arc nominal = std::get<Arc>(section_.primitives[top_].shape);
  Arc top = nominal;
  top.radiusMm += deviation.mm[index(Dimension::HR)];
  const double off = axisX_ - nominal.centre.x();
  if (top.radiusMm <= std::abs(off) + 1)
    return inputError("deviation HR", "leaves no radius of the crown; choose a smaller one");
  const auto above = [&](double radius) { return std::sqrt(radius * radius - off * off); };
  top.centre.y() += deviation.mm[index(Dimension::RH)] + above(nominal.radiusMm) - above(top.radiusMm);
  const double middleAngle = nominal.startAngleRad + nominal.sweepRad / 2;
  top.sweepRad = nominal.sweepRad * nominal.radiusMm / top.radiusMm;
  top.startAngleRad = middleAngle - top.sweepRad / 2;
  pieces[top_].base = top;
  placed[top_] = 1;
  for (const Side* side : {&right_, &left_}) {
    if (auto joined = joinHead(*side, deviation, pieces); !joined) return tl::unexpected<Error>(joined.error());
    for (std::size_t k = carriesShoulder(*side) ? 1 : 0; k < side->crown.size(); ++k) placed[side->crown[k]] = 1;
  }
  carryTheRest(pieces, placed);
  return pieces;
}

void OutlineShaper::moveSide(const Side& side, const OutlineDeviation& deviation, double bottomMm,
                             std::vector<OutlinePiece>& pieces, std::vector<char>& placed) const {
  const auto& mm = deviation.mm;
  const auto move = [&](std::size_t i, const Point2& by) {
    pieces[i].base = shifted(section_.primitives[i].shape, by);
    placed[i] = 1;
  };
  const double widen = side.sign * mm[index(Dimension::FW)] / 2;
  move(side.edge, {widen, 0});
  // The foot top goes with its edge, or FT would change with FW on the slope.
  const Point2 footTop(widen, mm[index(side.sign > 0 ? Dimension::FTr : Dimension::FTl)] + bottomMm);
  move(side.lowerFishing, {0, 0});
  double lowerRise = 0;
  for (const std::size_t i : side.footTop) {
    move(i, footTop);
    if (i != side.lowerFishing) continue;
    const Point2 along = tangentAt(section_.primitives[i].shape, 0);
    lowerRise = footTop.y() - footTop.x() * along.y() / along.x();
  }
  move(side.upperFishing, {0, mm[index(Dimension::RFH)] + lowerRise});
  for (const std::size_t i : side.web) move(i, {side.sign * mm[index(Dimension::WT)] / 2, 0});
  placed[side.headSide] = 1;  // by joinHead
}

double OutlineShaper::summitY() const {
  const Arc& top = std::get<Arc>(section_.primitives[top_].shape);
  const double off = axisX_ - top.centre.x();
  return top.centre.y() + std::sqrt(top.radiusMm * top.radiusMm - off * off);
}

/// x of the head's side at the depth where its width is measured: on the straight side or on an arc above it.
std::optional<double> OutlineShaper::headX(const Side& side, const std::vector<OutlinePiece>& pieces, double y) const {
  if (const auto x = xAt(pieces[side.headSide].base, y)) return x;
  for (const std::size_t i : side.crown) {
    const auto hits = intersectLine(pieces[i].base, {0, y}, {1, 0});
    if (!hits.empty()) return side.sign > 0 ? hits.back().x() : hits.front().x();
  }
  return {};
}

/// The head side where its width asks for it: where that is taken on an arc, the arc depends on the side and the side
/// has to be found.
Expected<void> OutlineShaper::joinHead(const Side& side, const OutlineDeviation& deviation,
                                       std::vector<OutlinePiece>& pieces) const {
  const auto& mm = deviation.mm;
  std::vector<OutlinePiece> nominal(section_.primitives.size());
  for (std::size_t i = 0; i < nominal.size(); ++i) nominal[i].base = section_.primitives[i].shape;
  const double depthY = summitY() - (deviation.headAtArema ? parameters_.hwaDepthMm : parameters_.hwDepthMm);
  const auto nominalX = headX(side, nominal, depthY);
  const double wanted = side.sign * mm[index(Dimension::HW)] / 2 + deviation.headShiftMm;
  if (carriesShoulder(side)) {
    const Point2 by(wanted, mm[index(Dimension::RH)]);
    pieces[side.headSide].base = shifted(section_.primitives[side.headSide].shape, by);
    for (std::size_t k = 1; k < side.crown.size(); ++k)
      pieces[side.crown[k]].base = shifted(section_.primitives[side.crown[k]].shape, by);
    return {};
  }
  double shift = wanted;
  for (int round = 0; round < 20; ++round) {
    pieces[side.headSide].base = shifted(section_.primitives[side.headSide].shape, {shift, mm[index(Dimension::RH)]});
    if (auto bent = bendCrown(side, deviation, pieces); !bent) return bent;
    const auto x = headX(side, pieces, depthY + mm[index(Dimension::RH)]);
    if (!x || !nominalX) return {};  // the depth is off the head: nothing to hold
    const double miss = *nominalX + wanted - *x;
    if (std::abs(miss) < 1e-7) break;
    shift += miss;
  }
  return {};
}

/// Changes the curvature beside AHT so that the crown has the wanted deviation where HF ends; then re-joins the rest.
Expected<void> OutlineShaper::bendCrown(const Side& side, const OutlineDeviation& deviation,
                                        std::vector<OutlinePiece>& pieces) const {
  const auto& mm = deviation.mm;
  const auto failed = [&]() {
    return inputError("section " + section_.name,
                      "has no tangent crown with these deviations of RH, HF, HR and HW; choose smaller ones");
  };
  std::vector<std::size_t> crown = side.crown;
  crown.push_back(top_);
  const double halfWidth = side.sign > 0 ? parameters_.hfHalfWidthMm.right : parameters_.hfHalfWidthMm.left;
  const double x = axisX_ + side.sign * halfWidth;
  std::vector<OutlinePiece> nominal(section_.primitives.size());
  for (const std::size_t i : crown) nominal[i].base = section_.primitives[i].shape;
  const auto nominalY = crownY(nominal, crown, x);
  if (side.crown.size() < 2 || !nominalY) {
    if (!buildCrown(side, 0, pieces)) return failed();
    return {};
  }
  const double target = *nominalY + mm[index(Dimension::RH)] + mm[index(Dimension::HF)];
  const auto miss = [&](double extra) -> std::optional<double> {
    if (!buildCrown(side, extra, pieces)) return {};
    const auto y = crownY(pieces, crown, x);
    if (!y) return {};
    return *y - target;
  };
  // Secant; the height falls almost linearly with the curvature.
  double a = 1e-4, b = 0;
  auto fa = miss(a), fb = miss(b);
  for (int step = 0; step < 30 && fa && fb && std::abs(*fb) > 1e-9 && *fb != *fa; ++step) {
    const double c = b - *fb * (b - a) / (*fb - *fa);
    a = b;
    fa = fb;
    b = c;
    fb = miss(b);
  }
  if (!fb || std::abs(*fb) > 1e-6) return failed();
  return {};
}

/// From AHT outwards: each arc starts tangent where the last ended; the last one keeps its radius and is put tangent
/// between the arc before it and the head side, both of which end where it touches them.
bool OutlineShaper::buildCrown(const Side& side, double extraCurvature, std::vector<OutlinePiece>& pieces) const {
  // Going outwards is against the outline's sense on the right and with it on the left.
  const auto outward = [&](const Arc& arc) { return side.sign > 0 ? std::get<Arc>(reversed(arc)) : arc; };
  const auto store = [&](std::size_t i, const Arc& arc) { pieces[i].base = outward(arc); };
  Arc before = outward(std::get<Arc>(pieces[top_].base));
  std::size_t beforeIndex = top_;
  for (std::size_t k = 0; k + 1 < side.crown.size(); ++k) {
    const Primitive& nominal = section_.primitives[side.crown[k]].shape;
    if (!std::holds_alternative<Arc>(nominal)) return false;
    Arc arc = outward(std::get<Arc>(nominal));
    const double arcLength = arc.radiusMm * std::abs(arc.sweepRad);
    const double curvatureNow = 1 / arc.radiusMm + (k == 0 ? extraCurvature : 0);
    if (curvatureNow < 1e-5) return false;
    const Point2 join = endPoint(before);
    const Point2 toCentre = (before.centre - join).normalized();
    arc.radiusMm = 1 / curvatureNow;
    arc.centre = join + arc.radiusMm * toCentre;
    arc.startAngleRad = angleOf(-toCentre);
    arc.sweepRad = (arc.sweepRad > 0 ? 1 : -1) * arcLength * curvatureNow;
    store(side.crown[k], arc);
    before = arc;
    beforeIndex = side.crown[k];
  }
  if (side.crown.empty()) return true;
  const std::size_t lastIndex = side.crown.back();
  if (!std::holds_alternative<Arc>(section_.primitives[lastIndex].shape)) return false;
  const Arc nominal = outward(std::get<Arc>(section_.primitives[lastIndex].shape));
  const Segment head = std::get<Segment>(pieces[side.headSide].base);
  const Point2 along = (head.end - head.start).normalized();
  // Centre at the radius from the line, on the metal's side (left of an outline that runs counter-clockwise), and at
  // the difference of the radii from the centre of the arc before.
  const Point2 onOffset = head.start + nominal.radiusMm * leftOf(along);
  const double gap = std::abs(before.radiusMm - nominal.radiusMm);
  const double distance = cross(along, before.centre - onOffset);
  const double half2 = gap * gap - distance * distance;
  if (half2 < 0 || gap < 1e-6) return false;
  const Point2 foot = before.centre - distance * leftOf(along);
  const Point2 one = foot + std::sqrt(half2) * along, two = foot - std::sqrt(half2) * along;
  const Point2 centre = (one - nominal.centre).norm() < (two - nominal.centre).norm() ? one : two;
  const Point2 direction = (centre - before.centre).normalized() * (before.radiusMm > nominal.radiusMm ? 1 : -1);
  const Point2 touchBefore = before.centre + before.radiusMm * direction;
  const Point2 touchHead = centre - nominal.radiusMm * leftOf(along);
  const double turn = nominal.sweepRad > 0 ? 1 : -1;
  const Arc trimmed = arcBetween(before.centre, startPoint(before), touchBefore, turn);
  const Arc last = arcBetween(centre, touchBefore, touchHead, turn);
  if (std::abs(trimmed.sweepRad) > M_PI || std::abs(last.sweepRad) > M_PI) return false;  // would run backwards
  store(beforeIndex, trimmed);
  store(lastIndex, last);
  Segment side2 = head;
  (side.sign > 0 ? side2.end : side2.start) = touchHead;
  if ((side2.end - side2.start).dot(along) <= 0) return false;
  pieces[side.headSide].base = side2;
  return true;
}

/// What has not been placed lies between two placed pieces: it is displaced by a cubic that continues both.
void OutlineShaper::carryTheRest(std::vector<OutlinePiece>& pieces, std::vector<char>& placed) const {
  const std::size_t n = pieces.size();
  const auto displacementAtEnd = [&](std::size_t i) {
    return Point2(pieces[i].at(1) - endPoint(section_.primitives[i].shape));
  };
  const auto displacementAtStart = [&](std::size_t i) {
    return Point2(pieces[i].at(0) - startPoint(section_.primitives[i].shape));
  };
  // Derivative of the displacement by arc length, at the border of a placed piece.
  const auto slope = [&](std::size_t i, bool end) -> Point2 {
    const Primitive& nominal = section_.primitives[i].shape;
    if (!pieces[i].carried) {  // turned, if it is an arc of another radius
      const double s = end ? 1 : 0;
      return tangentAt(pieces[i].base, s * length(pieces[i].base)) - tangentAt(nominal, s * length(nominal));
    }
    return (end ? pieces[i].m1 : pieces[i].m0) / length(nominal);
  };
  for (std::size_t i = 0; i < n; ++i) {
    if (!placed[i] || placed[(i + 1) % n]) continue;
    std::vector<std::size_t> chain;
    double total = 0;
    std::size_t next = (i + 1) % n;
    for (; !placed[next]; next = (next + 1) % n) {
      chain.push_back(next);
      total += length(section_.primitives[next].shape);
    }
    double run = 0;
    for (const std::size_t k : chain) {
      OutlinePiece& piece = pieces[k];
      piece.carried = true;
      piece.d0 = displacementAtEnd(i);
      piece.d1 = displacementAtStart(next);
      piece.m0 = slope(i, true) * total;
      piece.m1 = slope(next, false) * total;
      piece.from = run / total;
      run += length(section_.primitives[k].shape);
      piece.to = run / total;
    }
  }
}

void OutlineShaper::sample(std::span<const OutlinePiece> pieces, double sagittaMm, double maxStepMm,
                           std::vector<OutlineVertex>& vertices) const {
  vertices.clear();
  double along = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Primitive& nominal = section_.primitives[i].shape;
    const double nominalLength = length(nominal), bend = std::abs(curvature(nominal));
    double step = maxStepMm;
    if (bend > 0) step = std::min(step, std::sqrt(8 * sagittaMm / bend));
    const int count = std::max(2, static_cast<int>(std::ceil(nominalLength / step)));
    for (int k = 0; k < count; ++k) {
      const double share = static_cast<double>(k) / count;
      vertices.push_back({pieces[i].at(share), along + share * nominalLength, i});
    }
    along += nominalLength;
  }
}

}  // namespace vignole::simulator
