#pragma once
// Verdicts with a guard band: within U = 2 u of a limit nothing can be decided.

#include "engine/measurement/measurement.h"

namespace vignole {

/// Sets limits as values and the verdict of one dimension (value, u and nominal are there already). FC is judged as
/// max(0, FC), HF by its largest and its smallest deviation.
void judge(Dimension dimension, const ToleranceLimits& limits, DimensionResult& result);

/// Fail before not measured before near before pass, over the dimensions that have limits.
[[nodiscard]] Verdict worstOf(const PerDimension<DimensionResult>& dimensions);

}  // namespace vignole
