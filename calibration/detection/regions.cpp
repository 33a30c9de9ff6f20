#include "calibration/detection/regions.h"

#include <cstring>
#include <numeric>

namespace vignole {
namespace {

struct Run {
  int row = 0, first = 0, end = 0;  // pixels first .. end - 1
};

/// Union-find over runs; the root is the earliest.
class Families {
 public:
  void add() { parents_.push_back(static_cast<std::uint32_t>(parents_.size())); }
  std::uint32_t root(std::uint32_t i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    if (a < b)
      parents_[b] = a;
    else
      parents_[a] = b;
  }

 private:
  std::vector<std::uint32_t> parents_;
};

struct Sums {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  bool atBorder = false;
};

void add(Sums& sums, const Run& run, int width, int height) {
  // Relative to the first pixel would be safer against rounding; doubles hold sums of squares over 1e5 px with ease.
  const double n = run.end - run.first, y = run.row;
  const double first = run.first, last = run.end - 1;
  const double x = n * (first + last) / 2;
  const double xx = n * (n * n - 1) / 12 + x * x / n;
  sums.n += n;
  sums.x += x;
  sums.y += n * y;
  sums.xx += xx;
  sums.xy += x * y;
  sums.yy += n * y * y;
  sums.atBorder |= run.row == 0 || run.row == height - 1 || run.first == 0 || run.end == width;
}

}  // namespace

std::vector<Region> regionsOf(std::span<const std::uint8_t> mask, int width, int height, int leastArea) {
  std::vector<Run> runs;
  Families families;
  std::size_t aboveBegin = 0, aboveEnd = 0;
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* row = mask.data() + static_cast<std::ptrdiff_t>(y) * width;
    const std::size_t begin = runs.size();
    std::size_t above = aboveBegin;
    for (int x = 0; x < width;) {
      if (row[x] == 0) {
        // Zeros are many: eight at a time.
        std::uint64_t eight = 0;
        if (x + 8 <= width) std::memcpy(&eight, row + x, 8);
        x += x + 8 <= width && eight == 0 ? 8 : 1;
        continue;
      }
      const int first = x;
      while (x < width && row[x] != 0) ++x;
      const auto id = static_cast<std::uint32_t>(runs.size());
      runs.push_back({y, first, x});
      families.add();
      while (above < aboveEnd && runs[above].end <= first) ++above;
      for (std::size_t i = above; i < aboveEnd && runs[i].first < x; ++i)
        families.join(id, static_cast<std::uint32_t>(i));
    }
    aboveBegin = begin;
    aboveEnd = runs.size();
  }
  std::vector<Sums> sums(runs.size());
  for (std::size_t i = 0; i < runs.size(); ++i)
    add(sums[families.root(static_cast<std::uint32_t>(i))], runs[i], width, height);
  std::vector<Region> regions;
  for (const Sums& s : sums) {
    if (s.n < leastArea) continue;
    Region region;
    region.areaPx = s.n;
    region.centrePx = {s.x / s.n, s.y / s.n};
    const double xy = s.xy / s.n - region.centrePx.x() * region.centrePx.y();
    // A pixel has a width of its own.
    region.covariance << s.xx / s.n - region.centrePx.x() * region.centrePx.x() + 1.0 / 12, xy, xy,
        s.yy / s.n - region.centrePx.y() * region.centrePx.y() + 1.0 / 12;
    region.atBorder = s.atBorder;
    regions.push_back(region);
  }
  return regions;
}

}  // namespace vignole
