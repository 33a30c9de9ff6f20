#pragma once
// The drawing of the rig: rig C of the optics design, section 2. What is known of the cameras before any calibration.

#include "engine/geometry/transform2.h"
#include "engine/optics/calibration.h"

namespace vignole {

/// Upper left, upper right, lower right, lower left: camera i + 1 looks at a point of the light plane z = 0.
struct NominalStation {
  Point2 aim{0, 0};
  double azimuthRad = 0;    ///< of the camera, in the light plane
  double elevationRad = 0;  ///< of the camera, out of it
  double distanceMm = 0;    ///< from the aim; what the lens is focused at
};
[[nodiscard]] const std::array<NominalStation, kCameraCount>& nominalStations();

/// Poses, lenses of 16 mm without distortion, light planes z = 0 with their thickness and blur.
[[nodiscard]] const RigCalibration& nominalRig();

/// Camera centre in the world, mm.
[[nodiscard]] Point3 cameraCentre(const Extrinsics& cameraFromWorld);

/// Extrinsics of a camera that stands at distanceMm from `aim` (a point of z = 0), at `azimuthRad` in the plane and
/// `elevationRad` out of it, and looks at it; rows run against z of the world.
[[nodiscard]] Extrinsics lookAt(const Point2& aim, double azimuthRad, double elevationRad, double distanceMm);

}  // namespace vignole
