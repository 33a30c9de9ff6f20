#pragma once
// The calibration of one camera's lens as a report: Table III, the parameters by name, coverage, residuals, views.

#include "calibration/intrinsics/intrinsics_calibration.h"
#include "engine/acquisition/picture_file.h"
#include "report/document.h"

namespace vignole {

struct IntrinsicsReport {
  const IntrinsicsCalibration* calibration = nullptr;
  const PlanarTarget* target = nullptr;
  std::vector<const Picture*> pictures;  ///< as the views, Fig. 7; null or absent: none
  std::string advice;                    ///< the next pose in words; empty: none
};

/// Points of all views, and the mean residual by place, with a note on its magnification.
[[nodiscard]] PlotBlock lensMaps(const IntrinsicsCalibration& calibration);
[[nodiscard]] Document intrinsicsDocument(const IntrinsicsReport& report);

}  // namespace vignole
