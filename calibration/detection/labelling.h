#pragma once
// Which points of a target the points of a lattice are, by the lattice's outline alone.

#include <array>
#include <string>
#include <vector>

#include "calibration/detection/lattice.h"
#include "engine/target/planar_target.h"

namespace vignole {

/// A way to lay a found lattice over the target: turned by quarters, mirrored or not, shifted.
struct Placing {
  int quarterTurns = 0;
  bool mirrored = false;
  int shiftX = 0, shiftY = 0;
};

/// Column and row of a target's point, of asymmetric circles in half columns (every second row begins at 1).
[[nodiscard]] LatticePlace placed(const LatticePlace& place, const Placing& placing, TargetPattern pattern);
/// Index in PlanarTarget::points(); -1 where the target has no point.
[[nodiscard]] int indexOf(const LatticePlace& columnAndRow, const PlanarTarget& target);

/// All placings under which every point of the lattice is one of the target's.
[[nodiscard]] std::vector<Placing> placings(const std::vector<LatticePlace>& lattice, const PlanarTarget& target,
                                            bool mirrored);

/// Size of what was found, in the target's columns and rows, turned so that it comes closest to the target's size.
[[nodiscard]] std::array<int, 2> sizeOf(const std::vector<LatticePlace>& lattice, const PlanarTarget& target);

}  // namespace vignole
