#include "engine/stripe/line_linking.h"

#include <algorithm>
#include <cmath>

namespace vignole {
namespace {

/// Walks begin at points of so many times the least strength of a beginning, then at the others.
constexpr std::array<float, 3> kSeedLevels{8, 3, 1};

/// Distance weighs less than leaving the direction: the next point is the one straight ahead.
float stepCost(float along, float across, float turn) { return 0.3F * along + 2 * across + turn; }

}  // namespace

// The best of the eight neighbours that lie ahead. The others abreast of it, or of the point, are used up on the way.
int LineLinker::successor(const RidgePoints& ridges, const Step& from) {
  const RidgeArrays& points = ridges.points();
  const float x = points.x[from.at], y = points.y[from.at], nx = points.nx[from.at], ny = points.ny[from.at];
  const std::uint16_t* map = ridges.around(from.at);
  std::array<std::pair<std::uint32_t, float>, 8> ahead;  // index, advance along the line
  std::size_t count = 0;
  int best = -1;
  float bestCost = 0, bestAlong = 0;
  for (int dy = -1; dy <= 1; ++dy) {
    const std::uint16_t* row = map + dy * RidgePoints::kMapPitch;
    if ((row[-1] | row[0] | row[1]) == 0) continue;
    const float vertical = static_cast<float>(dy) * from.ty;
    for (int dx = -1; dx <= 1; ++dx) {
      const std::uint32_t entry = row[dx];
      // Its sub-pixel point may be half a pixel off in both directions: nothing behind that can be ahead.
      if (entry == 0 || (dx == 0 && dy == 0) || static_cast<float>(dx) * from.tx + vertical < -0.75F) continue;
      const std::uint32_t index = entry - 1;
      if (used_[index] != 0) continue;
      const float ex = points.x[index] - x, ey = points.y[index] - y;
      const float along = ex * from.tx + ey * from.ty, across = std::abs(ex * from.ty - ey * from.tx);
      ahead[count++] = {index, along};
      if (along <= 0.05F) continue;
      const float cost = stepCost(along, across, 1 - std::abs(points.nx[index] * nx + points.ny[index] * ny));
      if (best < 0 || cost < bestCost) {
        best = static_cast<int>(index);
        bestCost = cost;
        bestAlong = along;
      }
    }
  }
  if (best < 0) return best;
  for (std::size_t i = 0; i < count; ++i)
    if (static_cast<int>(ahead[i].first) != best &&
        (std::abs(ahead[i].second) < 0.35F || std::abs(ahead[i].second - bestAlong) < 0.35F))
      used_[ahead[i].first] = 1;
  return best;
}

// Noise can leave a pixel without a point where the line passes from one row of pixels to the next: look one further.
int LineLinker::successorBeyond(const RidgePoints& ridges, const Step& from) const {
  const RidgePoint p = ridges.points().at(from.at);
  int best = -1;
  float bestCost = 0;
  for (int dy = -2; dy <= 2; ++dy)
    for (int dx = -2; dx <= 2; ++dx) {
      if (std::max(std::abs(dx), std::abs(dy)) < 2) continue;
      const int index = ridges.indexAt(columnOf(p.pixel) + dx, rowOf(p.pixel) + dy);
      if (index < 0 || used_[static_cast<std::size_t>(index)] != 0) continue;
      const RidgePoint q = ridges.points().at(static_cast<std::size_t>(index));
      const float ex = q.x - p.x, ey = q.y - p.y;
      const float along = ex * from.tx + ey * from.ty, across = std::abs(ex * from.ty - ey * from.tx);
      if (along < 1 || across > 0.5F * along || std::abs(q.nx * p.nx + q.ny * p.ny) < 0.85F) continue;
      const float cost = stepCost(along, across, 0);
      if (best < 0 || cost < bestCost) {
        best = index;
        bestCost = cost;
      }
    }
  return best;
}

void LineLinker::walk(const RidgePoints& ridges, Step from, std::vector<std::uint32_t>& out) {
  const RidgeArrays& points = ridges.points();
  for (;;) {
    int next = successor(ridges, from);
    if (next < 0) next = successorBeyond(ridges, from);
    if (next < 0) return;
    from.at = static_cast<std::uint32_t>(next);
    used_[from.at] = 1;
    out.push_back(from.at);
    const float nx = points.nx[from.at], ny = points.ny[from.at];
    const float sign = -ny * from.tx + nx * from.ty < 0 ? -1.0F : 1.0F;
    from.tx = -sign * ny;
    from.ty = sign * nx;
  }
}

void LineLinker::link(const RidgePoints& ridges, const LinkingSettings& settings) {
  const RidgeArrays& points = ridges.points();
  used_.assign(points.size, 0);
  order_.clear();
  pieces_.clear();
  for (const float level : kSeedLevels) {
    const float least = level * settings.highRidge;
    for (std::uint32_t seed = 0; seed < points.size; ++seed)
      if (used_[seed] == 0 && points.ridge[seed] >= least) linkFrom(ridges, seed, settings.minLength);
  }
}

void LineLinker::linkFrom(const RidgePoints& ridges, std::uint32_t seed, int minLength) {
  used_[seed] = 1;
  const float tx = -ridges.points().ny[seed], ty = ridges.points().nx[seed];
  const std::size_t first = order_.size();
  backward_.clear();
  // What went forward is moved behind what went backward.
  order_.push_back(seed);
  walk(ridges, {seed, tx, ty}, order_);
  walk(ridges, {seed, -tx, -ty}, backward_);
  const std::size_t count = order_.size() - first + backward_.size();
  if (count < static_cast<std::size_t>(minLength)) {
    order_.resize(first);
    return;
  }
  order_.insert(order_.begin() + static_cast<std::ptrdiff_t>(first), backward_.rbegin(), backward_.rend());
  pieces_.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count)});
}

}  // namespace vignole
