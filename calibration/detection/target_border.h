#pragma once
// Where a target ends, by what the picture shows beside its outer points: for targets that are seen in part, and for
// dot plates, whose frame tells which corner is which.

#include <array>
#include <optional>

#include "calibration/detection/target_search.h"
#include "engine/target/planar_target.h"

namespace vignole {

/// What lies beyond an outer line of a lattice, by its own columns and rows.
enum class Beyond {
  Unknown,
  Margin,  ///< circles: no further dots; chessboard: no further squares; dot plate: the frame
  Outside  ///< the next line would be outside the picture, most of it
};
struct BorderSides {
  Beyond left = Beyond::Unknown, right = Beyond::Unknown, top = Beyond::Unknown, bottom = Beyond::Unknown;
};
[[nodiscard]] BorderSides borderSides(const ImageView& image, const FittedLattice& alongRows,
                                      const PlanarTarget& target);

/// Inside the frame of a dot plate, beside the outer dot nearest to a corner of the target.
enum class FrameCorner { Unseen, Open, Filled };
/// Corner of the lattice: -1 left or top, 1 right or bottom; it is the target's corner as well.
[[nodiscard]] FrameCorner frameCorner(const ImageView& image, const FittedLattice& alongRows, int sideX, int sideY);

}  // namespace vignole
