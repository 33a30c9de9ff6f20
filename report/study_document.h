#pragma once
// The report of a parameter study and of the exposure adviser, as documents: verdict, influence, main effects,
// interactions, tables. No Qt here.

#include <string>

#include "calibration/parameter_study/exposure_adviser.h"
#include "calibration/parameter_study/parameter_study.h"
#include "report/document.h"

namespace vignole {

/// `subject`: what was studied, for the head of the pages.
[[nodiscard]] Document studyDocument(const ParameterStudy& study, const std::string& subject);
[[nodiscard]] Document exposureDocument(const ExposureAdvice& advice, const std::string& subject);

}  // namespace vignole
