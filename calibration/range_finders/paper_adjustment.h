#pragma once
// The paper's method for all cameras: one pose each, from the reference placement's picture.

#include "calibration/range_finders/rig_adjustment.h"

namespace vignole {

[[nodiscard]] Expected<void> adjustByPaper(const RigInputs& inputs, const RigAdjustmentSettings& settings,
                                           const Job& job, RigAdjustment& result);

}  // namespace vignole
