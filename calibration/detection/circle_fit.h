#pragma once
// A dot's edge fitted to the grey values themselves: an ellipse, blurred, under light that changes evenly.

#include <Eigen/LU>
#include <optional>

#include "engine/geometry/image_view.h"
#include "engine/geometry/transform2.h"

namespace vignole {

/// (x, y) is on the ellipse where |toUnitCircle ((x, y) - centre)| = 1; pixels.
struct DotEllipse {
  Point2 centrePx{0, 0};
  Eigen::Matrix2d toUnitCircle = Eigen::Matrix2d::Identity();  ///< upper triangular
  [[nodiscard]] double areaPx() const;
  /// Half the longest and half the shortest diameter.
  [[nodiscard]] Eigen::Vector2d semiAxesPx() const;
};
/// The ellipse whose inside has this covariance (of its area).
[[nodiscard]] DotEllipse ellipseOfMoments(const Point2& centrePx, const Eigen::Matrix2d& covariance);

struct DotFit {
  DotEllipse ellipse;
  double uPx = 0;             ///< of each coordinate of the centre
  double blurPx = 0;          ///< standard deviation of the edge's blur, the pixel's own width included
  double contrastDn = 0;      ///< inside less outside
  double groundDn = 0;        ///< outside
  double noiseDn = 0;         ///< standard deviation of the residuals
  double rmsDn = 0;           ///< of all residuals, outliers too
  double saturatedShare = 0;  ///< of the pixels about the edge
};

/// `roomRatio`: how far from the centre there is nothing but the dot and its ground, in radii of the dot (> 1).
/// Nothing where there is no such edge, or it leads away from the start, or out of the picture.
[[nodiscard]] std::optional<DotFit> fitCircle(const ImageView& image, const DotEllipse& start, double roomRatio);

}  // namespace vignole
