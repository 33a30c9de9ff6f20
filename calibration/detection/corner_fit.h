#pragma once
// A chessboard's corner fitted to the grey values themselves: two straight edges that cross, blurred, under light that
// changes evenly. The model and the patch are symmetric about the corner, so what both edges share (bleeding ink, a
// bent characteristic of the sensor) does not move it.

#include <optional>

#include "engine/geometry/image_view.h"
#include "engine/geometry/transform2.h"

namespace vignole {

/// A crossing of two edges. Angles of the edges as undirected lines, rad, 0 along x, turning towards y.
struct Corner {
  Point2 px{0, 0};
  double angle1 = 0, angle2 = 0;
  /// Going from edge 1 to edge 2 with growing angle, by less than 180 degrees, one crosses a bright square.
  bool brightBetween = true;
};

struct CornerFit {
  Corner corner;
  double uPx = 0;         ///< of each coordinate
  double blurPx = 0;      ///< standard deviation of the edges' blur, the pixel's own width included
  double contrastDn = 0;  ///< bright less dark
  double groundDn = 0;    ///< mean of bright and dark
  double noiseDn = 0;     ///< standard deviation of the residuals
  double rmsDn = 0;       ///< of all residuals, outliers too
  double saturatedShare = 0;
  /// Least bright square less most dark one, over their mean difference: 1 for a corner of four even squares.
  double evenness = 0;
};

/// `roomPx`: distance within which there is nothing but the four squares. Nothing where there is no such corner, or it
/// leads away from the start, or out of the picture.
[[nodiscard]] std::optional<CornerFit> fitCorner(const ImageView& image, const Corner& start, double roomPx);

}  // namespace vignole
