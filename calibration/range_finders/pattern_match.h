#pragma once
// Circles found in a plane, and the pins of a plate: which is which, for a plate that is turned and shifted in the
// plane, which itself is known but roughly.

#include <span>
#include <vector>

#include "engine/target/pin_plate.h"

namespace vignole {

struct FoundCircle {
  Point2 centreMm{0, 0};
  double radiusMm = 0;
  double uRadiusMm = 0;  ///< standard uncertainty
};

struct PatternMatch {
  Transform2 planeFromPlate;  ///< the turn and shift closest to the pairs
  struct Pair {
    int circle = 0, pin = 0;  ///< indices
  };
  std::vector<Pair> pairs;
  double rmsMm = 0;  ///< of the centres, under a homography (an affine map below 6 pairs)
};

struct PatternSettings {
  double radiusMm = 0.35;  ///< by which radii may disagree, beside their uncertainty and 8 %
  double firstGateMm = 12, secondGateMm = 6, lastGateMm = 2.4;  ///< 60, 30, 12 px in the middle of the rig's field
  int answers = 40;        ///< how many different ones are worked out
};

/// Best first: by the number of pairs, then by rms. Every turn is tried. Answers differ by more than 5 degrees or 8 mm.
[[nodiscard]] std::vector<PatternMatch> matchPattern(std::span<const FoundCircle> circles, std::span<const Pin> pins,
                                                     const PatternSettings& settings);

}  // namespace vignole
