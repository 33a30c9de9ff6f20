#include "calibration/detection/labelling.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace vignole {
namespace {

PlaceBox boxUnder(const Placing& placing, const std::vector<LatticePlace>& lattice) {
  std::vector<LatticePlace> all;
  all.reserve(lattice.size());
  for (const LatticePlace& place : lattice) all.push_back(placed(place, placing));
  return boxOf(all);
}

}  // namespace

PlaceBox boxOf(const std::vector<LatticePlace>& lattice) {
  if (lattice.empty()) return {};
  PlaceBox box{lattice.front().first, lattice.front().second, lattice.front().first, lattice.front().second};
  for (const auto& [x, y] : lattice) {
    box.x0 = std::min(box.x0, x);
    box.x1 = std::max(box.x1, x);
    box.y0 = std::min(box.y0, y);
    box.y1 = std::max(box.y1, y);
  }
  return box;
}

int widthOf(const PlanarTarget& target) {
  return target.pattern == TargetPattern::AsymmetricCircles ? 2 * target.columns : target.columns;
}

LatticePlace alongRows(const LatticePlace& place, TargetPattern pattern) {
  if (pattern != TargetPattern::AsymmetricCircles) return place;
  return {place.first - place.second, place.first + place.second};
}

LatticePlace placed(const LatticePlace& place, const Placing& placing) {
  auto [x, y] = place;
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
    const PlaceBox box = boxUnder(placing, lattice);
    for (int y = -box.y0; y + box.y1 < target.rows; ++y)
      for (int x = -box.x0; x + box.x1 < widthOf(target); ++x) {
        placing.shiftX = x;
        placing.shiftY = y;
        const bool fits = std::all_of(lattice.begin(), lattice.end(), [&](const LatticePlace& place) {
          return indexOf(placed(place, placing), target) >= 0;
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
    const PlaceBox box = boxUnder({turns, false, 0, 0}, lattice);
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
