#include "calibration/range_finders/paper_adjustment.h"

namespace vignole {

Expected<void> adjustByPaper(const RigInputs&, const RigAdjustmentSettings&, const Job&, RigAdjustment&) { return {}; }

}  // namespace vignole
