#pragma once
// The parameter study on the virtual rig: placements of the plate at every exposure that is asked for, and the study
// over them.

#include <string>

#include "calibration/parameter_study/calibration_trial.h"
#include "calibration/range_finders/rig_adjustment.h"

namespace vignole {

struct VirtualStudySettings {
  StudyPlan plan;
  RigInputs known;  ///< plate and cameras' intrinsics
  std::uint64_t rigSeed = 1;
  int placements = 2;
  Section section;
  DimensionParameters parameters;
  RigCalibration rig;  ///< where the dimensions' derivatives are taken
  std::string folder;  ///< for the pictures: empty, there
};

/// Renders (a fifth of the way), then runs the study.
[[nodiscard]] Expected<ParameterStudy> runVirtualStudy(const VirtualStudySettings& settings, const Job& job);

}  // namespace vignole
