#include "engine/registration/candidate_grid.h"

#include <algorithm>
#include <numbers>

namespace vignole {

namespace {
constexpr int kBlock = 8;  // cells per side of a block whose candidates are found first
}

CandidateGrid::CandidateGrid(const std::vector<Carrier>& carriers, double cellMm, double marginMm, double reachMm)
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
    const Point2 t = c.startTangent();
    joints_.push_back({static_cast<float>(t.x()), static_cast<float>(t.y()),
                       static_cast<float>(t.x() * c.startX + t.y() * c.startY),
                       static_cast<std::uint16_t>((k == 0 ? carriers_.size() : k) - 1)});
  }
  x0_ -= marginMm;
  y0_ -= marginMm;
  const auto cells = [&](double extent) { return static_cast<int>(std::ceil((extent + marginMm) * perCell_)); };
  columns_ = (cells(x1 - x0_) / kBlock + 1) * kBlock;
  rows_ = (cells(y1 - y0_) / kBlock + 1) * kBlock;

  // A primitive that is nearest to some point of a square lies no further from its middle than the primitive nearest
  // to the middle plus one diagonal. A little more, because single precision may name the cell beside.
  const double diagonal = cellMm * std::numbers::sqrt2 + 1e-3;
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
      const double x = x0_ + (column + 0.5) * cellMm, y = y0_ + (row + 0.5) * cellMm;
      const double distance = keepNear(ofBlock[static_cast<std::size_t>(column / kBlock)], x, y, diagonal, kept);
      candidates_.insert(candidates_.end(), kept.begin(), kept.end());
      first_.push_back(static_cast<std::uint32_t>(candidates_.size()));
      const bool far = distance > reachMm + diagonal / 2;
      codes_.push_back(far ? static_cast<std::uint16_t>(kFarAway | nearestOf(kept, x, y))
                           : codeOf(kept, x, y, diagonal / 2));
    }
  }
}

double CandidateGrid::keepNear(const std::vector<std::uint16_t>& from, double x, double y, double reachMm,
                               std::vector<std::uint16_t>& kept) {
  double best = 1e300;
  for (const std::uint16_t k : from) {
    distances_[k] = std::sqrt(carriers_[k].squaredDistance(x, y));
    best = std::min(best, distances_[k]);
  }
  kept.clear();
  for (const std::uint16_t k : from)
    if (distances_[k] <= best + reachMm) kept.push_back(k);
  return best;
}

std::uint16_t CandidateGrid::codeOf(const std::vector<std::uint16_t>& kept, double x, double y,
                                    double halfDiagonalMm) const {
  if (kept.size() == 1) return static_cast<std::uint16_t>(kSingle | kept[0]);
  if (kept.size() == 2)
    for (const std::size_t after : {0U, 1U}) {
      const std::uint16_t k = kept[after], before = kept[1 - after];
      if (joints_[k].before != before) continue;
      // The normal at a joint divides the points of the two up to where the normals of a bend meet.
      const double away = std::hypot(x - carriers_[k].startX, y - carriers_[k].startY) + halfDiagonalMm;
      if (away < carriers_[k].bendRadius() && away < carriers_[before].bendRadius())
        return static_cast<std::uint16_t>(kJoint | k);
    }
  return static_cast<std::uint16_t>(kSeveral | nearestOf(kept, x, y));
}

std::uint16_t CandidateGrid::nearestOf(std::span<const std::uint16_t> list, double x, double y) const {
  std::uint16_t best = list[0];
  if (list.size() == 1) return best;
  double least = carriers_[best].squaredDistance(x, y);
  for (const std::uint16_t k : list.subspan(1)) {
    const double d = carriers_[k].squaredDistance(x, y);
    if (d < least) {
      least = d;
      best = k;
    }
  }
  return best;
}

CellFrame CandidateGrid::frame() const {
  return {static_cast<float>(x0_), static_cast<float>(y0_), static_cast<float>(perCell_), columns_, rows_};
}

}  // namespace vignole
