#pragma once
// One run of a study on pictures: lines, association, adjustment, as `calibrate rig` does them. What does not change
// from run to run is done once: the lines of an exposure and line filter, and calibrations that differ in nothing that
// acts.

#include <array>
#include <memory>

#include "calibration/parameter_study/exposure_folders.h"
#include "calibration/parameter_study/study_factors.h"
#include "engine/systematic/calibration_error.h"

namespace vignole {

struct TrialMaterial {
  PinPlate plate;
  std::array<CalibratedIntrinsics, kCameraCount> cameras;
  std::vector<ExposedPlacement> placements;
  /// From the errors of a rig to those of the dimensions; none: DimensionU is not observed.
  std::optional<DimensionJacobian> jacobian;
};

/// Placements at several exposures without a factor exposure_ms, levels that no placement was taken at, fewer than one
/// placement are refused: names, what there is.
[[nodiscard]] Expected<void> checkMaterial(const TrialMaterial& material, const StudyPlan& plan);

/// A StudyTrial. Units: every camera in every placement, every camera, the whole.
class CalibrationTrial {
 public:
  CalibrationTrial(TrialMaterial material, StudyPlan plan);
  ~CalibrationTrial();
  CalibrationTrial(const CalibrationTrial&) = delete;
  CalibrationTrial& operator=(const CalibrationTrial&) = delete;

  [[nodiscard]] Expected<StudyRun> operator()(const Combination& combination, const Job& job);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The whole study: design, runs, analysis.
[[nodiscard]] Expected<ParameterStudy> runCalibrationStudy(const StudyPlan& plan, TrialMaterial material,
                                                           const Job& job);

}  // namespace vignole
