#pragma once
// Faults of cameras: which is on, and how a camera takes its picture under them.

#include <cstdint>
#include <span>
#include <string_view>

#include "engine/simulator/virtual_rig.h"

namespace vignole::simulator {

/// How a camera takes a frame.
struct CameraShot {
  int camera = 0;
  Extrinsics cameraFromWorld;  ///< where the camera is, which a fault may have moved off its calibration
  bool black = false;          ///< no light, no ambient
  float gain = 1;              ///< on light and ambient alike
};

/// The last fault of a kind that is on; camera -1: any. Null if none is.
[[nodiscard]] const Fault* activeFault(std::span<const Fault> faults, std::string_view kind, int camera,
                                       std::uint64_t trigger);

/// Under the faults black, saturated, move and turn.
[[nodiscard]] CameraShot shotUnder(std::span<const Fault> faults, const RigCalibration& rig, int camera,
                                   std::uint64_t trigger);

}  // namespace vignole::simulator
