#include "engine/stripe/line_linking.h"

#include <algorithm>
#include <cmath>

namespace vignole {
namespace {

constexpr std::size_t kLevels = 64;

/// Distance weighs less than leaving the direction: the next point is the one straight ahead.
float stepCost(float along, float across, float turn) { return 0.3F * along + 2 * across + turn; }

}  // namespace

// Strongest first, by a counting sort into levels of strength; within a level in reading order.
void LineLinker::collectSeeds(const std::vector<RidgePoint>& points, float highRidge) {
  std::array<std::uint32_t, kLevels + 1> begin{};
  float strongest = highRidge;
  for (const RidgePoint& p : points) strongest = std::max(strongest, p.ridge);
  const float scale = static_cast<float>(kLevels - 1) / strongest;
  seedLevel_.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto level = kLevels - 1 - static_cast<std::size_t>(points[i].ridge * scale);
    seedLevel_[i] = static_cast<std::uint8_t>(points[i].ridge >= highRidge ? level : kLevels);
    if (seedLevel_[i] < kLevels) ++begin[level + 1];
  }
  for (std::size_t l = 1; l <= kLevels; ++l) begin[l] += begin[l - 1];
  seeds_.resize(begin[kLevels]);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (seedLevel_[i] < kLevels) seeds_[begin[seedLevel_[i]]++] = static_cast<std::uint32_t>(i);
}

// The best of the eight neighbours that lie ahead. The others abreast of it, or of p, are used up on the way.
int LineLinker::successor(const RidgePoints& ridges, const RidgePoint& p, float tx, float ty) {
  std::array<std::pair<int, float>, 8> ahead{};  // index, advance along the line
  std::size_t count = 0;
  int best = -1;
  float bestCost = 0, bestAlong = 0;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      // Its sub-pixel point may be half a pixel off in both directions: nothing behind that can be ahead.
      if ((dx == 0 && dy == 0) || static_cast<float>(dx) * tx + static_cast<float>(dy) * ty < -0.75F) continue;
      const int index = ridges.indexAt(p.column + dx, p.row + dy);
      if (index < 0 || used_[static_cast<std::size_t>(index)] != 0) continue;
      const RidgePoint& q = ridges.points()[static_cast<std::size_t>(index)];
      const float ex = q.x - p.x, ey = q.y - p.y;
      const float along = ex * tx + ey * ty, across = std::abs(ex * ty - ey * tx);
      ahead[count++] = {index, along};
      if (along <= 0.05F) continue;
      const float cost = stepCost(along, across, 1 - std::abs(q.nx * p.nx + q.ny * p.ny));
      if (best < 0 || cost < bestCost) {
        best = index;
        bestCost = cost;
        bestAlong = along;
      }
    }
  if (best < 0) return best;
  for (std::size_t i = 0; i < count; ++i)
    if (ahead[i].first != best && (std::abs(ahead[i].second) < 0.35F || std::abs(ahead[i].second - bestAlong) < 0.35F))
      used_[static_cast<std::size_t>(ahead[i].first)] = 1;
  return best;
}

// Noise can leave a pixel without a point where the line passes from one row of pixels to the next: look one further.
int LineLinker::successorBeyond(const RidgePoints& ridges, const RidgePoint& p, float tx, float ty) const {
  int best = -1;
  float bestCost = 0;
  for (int dy = -2; dy <= 2; ++dy)
    for (int dx = -2; dx <= 2; ++dx) {
      if (std::max(std::abs(dx), std::abs(dy)) < 2) continue;
      const int index = ridges.indexAt(p.column + dx, p.row + dy);
      if (index < 0 || used_[static_cast<std::size_t>(index)] != 0) continue;
      const RidgePoint& q = ridges.points()[static_cast<std::size_t>(index)];
      const float ex = q.x - p.x, ey = q.y - p.y;
      const float along = ex * tx + ey * ty, across = std::abs(ex * ty - ey * tx);
      if (along < 1 || across > 0.5F * along || std::abs(q.nx * p.nx + q.ny * p.ny) < 0.85F) continue;
      const float cost = stepCost(along, across, 0);
      if (best < 0 || cost < bestCost) {
        best = index;
        bestCost = cost;
      }
    }
  return best;
}

void LineLinker::walk(const RidgePoints& ridges, std::uint32_t from, float tx, float ty,
                      std::vector<std::uint32_t>& out) {
  out.clear();
  const RidgePoint* p = &ridges.points()[from];
  for (;;) {
    int next = successor(ridges, *p, tx, ty);
    if (next < 0) next = successorBeyond(ridges, *p, tx, ty);
    if (next < 0) return;
    used_[static_cast<std::size_t>(next)] = 1;
    out.push_back(static_cast<std::uint32_t>(next));
    p = &ridges.points()[static_cast<std::size_t>(next)];
    const float sign = -p->ny * tx + p->nx * ty < 0 ? -1.0F : 1.0F;
    tx = -sign * p->ny;
    ty = sign * p->nx;
  }
}

void LineLinker::link(const RidgePoints& ridges, const LinkingSettings& settings) {
  const std::vector<RidgePoint>& points = ridges.points();
  used_.assign(points.size(), 0);
  collectSeeds(points, settings.highRidge);
  points_.clear();
  pieces_.clear();
  for (const std::uint32_t seed : seeds_) {
    if (used_[seed] != 0) continue;
    used_[seed] = 1;
    const float tx = -points[seed].ny, ty = points[seed].nx;
    walk(ridges, seed, tx, ty, forward_);
    walk(ridges, seed, -tx, -ty, backward_);
    const std::size_t count = forward_.size() + backward_.size() + 1;
    if (count < static_cast<std::size_t>(settings.minLength)) continue;
    pieces_.push_back({static_cast<std::uint32_t>(points_.size()), static_cast<std::uint32_t>(count)});
    for (auto i = backward_.rbegin(); i != backward_.rend(); ++i) points_.push_back(points[*i]);
    points_.push_back(points[seed]);
    for (const std::uint32_t i : forward_) points_.push_back(points[i]);
  }
}

}  // namespace vignole
