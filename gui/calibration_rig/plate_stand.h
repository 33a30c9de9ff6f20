#pragma once
// The pin plate before the virtual rig, moved as a hand would, and what the four cameras make of it.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "calibration/job.h"
#include "calibration/range_finders/association.h"
#include "engine/acquisition/picture_file.h"
#include "engine/simulator/virtual_plate.h"

namespace vignole {

/// Where the plate stands, about the middle of the rig's field.
struct PlatePose {
  double xMm = 0, yMm = 0;  ///< right, up
  double turnDeg = 0;       ///< anticlockwise
  double tiltDeg = 0;       ///< out of the light plane, about the horizontal
};
[[nodiscard]] PlatePlacement placementAt(const PlatePose& pose);
/// How the plate is to be put down, one after the other (optics design, section 1.8); further ones turn and move it.
[[nodiscard]] PlatePose wantedPose(int placement);

/// What a person may have done wrong with the plate, for training.
enum class PlateFault { None, Mirrored, WrongPlate, PinMissing };

struct PlateStandSettings {
  RigInputs known;         ///< the plate as stated, the cameras' intrinsics; no placements
  RigCalibration inForce;  ///< where the cameras stand, roughly
  std::uint64_t rigSeed = 1;
  PlateFault fault = PlateFault::None;
};

/// What the cameras see of one placement, and what was found in it.
struct PlateSight {
  PlatePose pose;  ///< as the hand put it
  std::array<Picture, kCameraCount> pictures;
  PlacementLines lines;                                ///< associated
  std::array<std::vector<int>, kCameraCount> found;    ///< numbers of pins
  std::array<std::vector<int>, kCameraCount> missing;  ///< not found where they should stand in the picture
  std::optional<PlatePose> seen;                       ///< where the plate stands by the pictures
  [[nodiscard]] bool usable() const;                   ///< all four pictures
};

/// Renders, finds lines and pins. `take` tells pictures of one placement apart: noise of its own. For any thread.
[[nodiscard]] Expected<PlateSight> lookAtPlate(const PlateStandSettings& settings, const PlatePose& pose, int placement,
                                               int take, const Job& job);

/// The outlines of the plate's pins towards a camera if the plate stood there: px, a curve each; empty where outside
/// the picture.
[[nodiscard]] std::vector<std::vector<Point2>> pinOutlines(const PlateStandSettings& settings, const PlatePose& pose,
                                                           int camera);

/// The plate of 13 pins with its certificate, U (k = 2) = 3 um.
[[nodiscard]] PinPlate certifiedPlate();

}  // namespace vignole
