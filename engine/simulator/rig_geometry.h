#pragma once
// Where the cameras and lasers of the virtual rig stand: rig C of the optics design, section 2, with the lasers at 480
// mm, and the small deviations from it that a rig seed draws.

#include <array>
#include <cstdint>

#include "engine/geometry/transform2.h"
#include "engine/optics/calibration.h"

namespace vignole::simulator {

/// A fan of light in the plane z = 0.
struct Laser {
  Point2 positionMm{0, 0};
  Point2 direction{1, 0};  ///< unit, the middle of the fan
  double halfFanRad = 0;
  double wavelengthNm = 660;
};

/// Finder i is camera i + 1 and the laser beside it: upper left, upper right, lower right, lower left.
struct RigGeometry {
  RigCalibration calibration;
  std::array<Laser, kCameraCount> lasers;
  std::array<double, kCameraCount> focusMm{};  ///< distance along the optical axis that is in focus
};

inline constexpr double kFNumber = 8;  ///< the lenses' opening

/// The light planes are z = 0 exactly, so the calibration is exact.
[[nodiscard]] RigGeometry drawRig(std::uint64_t rigSeed);

}  // namespace vignole::simulator
