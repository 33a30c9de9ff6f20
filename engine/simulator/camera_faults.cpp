#include "engine/simulator/camera_faults.h"

#include <Eigen/Geometry>
#include <numbers>

namespace vignole::simulator {

namespace {

constexpr float kSaturatedGain = 12;

}  // namespace

CameraShot shotUnder(std::span<const Fault> faults, const RigCalibration& rig, int camera, std::uint64_t trigger) {
  CameraShot shot;
  shot.camera = camera;
  shot.cameraFromWorld = rig.rangeFinders[static_cast<std::size_t>(camera)].cameraFromWorld;
  shot.black = activeFault(faults, "black", camera, trigger) != nullptr;
  if (activeFault(faults, "saturated", camera, trigger) != nullptr) shot.gain = kSaturatedGain;
  // A camera that shifts goes along its own columns; one that turns pans about its own rows' axis.
  if (const Fault* move = activeFault(faults, "move", camera, trigger))
    shot.cameraFromWorld.translationMm.x() -= move->value;
  if (const Fault* turn = activeFault(faults, "turn", camera, trigger)) {
    const Eigen::Matrix3d pan =
        Eigen::AngleAxisd(turn->value * std::numbers::pi / 180, Eigen::Vector3d::UnitY()).toRotationMatrix();
    shot.cameraFromWorld.rotation = pan * shot.cameraFromWorld.rotation;
    shot.cameraFromWorld.translationMm = pan * shot.cameraFromWorld.translationMm;
  }
  return shot;
}

}  // namespace vignole::simulator
