#include "gui/stripes/line_difference.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace vignole {

namespace {

constexpr float kSamePx = 1.5F;

/// Points by cells of 2 px, so that a neighbour is found without looking at all.
class Neighbours {
 public:
  explicit Neighbours(const StripeResult& stripe) : points_(stripe.points) {
    for (const StripeLine& line : stripe.lines) {
      if (line.rejected()) continue;
      for (std::uint32_t i = line.first; i < line.first + line.count; ++i)
        cells_.emplace_back(cell(column(points_[i].x), column(points_[i].y)), i);
    }
    std::sort(cells_.begin(), cells_.end());
  }

  /// Null: none within 1.5 px.
  [[nodiscard]] const StripePoint* nearest(const StripePoint& to) const {
    const StripePoint* best = nullptr;
    float least = kSamePx * kSamePx;
    for (std::int32_t dy = -1; dy <= 1; ++dy)
      for (std::int32_t dx = -1; dx <= 1; ++dx) {
        const std::uint64_t key = cell(column(to.x) + dx, column(to.y) + dy);
        for (auto at = std::lower_bound(cells_.begin(), cells_.end(), std::pair{key, std::uint32_t{0}});
             at != cells_.end() && at->first == key; ++at) {
          const StripePoint& p = points_[at->second];
          const float squared = (p.x - to.x) * (p.x - to.x) + (p.y - to.y) * (p.y - to.y);
          if (squared <= least) {
            least = squared;
            best = &p;
          }
        }
      }
    return best;
  }

 private:
  static std::int32_t column(float px) { return static_cast<std::int32_t>(std::floor(px / 2)); }
  static std::uint64_t cell(std::int32_t x, std::int32_t y) {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(y)) << 32) | static_cast<std::uint32_t>(x);
  }

  const std::vector<StripePoint>& points_;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> cells_;
};

/// The longest stretch of points without a neighbour.
struct Alone {
  std::size_t points = 0, longest = 0;
  PixelPosition middle;
};

template <typename Met>
Alone walk(const StripeResult& stripe, const Neighbours& others, Met met) {
  Alone alone;
  for (const StripeLine& line : stripe.lines) {
    if (line.rejected()) continue;
    std::size_t run = 0;
    for (std::size_t i = line.first; i < std::size_t{line.first} + line.count; ++i) {
      const StripePoint& point = stripe.points[i];
      if (const StripePoint* other = others.nearest(point)) {
        met(point, *other);
        run = 0;
        continue;
      }
      ++alone.points;
      if (++run <= alone.longest) continue;
      alone.longest = run;
      const StripePoint& middle = stripe.points[i - run / 2];
      alone.middle = {middle.x, middle.y};
    }
  }
  return alone;
}

}  // namespace

LineDifference lineDifference(const StripeResult& before, const StripeResult& after) {
  const Neighbours ofBefore(before), ofAfter(after);
  LineDifference difference;
  double sum = 0;
  std::size_t both = 0;
  PixelPosition furthest;
  const Alone gained = walk(after, ofBefore, [&](const StripePoint& now, const StripePoint& then) {
    // Across the line alone: along it the points of both lie where their pixels are.
    const double shift = std::abs(static_cast<double>((now.x - then.x) * then.nx + (now.y - then.y) * then.ny));
    sum += shift;
    ++both;
    if (shift <= difference.largestShiftPx) return;
    difference.largestShiftPx = shift;
    furthest = {now.x, now.y};
  });
  const Alone lost = walk(before, ofAfter, [](const StripePoint&, const StripePoint&) {});
  difference.gained = gained.points;
  difference.lost = lost.points;
  difference.meanShiftPx = both > 0 ? sum / static_cast<double>(both) : 0;
  if (gained.longest > 0 || lost.longest > 0)
    difference.where = gained.longest >= lost.longest ? gained.middle : lost.middle;
  else if (difference.largestShiftPx > 0)
    difference.where = furthest;
  return difference;
}

}  // namespace vignole
