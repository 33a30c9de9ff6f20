#pragma once
// One Gauss-Newton step of a rigid motion (shift and turn about a centre) from signed distances to primitives, weighted
// by Tukey's biweight.

#include <Eigen/Core>

namespace vignole {

/// Sums of weight * jacobian * jacobian^T and weight * jacobian * residual over points; x, y in mm, a in rad.
struct NormalEquations {
  double xx = 0, xy = 0, xa = 0, yy = 0, ya = 0, aa = 0;
  double bx = 0, by = 0, ba = 0;
  double weight = 0, weightedSquares = 0;

  /// Shift x, y (mm) and turn (rad) that the points ask for; false if they do not determine it.
  [[nodiscard]] bool solve(Eigen::Vector3d& step) const;
  [[nodiscard]] Eigen::Matrix3d matrix() const;
};

}  // namespace vignole
