#pragma once
// Weighted least-squares fits of lines and circles to points, orthogonal distances, with covariance.

#include <Eigen/Core>
#include <span>

#include "engine/geometry/expected.h"
#include "engine/geometry/transform2.h"

namespace vignole {

/// Line through `centroid` at `angleRad`. Covariance of (offset along the normal at the centroid in mm, angle in rad),
/// scaled so that it holds for independent points with the standard deviations that were given.
struct LineFit {
  Point2 centroid{0, 0};
  double angleRad = 0;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  double rmsMm = 0;
  int points = 0;
};

/// Circle; covariance of (centre x, centre y, radius) in mm^2.
struct CircleFit {
  Point2 centre{0, 0};
  double radiusMm = 0;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double rmsMm = 0;
  int points = 0;
};

/// `sigmaMm`: standard deviation of each point along the normal; empty means 1 each. At least 2 distinct points.
[[nodiscard]] Expected<LineFit> fitLine(std::span<const Point2> points, std::span<const double> sigmaMm = {});
/// Geometric (orthogonal distance) fit started from an algebraic one; at least 3 points that are not on a line.
[[nodiscard]] Expected<CircleFit> fitCircle(std::span<const Point2> points, std::span<const double> sigmaMm = {});

}  // namespace vignole
