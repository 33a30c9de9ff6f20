#pragma once
// Which of many points of a picture is nearest, or lies near.

#include <optional>
#include <span>
#include <vector>

#include "engine/geometry/transform2.h"

namespace vignole {

/// The points must outlive it and stay as they are.
class PointIndex {
 public:
  explicit PointIndex(std::span<const Point2> points);
  /// Within `reach` of `place`.
  [[nodiscard]] std::optional<std::size_t> nearest(const Point2& place, double reach) const;
  /// All within `reach`, nearest first.
  [[nodiscard]] std::vector<std::size_t> within(const Point2& place, double reach) const;

 private:
  template <typename Visit>
  void visit(const Point2& place, double reach, const Visit& visit) const;
  [[nodiscard]] int cellX(double x) const;
  [[nodiscard]] int cellY(double y) const;

  std::span<const Point2> points_;
  Point2 corner_{0, 0};
  double cellPx_ = 1;
  int columns_ = 1, rows_ = 1;
  std::vector<std::size_t> starts_, members_;  // members of cell i: starts_[i] .. starts_[i + 1]
};

}  // namespace vignole
