#pragma once
// A section's own primitives as shapes, for the definitions.

#include "engine/measurement/definitions.h"

namespace vignole {

[[nodiscard]] Shapes nominalShapes(const Section& section);

/// The definitions on the section's own primitives: what nominalDimensions returns, for a plan that is made already.
[[nodiscard]] Expected<PerDimension<std::optional<double>>> nominalDimensions(const Section& section,
                                                                              const SectionPlan& plan,
                                                                              const DimensionParameters& parameters);

}  // namespace vignole
