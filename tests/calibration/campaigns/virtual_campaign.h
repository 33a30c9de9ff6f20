#pragma once
// Whole campaigns on the virtual rig: pictures of a plate rendered, lines extracted, as a calibration gets them, with
// the truth beside.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "calibration/range_finders/rig_adjustment.h"
#include "engine/rail/dimension.h"
#include "engine/simulator/virtual_plate.h"

namespace vignole {

struct CampaignSettings {
  std::uint64_t seed = 1;  ///< of plate, intrinsics, noise
  std::uint64_t rigSeed = 1;
  int placements = 4;
  double plateErrorMm = 0.05;  ///< rectangular; radii a fifth
  double noisePx = 0.1;        ///< 0: none at all
  bool intrinsicsErr = true;
  int spurious = 0;    ///< bright arcs that are no pins, per picture
  double turnDeg = 0;  ///< the plate turned further in all placements
  double shiftMm = 0;  ///< and shifted, drawn: standard deviation
  PinLineSettings lines;
  PinPlate plate = plate13();
  std::vector<int> missingPins;
};

struct Campaign {
  std::shared_ptr<const VirtualPlate> plate;
  RigInputs inputs;  ///< not yet associated
};

[[nodiscard]] Campaign renderCampaign(const CampaignSettings& settings);
/// As a calibration errs: f by 5e-4, principal point by 1.5 px, kappa by 3e-3 / f^2 (optics design, section 1.8).
[[nodiscard]] CalibratedIntrinsics disturbedIntrinsics(const RangeFinderCalibration& truth, int camera,
                                                       std::uint64_t seed);
/// Every arc's pin by the truth.
void associateByTruth(Campaign& campaign);
/// What the calibration is off by, in the parameters of the rig.
[[nodiscard]] RigChange errorOf(const RigCalibration& found, const RigCalibration& truth);

/// One campaign from pictures to what it is worth.
struct CampaignOutcome {
  std::string refusal;                  ///< empty, or why there is no calibration
  PerDimension<double> errorMm{};       ///< of a 60E1, seen by the true rig and measured by the one found
  PerDimension<double> uMm{};           ///< as stated
  double cdMm = 0, rdMm = 0, pdMm = 0;  ///< means of the four cameras
  double reprojectionPx = 0;
  double solveS = 0;
};
[[nodiscard]] CampaignOutcome calibrated(Campaign& campaign, const RigAdjustmentSettings& settings);

/// Pictures whose pins were all told rightly, at least six of them; of all pictures.
[[nodiscard]] std::pair<int, int> rightlyAssociated(const Campaign& campaign);

}  // namespace vignole
