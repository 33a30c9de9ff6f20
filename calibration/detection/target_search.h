#pragma once
// The search for a target's lattice in a picture, coarse to fine, and its points fitted to a fraction of a pixel.

#include "calibration/detection/labelling.h"
#include "calibration/detection/pattern_points.h"
#include "engine/target/planar_target.h"

namespace vignole {

using FittedLattice = ByPlace<PatternPoint>;

/// The lattice that comes closest to the target; empty where there is none.
[[nodiscard]] FittedLattice searchLattice(const ImageView& picture, const PlanarTarget& target);

[[nodiscard]] std::vector<LatticePlace> placesOf(const FittedLattice& lattice);
[[nodiscard]] ByPlace<Point2> pixelsOf(const FittedLattice& lattice);

}  // namespace vignole
