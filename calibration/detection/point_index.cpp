#include "calibration/detection/point_index.h"

#include <algorithm>
#include <cmath>

namespace vignole {

PointIndex::PointIndex(std::span<const Point2> points) : points_(points) {
  if (points_.empty()) {
    starts_.assign(2, 0);
    return;
  }
  Point2 low = points_.front(), high = points_.front();
  for (const Point2& p : points_) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  corner_ = low;
  const Point2 size = high - low;
  // About two points a cell.
  const double area = std::max(size.x(), 1.0) * std::max(size.y(), 1.0);
  cellPx_ = std::max(1.0, std::sqrt(2 * area / static_cast<double>(points_.size())));
  columns_ = 1 + static_cast<int>(size.x() / cellPx_);
  rows_ = 1 + static_cast<int>(size.y() / cellPx_);
  const auto cellOf = [this](const Point2& p) {
    return static_cast<std::size_t>(cellY(p.y())) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(cellX(p.x()));
  };
  starts_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  for (const Point2& p : points_) ++starts_[cellOf(p) + 1];
  for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  std::vector<std::size_t> next = starts_;
  members_.resize(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) members_[next[cellOf(points_[i])]++] = i;
}

int PointIndex::cellX(double x) const {
  return static_cast<int>(std::clamp((x - corner_.x()) / cellPx_, 0.0, static_cast<double>(columns_ - 1)));
}
int PointIndex::cellY(double y) const {
  return static_cast<int>(std::clamp((y - corner_.y()) / cellPx_, 0.0, static_cast<double>(rows_ - 1)));
}

template <typename Visit>
void PointIndex::visit(const Point2& place, double reach, const Visit& visit) const {
  const int x0 = cellX(place.x() - reach), x1 = cellX(place.x() + reach);
  const int y0 = cellY(place.y() - reach), y1 = cellY(place.y() + reach);
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) {
      const std::size_t cell =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
      for (std::size_t i = starts_[cell]; i < starts_[cell + 1]; ++i) {
        const double distance = (points_[members_[i]] - place).norm();
        if (distance <= reach) visit(members_[i], distance);
      }
    }
}

std::optional<std::size_t> PointIndex::nearest(const Point2& place, double reach) const {
  std::optional<std::size_t> best;
  double bestDistance = 0;
  visit(place, reach, [&](std::size_t i, double distance) {
    if (best && (distance > bestDistance || (distance == bestDistance && i > *best))) return;
    best = i;
    bestDistance = distance;
  });
  return best;
}

std::vector<std::size_t> PointIndex::within(const Point2& place, double reach) const {
  std::vector<std::pair<double, std::size_t>> found;
  visit(place, reach, [&](std::size_t i, double distance) { found.emplace_back(distance, i); });
  std::sort(found.begin(), found.end());
  std::vector<std::size_t> indices;
  indices.reserve(found.size());
  for (const auto& [distance, i] : found) indices.push_back(i);
  return indices;
}

}  // namespace vignole
