#pragma once
// How a camera takes its picture under its faults.

#include <cstdint>
#include <span>

#include "engine/simulator/virtual_rig.h"

namespace vignole::simulator {

/// How a camera takes a frame.
struct CameraShot {
  int camera = 0;
  Extrinsics cameraFromWorld;  ///< where the camera is, which a fault may have moved off its calibration
  bool black = false;          ///< no light, no ambient
  float gain = 1;              ///< on light and ambient alike
};

/// Under the faults black, saturated, move and turn.
[[nodiscard]] CameraShot shotUnder(std::span<const Fault> faults, const RigCalibration& rig, int camera,
                                   std::uint64_t trigger);

}  // namespace vignole::simulator
