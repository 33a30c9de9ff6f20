#pragma once
// Connected regions of a mask, by their moments.

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/transform2.h"

namespace vignole {

struct Region {
  double areaPx = 0;
  Point2 centrePx{0, 0};
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< of its area, px^2
  bool atBorder = false;                                 ///< touches the picture's border
};

/// Pixels that are not 0, connected by their sides; row-major without padding. Regions of less than `leastArea` pixels
/// are left out. In the order of their first pixels.
[[nodiscard]] std::vector<Region> regionsOf(std::span<const std::uint8_t> mask, int width, int height, int leastArea);

}  // namespace vignole
