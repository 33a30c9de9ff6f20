#pragma once
// Which primitives are fitted together: neighbours that the section makes tangent, around the places where dimensions
// are taken.

#include <vector>

#include "engine/measurement/section_plan.h"

namespace vignole {

/// Tangent primitives fitted as one curve. Unknowns: offset and angle of the anchor, the curvature of every arc that is
/// long enough to show it, and the breaks that the data can place (where the curvature jumps); the other breaks stand
/// at the section's arc lengths. Nothing else is taken from the section.
struct ChainPlan {
  std::vector<std::size_t> primitives;  ///< counter-clockwise
  std::size_t anchor = 0;               ///< position in `primitives` of the one that must be there
};

[[nodiscard]] std::vector<ChainPlan> planChains(const Section& section, const SectionPlan& plan);

/// Arcs shorter than this keep the section's curvature: so little of a circle does not tell its radius.
inline constexpr double kShortArcMm = 5;

}  // namespace vignole
