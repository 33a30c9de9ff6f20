#include "engine/registration/candidate_grid.h"

#include <algorithm>
#include <numbers>

namespace vignole {

namespace {
constexpr int kBlock = 8;  // cells per side of a block whose candidates are found first
}

CandidateGrid::CandidateGrid(const std::vector<Carrier>& carriers, double cellMm, double marginMm)
    : carriers_(carriers), perCell_(1 / cellMm), distances_(carriers.size()) {
  double x1 = -1e300, y1 = -1e300;
  x0_ = y0_ = 1e300;
  for (std::size_t k = 0; k < carriers_.size(); ++k) {
    const Carrier& c = carriers_[k];
    x0_ = std::min({x0_, c.startX, c.endX});
    x1 = std::max({x1, c.startX, c.endX});
    y0_ = std::min({y0_, c.startY, c.endY});
    y1 = std::max({y1, c.startY, c.endY});
    all_.push_back(static_cast<std::uint16_t>(k));
  }
  x0_ -= marginMm;
  y0_ -= marginMm;
  const auto cells = [&](double extent) { return static_cast<int>(std::ceil((extent + marginMm) * perCell_)); };
  columns_ = (cells(x1 - x0_) / kBlock + 1) * kBlock;
  rows_ = (cells(y1 - y0_) / kBlock + 1) * kBlock;

  // A primitive that is nearest to some point of a square lies no further from its middle than the primitive nearest
  // to the middle plus one diagonal.
  const double diagonal = cellMm * std::numbers::sqrt2 + 1e-9;
  const int blocks = columns_ / kBlock;
  std::vector<std::vector<std::uint16_t>> ofBlock(static_cast<std::size_t>(blocks));
  std::vector<std::uint16_t> kept;
  first_.push_back(0);
  for (int row = 0; row < rows_; ++row) {
    if (row % kBlock == 0)
      for (int b = 0; b < blocks; ++b)
        keepNear(all_, x0_ + (b + 0.5) * kBlock * cellMm, y0_ + (row + 0.5 * kBlock) * cellMm, kBlock * diagonal,
                 ofBlock[static_cast<std::size_t>(b)]);
    for (int column = 0; column < columns_; ++column) {
      keepNear(ofBlock[static_cast<std::size_t>(column / kBlock)], x0_ + (column + 0.5) * cellMm,
               y0_ + (row + 0.5) * cellMm, diagonal, kept);
      candidates_.insert(candidates_.end(), kept.begin(), kept.end());
      first_.push_back(static_cast<std::uint32_t>(candidates_.size()));
    }
  }
}

void CandidateGrid::keepNear(const std::vector<std::uint16_t>& from, double x, double y, double reachMm,
                             std::vector<std::uint16_t>& kept) {
  double best = 1e300;
  for (const std::uint16_t k : from) {
    distances_[k] = std::sqrt(carriers_[k].squaredDistance(x, y));
    best = std::min(best, distances_[k]);
  }
  kept.clear();
  for (const std::uint16_t k : from)
    if (distances_[k] <= best + reachMm) kept.push_back(k);
}

std::uint16_t CandidateGrid::nearestOf(const std::uint16_t* list, std::size_t count, double x, double y) const {
  std::uint16_t best = list[0];
  double least = carriers_[best].squaredDistance(x, y);
  for (std::size_t m = 1; m < count; ++m) {
    const double d = carriers_[list[m]].squaredDistance(x, y);
    if (d < least) {
      least = d;
      best = list[m];
    }
  }
  return best;
}

}  // namespace vignole
