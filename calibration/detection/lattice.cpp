#include "calibration/detection/lattice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <set>

namespace vignole {
namespace {

constexpr double kGate = 0.32;        // of the shorter step
constexpr double kMostUneven = 0.2;   // of the step: how far a point may be from the middle of its neighbours
constexpr double kMostStretch = 2.2;  // of a step against the one before

constexpr std::array<LatticePlace, 4> kDirections{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

LatticePlace operator+(const LatticePlace& a, const LatticePlace& b) {
  return {a.first + b.first, a.second + b.second};
}
LatticePlace operator-(const LatticePlace& a, const LatticePlace& b) {
  return {a.first - b.first, a.second - b.second};
}
LatticePlace operator-(const LatticePlace& a) { return {-a.first, -a.second}; }
LatticePlace across(const LatticePlace& d) { return {-d.second, d.first}; }

const Point2* at(const ByPlace<Point2>& lattice, const LatticePlace& place) {
  const auto found = lattice.find(place);
  return found == lattice.end() ? nullptr : &found->second;
}

/// The step from `from` in `direction`: as its own line and the lines beside it have it.
std::optional<Point2> stepFrom(const ByPlace<Point2>& lattice, const LatticePlace& from,
                               const LatticePlace& direction) {
  const Point2* here = at(lattice, from);
  if (here == nullptr) return std::nullopt;
  Point2 sum(0, 0);
  double weights = 0;
  if (const Point2* behind = at(lattice, from - direction)) {
    // Perspective and lens change a step evenly along a line.
    Point2 step = *here - *behind;
    if (const Point2* further = at(lattice, from - direction - direction)) step += 0.5 * (step - (*behind - *further));
    sum += step;
    weights += 1;
  }
  for (const LatticePlace& side : {across(direction), -across(direction)}) {
    const Point2 *a = at(lattice, from + side), *b = at(lattice, from + side + direction);
    if (a == nullptr || b == nullptr) continue;
    sum += *b - *a;
    weights += 1;
  }
  if (weights == 0) return std::nullopt;
  return sum / weights;
}

/// What is known where a point stands, before its neighbours are.
struct Front {
  LatticePlace place;
  LatticeSteps steps;
};

}  // namespace

ByPlace<std::size_t> growLattice(std::span<const Point2> points, const PointIndex& index, const LatticeSeed& seed,
                                 const MayBeNeighbours& mayBeNeighbours) {
  ByPlace<std::size_t> lattice{{{0, 0}, seed.candidate}};
  ByPlace<Point2> places{{{0, 0}, points[seed.candidate]}};
  std::set<std::size_t> used{seed.candidate};
  std::deque<Front> fronts{{{0, 0}, seed.steps}};
  while (!fronts.empty()) {
    const Front front = fronts.front();
    fronts.pop_front();
    const std::size_t from = lattice.at(front.place);
    for (const LatticePlace& direction : kDirections) {
      const LatticePlace to = front.place + direction;
      if (lattice.contains(to)) continue;
      const bool alongU = direction.first != 0;
      const double sign = direction.first + direction.second;
      const Point2 own = sign * (alongU ? front.steps.u : front.steps.v);
      Point2 step = own;
      if (const auto known = stepFrom(places, front.place, direction)) step = *known;
      const double shorter = std::min(step.norm(), (alongU ? front.steps.v : front.steps.u).norm());
      const auto candidate = index.nearest(points[from] + step, kGate * shorter);
      if (!candidate || used.contains(*candidate) || !mayBeNeighbours(from, *candidate)) continue;
      const Point2 taken = points[*candidate] - points[from];
      if (taken.norm() > kMostStretch * own.norm() || own.norm() > kMostStretch * taken.norm()) continue;
      lattice[to] = *candidate;
      places[to] = points[*candidate];
      used.insert(*candidate);
      Front next{to, front.steps};
      (alongU ? next.steps.u : next.steps.v) = sign * taken;
      fronts.push_back(next);
    }
  }
  return lattice;
}

std::optional<LatticePrediction> predicted(const ByPlace<Point2>& lattice, const LatticePlace& place) {
  LatticePrediction result;
  Point2 sum(0, 0);
  double weights = 0;
  for (const LatticePlace& direction : kDirections) {
    const LatticePlace from = place - direction;
    const Point2* here = at(lattice, from);
    if (here == nullptr) continue;
    // Between two points is better than beyond one.
    if (const Point2* beyond = at(lattice, place + direction)) {
      sum += 0.5 * (*here + *beyond) * 2;
      weights += 2;
      result.neighbour = from;
      continue;
    }
    if (const auto step = stepFrom(lattice, from, direction)) {
      sum += *here + *step;
      weights += 1;
      result.neighbour = from;
    }
  }
  if (weights == 0) return std::nullopt;
  result.px = sum / weights;
  const auto stepAbout = [&](const LatticePlace& direction) -> std::optional<Point2> {
    if (const auto ahead = stepFrom(lattice, result.neighbour, direction)) return ahead;
    if (const auto back = stepFrom(lattice, result.neighbour, -direction)) return Point2(-*back);
    return std::nullopt;
  };
  const auto u = stepAbout({1, 0}), v = stepAbout({0, 1});
  if (!u || !v) return std::nullopt;
  result.steps = {*u, *v};
  return result;
}

void dropUneven(ByPlace<Point2>& lattice) {
  for (;;) {
    double worst = kMostUneven;
    std::optional<LatticePlace> worstPlace;
    for (const auto& [place, px] : lattice) {
      double uneven = 0;
      int pairs = 0;
      for (const LatticePlace& direction : {kDirections[0], kDirections[1]}) {
        const Point2 *before = at(lattice, place - direction), *behind = at(lattice, place + direction);
        if (before == nullptr || behind == nullptr) continue;
        const double share = (*before + *behind - 2 * px).norm() / (*behind - *before).norm();
        // A point off its place spoils its own two lines, and its neighbours' by half.
        uneven += share;
        ++pairs;
      }
      if (pairs > 0 && uneven / pairs > worst) {
        worst = uneven / pairs;
        worstPlace = place;
      }
    }
    if (!worstPlace) return;
    lattice.erase(*worstPlace);
  }
}

std::vector<LatticePlace> openPlaces(const ByPlace<Point2>& lattice) {
  std::set<LatticePlace> open;
  for (const auto& [place, px] : lattice)
    for (const LatticePlace& direction : kDirections)
      if (!lattice.contains(place + direction)) open.insert(place + direction);
  return {open.begin(), open.end()};
}

}  // namespace vignole
