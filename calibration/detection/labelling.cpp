#include "calibration/detection/labelling.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace vignole {
namespace {

struct Box {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

Box boxOf(const std::vector<LatticePlace>& lattice, const Placing& placing, TargetPattern pattern) {
  Box box;
  bool first = true;
  for (const LatticePlace& place : lattice) {
    const auto [x, y] = placed(place, placing, pattern);
    box.x0 = first ? x : std::min(box.x0, x);
    box.x1 = first ? x : std::max(box.x1, x);
    box.y0 = first ? y : std::min(box.y0, y);
    box.y1 = first ? y : std::max(box.y1, y);
    first = false;
  }
  return box;
}

int widthOf(const PlanarTarget& target) {
  return target.pattern == TargetPattern::AsymmetricCircles ? 2 * target.columns : target.columns;
}

}  // namespace

LatticePlace placed(const LatticePlace& place, const Placing& placing, TargetPattern pattern) {
  int x = place.first, y = place.second;
  // The nearest neighbours of asymmetric circles stand diagonally.
  if (pattern == TargetPattern::AsymmetricCircles) {
    const int u = x, v = y;
    x = u - v;
    y = u + v;
  }
  if (placing.mirrored) x = -x;
  for (int turn = 0; turn < placing.quarterTurns; ++turn) {
    const int old = x;
    x = -y;
    y = old;
  }
  return {x + placing.shiftX, y + placing.shiftY};
}

int indexOf(const LatticePlace& columnAndRow, const PlanarTarget& target) {
  const auto [x, y] = columnAndRow;
  if (x < 0 || y < 0 || x >= widthOf(target) || y >= target.rows) return -1;
  if (target.pattern != TargetPattern::AsymmetricCircles) return y * target.columns + x;
  return (x + y) % 2 == 0 ? y * target.columns + x / 2 : -1;
}

std::vector<Placing> placings(const std::vector<LatticePlace>& lattice, const PlanarTarget& target, bool mirrored) {
  std::vector<Placing> all;
  for (int turns = 0; turns < 4; ++turns) {
    Placing placing{turns, mirrored, 0, 0};
    const Box box = boxOf(lattice, placing, target.pattern);
    for (int y = -box.y0; y + box.y1 < target.rows; ++y)
      for (int x = -box.x0; x + box.x1 < widthOf(target); ++x) {
        placing.shiftX = x;
        placing.shiftY = y;
        const bool fits = std::all_of(lattice.begin(), lattice.end(), [&](const LatticePlace& place) {
          return indexOf(placed(place, placing, target.pattern), target) >= 0;
        });
        if (fits) all.push_back(placing);
      }
  }
  return all;
}

std::array<int, 2> sizeOf(const std::vector<LatticePlace>& lattice, const PlanarTarget& target) {
  std::array<int, 2> best{0, 0};
  int bestOff = -1;
  for (int turns = 0; turns < 2; ++turns) {
    const Box box = boxOf(lattice, {turns, false, 0, 0}, target.pattern);
    int columns = box.x1 - box.x0 + 1;
    const int rows = box.y1 - box.y0 + 1;
    if (target.pattern == TargetPattern::AsymmetricCircles) columns = (columns + 1) / 2;
    const int off = std::abs(columns - target.columns) + std::abs(rows - target.rows);
    if (bestOff >= 0 && off >= bestOff) continue;
    bestOff = off;
    best = {columns, rows};
  }
  return best;
}

}  // namespace vignole
