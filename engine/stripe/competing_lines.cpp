#include "engine/stripe/competing_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace vignole {
namespace {

constexpr std::size_t kSamples = 16;  // of a line that may be a ghost
constexpr std::size_t kStride = 8;    // points of the other, looked at first

struct Box {
  float left = std::numeric_limits<float>::max(), top = left, right = -left, bottom = -left;
};

Box boxOf(std::span<const ChainPoint> line) {
  Box box;
  for (const ChainPoint& c : line) {
    box.left = std::min(box.left, c.point.x);
    box.right = std::max(box.right, c.point.x);
    box.top = std::min(box.top, c.point.y);
    box.bottom = std::max(box.bottom, c.point.y);
  }
  return box;
}

bool near(const Box& a, const Box& b, float distance) {
  return a.left <= b.right + distance && b.left <= a.right + distance && a.top <= b.bottom + distance &&
         b.top <= a.bottom + distance;
}

float distance2(const StripePoint& a, const StripePoint& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

const StripePoint& nearest(std::span<const ChainPoint> line, const StripePoint& p) {
  const auto best = [&](std::size_t first, std::size_t last, std::size_t step) {
    std::size_t at = first;
    for (std::size_t i = first; i < last; i += step)
      if (distance2(line[i].point, p) < distance2(line[at].point, p)) at = i;
    return at;
  };
  const std::size_t coarse = best(0, line.size(), kStride);
  return line[best(coarse - std::min(coarse, kStride), std::min(line.size(), coarse + kStride), 1)].point;
}

bool isGhostOf(std::span<const ChainPoint> weak, std::span<const ChainPoint> strong,
               const CompetitionSettings& limits) {
  const std::size_t samples = std::min(kSamples, weak.size());
  std::size_t votes = 0;
  for (std::size_t k = 0; k < samples; ++k) {
    const StripePoint& p = weak[(2 * k + 1) * weak.size() / (2 * samples)].point;
    const StripePoint& q = nearest(strong, p);
    const float d2 = distance2(p, q), along = -(q.x - p.x) * p.ny + (q.y - p.y) * p.nx;
    const bool beside = d2 <= limits.distancePx * limits.distancePx && along * along <= 0.25F * d2;
    const bool parallel = std::abs(p.nx * q.nx + p.ny * q.ny) >= limits.parallelCosine;
    if (beside && parallel && p.strength < limits.strengthRatio * q.strength) ++votes;
  }
  return static_cast<float>(votes) >= limits.leastShare * static_cast<float>(samples);
}

}  // namespace

void rejectGhosts(std::span<const ChainPoint> points, std::span<LineOfChain> lines,
                  const CompetitionSettings& settings) {
  constexpr std::size_t kMostLines = 64;  // more are texture: no one can tell ghosts there
  if (lines.size() < 2 || lines.size() > kMostLines) return;
  std::array<Box, kMostLines> boxes;
  const auto pointsOf = [&](const LineOfChain& line) { return points.subspan(line.first, line.count); };
  for (std::size_t i = 0; i < lines.size(); ++i) boxes[i] = boxOf(pointsOf(lines[i]));
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t k = 0; k < lines.size() && !lines[i].rejected; ++k)
      if (k != i && near(boxes[i], boxes[k], settings.distancePx))
        lines[i].rejected = isGhostOf(pointsOf(lines[i]), pointsOf(lines[k]), settings);
}

}  // namespace vignole
