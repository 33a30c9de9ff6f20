#pragma once
// Tolerance classes as data (resources/rails/tolerances.toml), EN 13674-1 and others.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/geometry/expected.h"
#include "engine/rail/dimension.h"
#include "engine/rail/section.h"

namespace vignole {

/// Allowed deviation from nominal in mm; an empty limit does not judge.
struct ToleranceLimits {
  std::optional<double> lowerMm;
  std::optional<double> upperMm;
};

/// Limits of a section under a profile class ("X", "Y") and a straightness class ("A", "B", which governs HF).
[[nodiscard]] Expected<PerDimension<ToleranceLimits>> toleranceLimits(const Section& section,
                                                                      std::string_view profileClass,
                                                                      std::string_view straightnessClass);
/// The note that goes with the data: edition, and that it is to be checked against the edition in force.
[[nodiscard]] std::string toleranceNote();

}  // namespace vignole
