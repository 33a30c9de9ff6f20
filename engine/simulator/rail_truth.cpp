#include "engine/simulator/rail_truth.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace vignole::simulator {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr int kX = 0, kY = 1;

/// Where a polyline passes `at` in one coordinate: the other coordinate, linear between its points; NaN where it does
/// not pass.
double crossing(const std::vector<Point2>& line, int coordinate, double at) {
  const int other = 1 - coordinate;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double a = line[i](coordinate), b = line[i + 1](coordinate);
    if ((at < std::min(a, b)) || (at > std::max(a, b)) || a == b) continue;
    return line[i](other) + (line[i + 1](other) - line[i](other)) * (at - a) / (b - a);
  }
  return kNone;
}

/// y = c0 + c1 x + c2 x^2 by least squares.
Eigen::Vector3d parabola(const std::vector<Point2>& points) {
  Eigen::MatrixXd a(static_cast<Eigen::Index>(points.size()), 3);
  Eigen::VectorXd b(a.rows());
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    const Point2& p = points[static_cast<std::size_t>(i)];
    a.row(i) << 1, p.x() / 100, p.x() * p.x() / 1e4;
    b(i) = p.y();
  }
  const Eigen::Vector3d c = a.colPivHouseholderQr().solve(b);
  return {c(0), c(1) / 100, c(2) / 1e4};
}
double value(const Eigen::Vector3d& c, double x) { return c(0) + x * (c(1) + x * c(2)); }

/// x of the least-squares line x = a + b y at the middle height of the points.
double edgeAtMidHeight(const std::vector<Point2>& points) {
  double low = points.front().y(), high = low, my = 0, mx = 0;
  for (const Point2& p : points) {
    low = std::min(low, p.y());
    high = std::max(high, p.y());
    mx += p.x() / static_cast<double>(points.size());
    my += p.y() / static_cast<double>(points.size());
  }
  double sxy = 0, syy = 0;
  for (const Point2& p : points) {
    sxy += (p.x() - mx) * (p.y() - my);
    syy += (p.y() - my) * (p.y() - my);
  }
  return mx + sxy / syy * ((low + high) / 2 - my);
}

struct Circle {
  Point2 centre;
  double radius;
};
/// Algebraic fit: exact for points of one circle, which the outline's AHT is.
Circle circle(const std::vector<Point2>& points) {
  Point2 mean(0, 0);
  for (const Point2& p : points) mean += p / static_cast<double>(points.size());
  Eigen::MatrixXd a(static_cast<Eigen::Index>(points.size()), 3);
  Eigen::VectorXd b(a.rows());
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    const Point2 p = points[static_cast<std::size_t>(i)] - mean;
    a.row(i) << p.x(), p.y(), 1;
    b(i) = p.squaredNorm();
  }
  const Eigen::Vector3d c = a.colPivHouseholderQr().solve(b);
  const Point2 centre(c(0) / 2, c(1) / 2);
  return {centre + mean, std::sqrt(c(2) + centre.squaredNorm())};
}

}  // namespace

/// The outline cut into its primitives, each with its end point, in the frame of the base line.
struct TruthGauge::Lines {
  std::vector<std::vector<Point2>> of;
  void rotate(double angle) {
    const Transform2 turn{0, 0, angle};
    for (auto& line : of)
      for (Point2& p : line) p = turn * p;
  }
  [[nodiscard]] double cross(const std::vector<std::size_t>& candidates, int coordinate, double at) const {
    for (const std::size_t i : candidates)
      if (const double c = crossing(of[i], coordinate, at); !std::isnan(c)) return c;
    return kNone;
  }
};

TruthGauge::Sides TruthGauge::findSides(char letter) const {
  const auto find = [&](const char* name) { return section_.find(std::string(name) + letter).value_or(0); };
  Sides s{find("SB"), find("SWB"), find("SHB"), find("SH"), {}, {}, {}};
  const std::size_t n = section_.primitives.size();
  const auto between = [&](std::size_t a, std::size_t b) {  // both included, either sense of the outline
    std::vector<std::size_t> list{a};
    for (std::size_t i = a; i != b;) {
      i = letter == 'R' ? (i + 1) % n : (i + n - 1) % n;
      list.push_back(i);
    }
    return list;
  };
  s.footTop = between(s.edge, s.lowerFishing);
  s.footTop.erase(s.footTop.begin());
  s.web = between(s.lowerFishing, s.upperFishing);
  s.head = between(s.headSide, top_);
  return s;
}

TruthGauge::TruthGauge(const Section& nominal, const DimensionParameters& parameters)
    : section_(nominal), parameters_(parameters) {
  bottom_ = section_.find("SBB").value_or(0);
  top_ = section_.find("AHT").value_or(0);
  sides_ = {findSides('R'), findSides('L')};
  crown_ = sides_[0].head;
  crown_.insert(crown_.end(), sides_[1].head.begin(), sides_[1].head.end());

  Lines lines;
  for (const NamedPrimitive& p : section_.primitives) {
    std::vector<Point2> line;
    const double l = length(p.shape);
    const double bend = std::abs(curvature(p.shape));
    const int count = std::max(2, static_cast<int>(std::ceil(l / (bend > 0 ? std::sqrt(8e-6 / bend) : 1))));
    for (int k = 0; k <= count; ++k) line.push_back(pointAt(p.shape, l * k / count));
    lines.of.push_back(std::move(line));
  }
  // Thinnest web, the middle of where it is so.
  double thinnest = 1e9, first = 0, last = 0;
  const double low = startPoint(section_.primitives[sides_[0].lowerFishing].shape).y();
  const double high = startPoint(section_.primitives[sides_[0].headSide].shape).y();
  constexpr double kStepMm = 0.02;
  const int steps = static_cast<int>(std::ceil((high - low) / kStepMm));
  for (int i = 0; i < steps; ++i) {
    const double y = low + kStepMm * i;
    const double t = lines.cross(sides_[0].web, kY, y) - lines.cross(sides_[1].web, kY, y);
    if (t < thinnest - 1e-5) thinnest = t, first = y;
    if (t < thinnest + 1e-5) last = y;
  }
  waistMm_ = parameters_.wtHeightMm.value_or((first + last) / 2);

  const double axis = (edgeAtMidHeight(lines.of[sides_[0].edge]) + edgeAtMidHeight(lines.of[sides_[1].edge])) / 2 +
                      section_.axisFromFootMiddleMm;
  const int leftmost = -static_cast<int>(std::floor(parameters_.hfHalfWidthMm.left));
  const int rightmost = static_cast<int>(std::floor(parameters_.hfHalfWidthMm.right));
  for (int x = leftmost; x <= rightmost; ++x) places_.push_back(x);
  const double summit = crownHeight(lines, axis);
  for (const double x : places_) nominalCrown_.push_back(crownHeight(lines, axis + x) - summit);
}

double TruthGauge::crownHeight(const Lines& lines, double x) const {
  double y = kNone;  // the head side hangs over: the highest counts
  for (const std::size_t i : crown_)
    if (const double c = crossing(lines.of[i], kX, x); !std::isnan(c) && !(c < y)) y = c;
  return y;
}

TrueDimensions TruthGauge::measure(std::span<const OutlineVertex> outline) const {
  Lines lines;
  lines.of.resize(section_.primitives.size());
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const OutlineVertex& v = outline[i];
    if (i > 0 && outline[i - 1].primitive != v.primitive) lines.of[outline[i - 1].primitive].push_back(v.point);
    lines.of[v.primitive].push_back(v.point);
  }
  lines.of[outline.back().primitive].push_back(outline.front().point);

  // Base line along x: it is a chord of the fitted foot bottom, so turning by its slope needs few rounds.
  Eigen::Vector3d bottom;
  double left = 0, right = 0, base = 0;
  for (int round = 0; round < 4; ++round) {
    bottom = parabola(lines.of[bottom_]);
    right = edgeAtMidHeight(lines.of[sides_[0].edge]);
    left = edgeAtMidHeight(lines.of[sides_[1].edge]);
    const double a = left + parameters_.baseInsetMm, b = right - parameters_.baseInsetMm;
    base = value(bottom, a);
    const double angle = std::atan2(value(bottom, b) - base, b - a);
    if (std::abs(angle) < 1e-12) break;
    lines.rotate(-angle);
  }
  const double axis = (left + right) / 2 + section_.axisFromFootMiddleMm;
  const Circle crown = circle(lines.of[top_]);
  const double summit =
      crown.centre.y() + std::sqrt(crown.radius * crown.radius - (axis - crown.centre.x()) * (axis - crown.centre.x()));
  TrueDimensions t;
  const auto set = [&](Dimension d, double v) { t.mm[index(d)] = v; };
  const auto headSide = [&](std::size_t side, double depth) {
    return lines.cross(sides_[side].head, kY, summit - depth);
  };
  const auto fishing = [&](std::size_t side, double x) {
    return crossing(lines.of[sides_[side].upperFishing], kX, x) - crossing(lines.of[sides_[side].lowerFishing], kX, x);
  };
  set(Dimension::RH, summit - base);
  set(Dimension::RFH,
      (fishing(0, axis + parameters_.rfhFromAxisMm.right) + fishing(1, axis - parameters_.rfhFromAxisMm.left)) / 2);
  set(Dimension::FW, right - left);
  set(Dimension::HW, headSide(0, parameters_.hwDepthMm) - headSide(1, parameters_.hwDepthMm));
  set(Dimension::HWA, headSide(0, parameters_.hwaDepthMm) - headSide(1, parameters_.hwaDepthMm));
  const double ftRight = right - parameters_.ftInsideMm.right, ftLeft = left + parameters_.ftInsideMm.left;
  set(Dimension::FTr, lines.cross(sides_[0].footTop, kX, ftRight) - value(bottom, ftRight));
  set(Dimension::FTl, lines.cross(sides_[1].footTop, kX, ftLeft) - value(bottom, ftLeft));
  set(Dimension::RASr, right - headSide(0, parameters_.rasDepthMm.right));
  set(Dimension::RASl, headSide(1, parameters_.rasDepthMm.left) - left);
  set(Dimension::WT, lines.cross(sides_[0].web, kY, base + waistMm_) - lines.cross(sides_[1].web, kY, base + waistMm_));
  set(Dimension::HR, crown.radius);
  set(Dimension::FC, value(bottom, (left + right) / 2) - base);
  double most = -1e9, least = 1e9;
  const double here = crownHeight(lines, axis);
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const double d = crownHeight(lines, axis + places_[i]) - here - nominalCrown_[i];
    most = std::max(most, d);
    least = std::min(least, d);
    if (std::isnan(d)) most = least = kNone;
    if (std::isnan(most)) break;
  }
  set(Dimension::HF, most);
  t.hfMinMm = least;
  return t;
}

}  // namespace vignole::simulator
