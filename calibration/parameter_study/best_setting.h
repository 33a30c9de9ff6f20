#pragma once
// Which setting a study recommends for a response, and whether the run itself does what the other runs foretell.

#include <vector>

#include "calibration/parameter_study/parameter_study.h"

namespace vignole {

/// `observations`: of the response, on the scale of its analysis. Rule and fields as with runParameterStudy.
[[nodiscard]] std::optional<BestSetting> bestSetting(const ParameterStudy& study, const ResponseStudy& response,
                                                     const std::vector<Observation>& observations);

}  // namespace vignole
