#pragma once
// Where the adjustment starts: the pictures' own poses of the plate put together.

#include <optional>

#include "calibration/range_finders/arc_adjustment.h"

namespace vignole {

/// Over the cameras that have a usable picture; the world is the frame of the plate in the first placement with the
/// most of them. A camera that shares no placement with the others has none of its own: `unconnected`.
struct RigStart {
  ArcStart start;
  std::vector<int> cameras;      ///< connected
  std::vector<int> unconnected;
};
[[nodiscard]] RigStart startState(const RigInputs& inputs, std::span<const int> cameras,
                                  std::optional<int> referencePlacement = {});

}  // namespace vignole
