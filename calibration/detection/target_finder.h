#pragma once
// Finds a flat target in a picture, to a fraction of a pixel.

#include <string>
#include <vector>

#include "engine/geometry/expected.h"
#include "engine/geometry/image_view.h"
#include "engine/target/planar_target.h"

namespace vignole {

struct FoundPoint {
  int index = 0;  ///< in PlanarTarget::points()
  Point2 px{0, 0};
  double uPx = 0;  ///< standard uncertainty of each coordinate, by the point's own edges and noise
};

/// One picture of a target. Points of circles are centres of ellipses: who projects them shifts the point of the plane
/// by -r^2 h / w (optics design, section 1.2) or uses circleCentreInPlane().
struct TargetView {
  std::string file;
  int widthPx = 0, heightPx = 0;
  std::vector<FoundPoint> points;
  std::string refusal;    ///< empty, or why the picture is of no use and what to do: blur, saturation, too small ...
  bool partial = false;   ///< part of the target lies outside the picture or was not found
  double blurPx = 0;      ///< standard deviation of the edges' blur, the pixel's own width included
  double pitchPx = 0;     ///< distance of neighbours along the shorter side, median over the target
  double obliqueDeg = 0;  ///< angle between the line of sight and the target's normal, about
  double saturatedShare = 0;  ///< of the points: in clipped light
  [[nodiscard]] bool usable() const { return refusal.empty(); }
};

struct TargetFinderSettings {
  double maxBlurPx = 4;
  double minPointDistancePx = 8;  ///< below: too small
  double maxObliqueDeg = 65;
};

[[nodiscard]] TargetView findTarget(const ImageView& image, const PlanarTarget& target,
                                    const TargetFinderSettings& settings = {});

}  // namespace vignole
