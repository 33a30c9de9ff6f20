#pragma once
// Where a target ends, by what the picture shows beside its outer points: for targets that are seen in part, and for
// dot plates, whose frame tells which corner is which.

#include <array>
#include <optional>

#include "calibration/detection/target_search.h"
#include "engine/target/planar_target.h"

namespace vignole {

/// Of the lattice's own columns and rows: whether its outer line is the target's, since beyond it the picture shows
/// the margin (circles: no further dots; chessboard: no further squares; dot plate: the frame). False: not known.
struct BorderSides {
  bool left = false, right = false, top = false, bottom = false;
};
[[nodiscard]] BorderSides borderSides(const ImageView& image, const FittedLattice& alongRows,
                                      const PlanarTarget& target);

/// Inside the frame of a dot plate, beside the outer dot nearest to a corner of the target.
enum class FrameCorner { Unseen, Open, Filled };
/// Corner of the lattice: -1 left or top, 1 right or bottom; it is the target's corner as well.
[[nodiscard]] FrameCorner frameCorner(const ImageView& image, const FittedLattice& alongRows, int sideX, int sideY);

}  // namespace vignole
