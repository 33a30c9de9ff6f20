#include "calibration/range_finders/pattern_match.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vignole {

namespace {

constexpr double kShare = 0.08;      // by which distances and radii may be off: the plane is known but roughly
constexpr double kFarMm = 45;        // pairs further apart than that tell a turn well
constexpr double kSameTurn = 5 * std::numbers::pi / 180, kSameMm = 8;

bool radiiAgree(const FoundCircle& circle, const Pin& pin, double radiusMm) {
  return std::abs(circle.radiusMm - pin.radiusMm) < radiusMm + kShare * pin.radiusMm + 3 * circle.uRadiusMm;
}

/// Maps of the plate into the plane.
using Map = Eigen::Matrix3d;

Point2 apply(const Map& map, const Point2& p) {
  const Eigen::Vector3d h = map * Eigen::Vector3d(p.x(), p.y(), 1);
  return h.head<2>() / h.z();
}

Map mapOf(const Transform2& t) {
  Map map = Map::Identity();
  const double c = std::cos(t.angleRad), s = std::sin(t.angleRad);
  map << c, -s, t.xMm, s, c, t.yMm, 0, 0, 1;
  return map;
}

class Matcher {
 public:
  Matcher(std::span<const FoundCircle> circles, std::span<const Pin> pins, const PatternSettings& settings)
      : circles_(circles), pins_(pins), settings_(settings), agrees_(circles.size() * pins.size()) {
    for (std::size_t c = 0; c < circles.size(); ++c)
      for (std::size_t p = 0; p < pins.size(); ++p)
        agrees_[c * pins.size() + p] = radiiAgree(circles[c], pins[p], settings.radiusMm);
  }
  [[nodiscard]] std::vector<PatternMatch> run() const;

 private:
  struct Guess {
    Transform2 turn;
    double score = 0;
  };
  [[nodiscard]] bool agrees(std::size_t circle, std::size_t pin) const { return agrees_[circle * pins_.size() + pin]; }
  [[nodiscard]] double score(const Transform2& turn) const;
  [[nodiscard]] std::vector<Guess> guesses() const;
  [[nodiscard]] std::vector<PatternMatch::Pair> pairs(const Map& map, double gateMm) const;
  [[nodiscard]] Map fit(const std::vector<PatternMatch::Pair>& pairs, bool perspective) const;
  [[nodiscard]] PatternMatch refine(const Guess& guess) const;

  std::span<const FoundCircle> circles_;
  std::span<const Pin> pins_;
  const PatternSettings& settings_;
  std::vector<char> agrees_;
};

/// How many pins have a circle near, nearer ones counting more.
double Matcher::score(const Transform2& turn) const {
  const double gate2 = settings_.firstGateMm * settings_.firstGateMm;
  double sum = 0;
  for (std::size_t p = 0; p < pins_.size(); ++p) {
    const Point2 at = turn * pins_[p].centreMm;
    double nearest = gate2;
    for (std::size_t c = 0; c < circles_.size(); ++c)
      if (agrees(c, p)) nearest = std::min(nearest, (circles_[c].centreMm - at).squaredNorm());
    sum += 1 - nearest / gate2;
  }
  return sum;
}

std::vector<Matcher::Guess> Matcher::guesses() const {
  std::vector<Guess> all;
  for (std::size_t a = 0; a < circles_.size(); ++a)
    for (std::size_t b = a + 1; b < circles_.size(); ++b) {
      const Point2 found = circles_[b].centreMm - circles_[a].centreMm;
      const double length = found.norm();
      if (length < kFarMm) continue;
      for (std::size_t i = 0; i < pins_.size(); ++i)
        for (std::size_t j = 0; j < pins_.size(); ++j) {
          if (i == j || !agrees(a, i) || !agrees(b, j)) continue;
          const Point2 stated = pins_[j].centreMm - pins_[i].centreMm;
          if (std::abs(stated.norm() - length) > kShare * length) continue;
          Transform2 turn;
          turn.angleRad = std::remainder(std::atan2(found.y(), found.x()) - std::atan2(stated.y(), stated.x()),
                                         2 * std::numbers::pi);
          const Point2 shift = (circles_[a].centreMm + circles_[b].centreMm) / 2 -
                               turn.rotate((pins_[i].centreMm + pins_[j].centreMm) / 2);
          turn.xMm = shift.x();
          turn.yMm = shift.y();
          all.push_back({turn, score(turn)});
        }
    }
  std::stable_sort(all.begin(), all.end(), [](const Guess& x, const Guess& y) { return x.score > y.score; });
  Point2 middle(0, 0);
  for (const Pin& pin : pins_) middle += pin.centreMm / static_cast<double>(pins_.size());
  std::vector<Guess> different;
  for (const Guess& g : all) {
    const auto same = [&](const Guess& d) {
      return std::abs(std::remainder(d.turn.angleRad - g.turn.angleRad, 2 * std::numbers::pi)) < kSameTurn &&
             (d.turn * middle - g.turn * middle).norm() < kSameMm;
    };
    if (std::none_of(different.begin(), different.end(), same)) different.push_back(g);
    if (static_cast<int>(different.size()) >= settings_.answers) break;
  }
  return different;
}

/// Those that are each other's nearest.
std::vector<PatternMatch::Pair> Matcher::pairs(const Map& map, double gateMm) const {
  std::vector<Point2> placed;
  for (const Pin& pin : pins_) placed.push_back(apply(map, pin.centreMm));
  const auto nearestPin = [&](std::size_t circle) {
    std::size_t best = pins_.size();
    double distance = gateMm;
    for (std::size_t p = 0; p < pins_.size(); ++p)
      if (const double d = (placed[p] - circles_[circle].centreMm).norm(); agrees(circle, p) && d < distance)
        best = p, distance = d;
    return best;
  };
  const auto nearestCircle = [&](std::size_t pin) {
    std::size_t best = circles_.size();
    double distance = gateMm;
    for (std::size_t c = 0; c < circles_.size(); ++c)
      if (const double d = (placed[pin] - circles_[c].centreMm).norm(); agrees(c, pin) && d < distance)
        best = c, distance = d;
    return best;
  };
  std::vector<PatternMatch::Pair> found;
  for (std::size_t c = 0; c < circles_.size(); ++c)
    if (const std::size_t p = nearestPin(c); p < pins_.size() && nearestCircle(p) == c)
      found.push_back({static_cast<int>(c), static_cast<int>(p)});
  return found;
}

/// Least squares; for a homography linear in its eight numbers, about the middle and in units of 100 mm.
Map Matcher::fit(const std::vector<PatternMatch::Pair>& pairs, bool perspective) const {
  constexpr double kUnitMm = 100;
  Point2 from(0, 0), to(0, 0);
  for (const auto& pair : pairs) {
    from += pins_[static_cast<std::size_t>(pair.pin)].centreMm / static_cast<double>(pairs.size());
    to += circles_[static_cast<std::size_t>(pair.circle)].centreMm / static_cast<double>(pairs.size());
  }
  const Eigen::Index unknowns = perspective ? 8 : 6;
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(unknowns, unknowns);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns);
  for (const auto& pair : pairs) {
    const Point2 p = (pins_[static_cast<std::size_t>(pair.pin)].centreMm - from) / kUnitMm;
    const Point2 q = (circles_[static_cast<std::size_t>(pair.circle)].centreMm - to) / kUnitMm;
    for (int axis = 0; axis < 2; ++axis) {
      Eigen::VectorXd row = Eigen::VectorXd::Zero(unknowns);
      row.segment<3>(3 * axis) << p.x(), p.y(), 1;
      if (perspective) row.tail<2>() << -q[axis] * p.x(), -q[axis] * p.y();
      normal += row * row.transpose();
      right += q[axis] * row;
    }
  }
  normal.diagonal().array() += 1e-9;
  const Eigen::VectorXd h = normal.ldlt().solve(right);
  Map unit = Map::Identity();
  unit.row(0) = h.segment<3>(0);
  unit.row(1) = h.segment<3>(3);
  if (perspective) unit.row(2).head<2>() = h.tail<2>();
  Map toUnit = Map::Identity(), fromUnit = Map::Identity();
  toUnit << 1 / kUnitMm, 0, -from.x() / kUnitMm, 0, 1 / kUnitMm, -from.y() / kUnitMm, 0, 0, 1;
  fromUnit << kUnitMm, 0, to.x(), 0, kUnitMm, to.y(), 0, 0, 1;
  return fromUnit * unit * toUnit;
}

PatternMatch Matcher::refine(const Guess& guess) const {
  constexpr std::size_t kAffine = 4, kPerspective = 6;
  PatternMatch match;
  match.planeFromPlate = guess.turn;
  Map map = mapOf(guess.turn);
  std::vector<PatternMatch::Pair> now = pairs(map, settings_.firstGateMm);
  const auto round = [&](bool perspective, double gateMm) {
    for (int i = 0; i < 4; ++i) {
      if (now.size() < (perspective ? kPerspective : kAffine)) return;
      map = fit(now, perspective);
      now = pairs(map, gateMm);
    }
  };
  round(false, settings_.secondGateMm);
  round(true, settings_.lastGateMm);
  match.pairs = now;
  double square = 0;
  for (const auto& pair : now)
    square += (apply(map, pins_[static_cast<std::size_t>(pair.pin)].centreMm) -
               circles_[static_cast<std::size_t>(pair.circle)].centreMm)
                  .squaredNorm();
  const double freedom = 2 * static_cast<double>(now.size()) - (now.size() >= kPerspective ? 8 : 6);
  match.rmsMm = freedom > 0 ? std::sqrt(square / freedom) : std::numeric_limits<double>::infinity();
  if (now.size() < 2) return match;
  // The turn and shift that come closest.
  Point2 from(0, 0), to(0, 0);
  for (const auto& pair : now) {
    from += pins_[static_cast<std::size_t>(pair.pin)].centreMm / static_cast<double>(now.size());
    to += circles_[static_cast<std::size_t>(pair.circle)].centreMm / static_cast<double>(now.size());
  }
  double along = 0, across = 0;
  for (const auto& pair : now) {
    const Point2 p = pins_[static_cast<std::size_t>(pair.pin)].centreMm - from,
                 q = circles_[static_cast<std::size_t>(pair.circle)].centreMm - to;
    along += p.dot(q);
    across += p.x() * q.y() - p.y() * q.x();
  }
  Transform2& turn = match.planeFromPlate;
  turn.angleRad = std::atan2(across, along);
  const Point2 shift = to - Transform2{0, 0, turn.angleRad}.rotate(from);
  turn.xMm = shift.x();
  turn.yMm = shift.y();
  return match;
}

std::vector<PatternMatch> Matcher::run() const {
  std::vector<PatternMatch> matches;
  for (const Guess& guess : guesses()) {
    PatternMatch match = refine(guess);
    const auto same = [&](const PatternMatch& m) {
      if (m.pairs.size() != match.pairs.size()) return false;
      for (std::size_t i = 0; i < m.pairs.size(); ++i)
        if (m.pairs[i].circle != match.pairs[i].circle || m.pairs[i].pin != match.pairs[i].pin) return false;
      return true;
    };
    if (std::none_of(matches.begin(), matches.end(), same)) matches.push_back(std::move(match));
  }
  std::stable_sort(matches.begin(), matches.end(), [](const PatternMatch& a, const PatternMatch& b) {
    return a.pairs.size() != b.pairs.size() ? a.pairs.size() > b.pairs.size() : a.rmsMm < b.rmsMm;
  });
  return matches;
}

}  // namespace

std::vector<PatternMatch> matchPattern(std::span<const FoundCircle> circles, std::span<const Pin> pins,
                                       const PatternSettings& settings) {
  return Matcher(circles, pins, settings).run();
}

}  // namespace vignole
