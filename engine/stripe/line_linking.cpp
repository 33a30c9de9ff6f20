#include "engine/stripe/line_linking.h"

#include <algorithm>
#include <cmath>

namespace vignole {
namespace {

constexpr std::size_t kLevels = 64;

/// Distance weighs less than leaving the direction: the next point is the one straight ahead.
float stepCost(float along, float across, float turn) { return 0.3F * along + 2 * across + turn; }

struct Neighbour {
  std::ptrdiff_t offset = 0;
  float dx = 0, dy = 0;
};

constexpr std::array<Neighbour, 8> kNeighbours{{{-RidgePoints::kMapPitch - 1, -1, -1},
                                                {-RidgePoints::kMapPitch, 0, -1},
                                                {-RidgePoints::kMapPitch + 1, 1, -1},
                                                {-1, -1, 0},
                                                {1, 1, 0},
                                                {RidgePoints::kMapPitch - 1, -1, 1},
                                                {RidgePoints::kMapPitch, 0, 1},
                                                {RidgePoints::kMapPitch + 1, 1, 1}}};

}  // namespace

// Strongest first, by a counting sort into levels of strength; within a level in reading order.
void LineLinker::collectSeeds(const RidgeArrays& points, float highRidge) {
  std::array<std::uint32_t, kLevels + 1> begin{};
  float strongest = highRidge;
  for (std::size_t i = 0; i < points.size; ++i) strongest = std::max(strongest, points.ridge[i]);
  const float scale = static_cast<float>(kLevels - 1) / strongest;
  seedLevel_.resize(points.size);
  for (std::size_t i = 0; i < points.size; ++i) {
    const std::size_t level = kLevels - 1 - static_cast<std::size_t>(points.ridge[i] * scale);
    seedLevel_[i] = static_cast<std::uint8_t>(points.ridge[i] >= highRidge ? level : kLevels);
    if (seedLevel_[i] < kLevels) ++begin[level + 1];
  }
  for (std::size_t l = 1; l <= kLevels; ++l) begin[l] += begin[l - 1];
  seeds_.resize(begin[kLevels]);
  for (std::size_t i = 0; i < points.size; ++i)
    if (seedLevel_[i] < kLevels) seeds_[begin[seedLevel_[i]]++] = static_cast<std::uint32_t>(i);
}

// The best of the eight neighbours that lie ahead. The others abreast of it, or of the point, are used up on the way.
int LineLinker::successor(const RidgePoints& ridges, const Step& from) {
  const RidgeArrays& points = ridges.points();
  const float x = points.x[from.at], y = points.y[from.at], nx = points.nx[from.at], ny = points.ny[from.at];
  const std::uint16_t* map = ridges.around(from.at);
  std::array<std::pair<std::uint32_t, float>, 8> ahead;  // index, advance along the line
  std::size_t count = 0;
  int best = -1;
  float bestCost = 0, bestAlong = 0;
  for (const Neighbour& n : kNeighbours) {
    const std::uint32_t entry = map[n.offset];
    // Its sub-pixel point may be half a pixel off in both directions: nothing behind that can be ahead.
    if (entry == 0 || n.dx * from.tx + n.dy * from.ty < -0.75F) continue;
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
  collectSeeds(points, settings.highRidge);
  order_.clear();
  pieces_.clear();
  for (const std::uint32_t seed : seeds_) {
    if (used_[seed] != 0) continue;
    used_[seed] = 1;
    const float tx = -points.ny[seed], ty = points.nx[seed];
    const std::size_t first = order_.size();
    backward_.clear();
    // Forward from the seed, then backward; what went forward is moved behind what went backward.
    order_.push_back(seed);
    walk(ridges, {seed, tx, ty}, order_);
    walk(ridges, {seed, -tx, -ty}, backward_);
    const std::size_t count = order_.size() - first + backward_.size();
    if (count < static_cast<std::size_t>(settings.minLength)) {
      order_.resize(first);
      continue;
    }
    order_.insert(order_.begin() + static_cast<std::ptrdiff_t>(first), backward_.rbegin(), backward_.rend());
    pieces_.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count)});
  }
}

}  // namespace vignole
