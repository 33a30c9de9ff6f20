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

/// Steps between neighbours -> steps along columns and rows. They differ for asymmetric circles, whose nearest
/// neighbours stand diagonally: there along half columns, and only every second place has a point.
[[nodiscard]] LatticePlace alongRows(const LatticePlace& place, TargetPattern pattern);

/// Column and row in the target (half columns for asymmetric circles, every second row begins at 1).
[[nodiscard]] LatticePlace placed(const LatticePlace& place, const Placing& placing);
/// Index in PlanarTarget::points(); -1 where the target has no point.
[[nodiscard]] int indexOf(const LatticePlace& columnAndRow, const PlanarTarget& target);

/// All placings under which every point of the lattice is one of the target's. Places here and below: along rows.
[[nodiscard]] std::vector<Placing> placings(const std::vector<LatticePlace>& lattice, const PlanarTarget& target,
                                            bool mirrored);

/// Smallest and largest column and row.
struct PlaceBox {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};
[[nodiscard]] PlaceBox boxOf(const std::vector<LatticePlace>& lattice);
/// Number of columns, of asymmetric circles of half columns.
[[nodiscard]] int widthOf(const PlanarTarget& target);

/// Size of what was found, in the target's columns and rows, turned so that it comes closest to the target's size.
[[nodiscard]] std::array<int, 2> sizeOf(const std::vector<LatticePlace>& lattice, const PlanarTarget& target);

}  // namespace vignole
