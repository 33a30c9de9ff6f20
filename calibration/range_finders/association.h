#pragma once
// Which arc is which pin (optics design, section 1.9, "Robust"): by the drawing of the rig, without it by brute force.

#include <array>
#include <string>
#include <vector>

#include "calibration/range_finders/pin_lines.h"
#include "calibration/range_finders/rig_adjustment.h"
#include "engine/optics/nominal_rig.h"

namespace vignole {

struct AssociationSettings {
  RigCalibration drawing = nominalRig();  ///< where the cameras stand, to some 10 mm and 2 degrees
  bool useDrawing = true;                 ///< false: any pose of a camera, by homographies alone
  int fewestPins = 6;
  double maxRmsMm = 0.6;     ///< of the pins' centres under a homography of the drawing's plane
  double radiusMm = 0.35;    ///< largest disagreement of a radius
  double uniqueness = 3;     ///< so much worse must the second best answer be
};

/// Sets PinArc::pin and reason, PinPicture::refusal and cameraFromPlate of every picture. The four pictures of a
/// placement are judged together: cameras that were swapped, a plate that is mirrored or not that of the file are told
/// apart from pins that are missing.
void associate(RigInputs& inputs, const AssociationSettings& settings = {});

}  // namespace vignole
