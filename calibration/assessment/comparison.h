#pragma once
// Two calibrations of one rig, the older and the newer: what has changed between them, in millimetres.

#include <array>
#include <optional>

#include "calibration/assessment/check.h"
#include "engine/geometry/expected.h"
#include "engine/geometry/transform2.h"
#include "engine/optics/rig_uncertainty.h"
#include "engine/rail/dimension.h"
#include "engine/rail/section.h"

namespace vignole {

/// The motion of the world that lays what `other` maps onto what `reference` maps best: of the pixels in which the
/// reference's cameras see the space of a rail.
[[nodiscard]] Transform2 worldOf(const RigCalibration& reference, const RigCalibration& other);

/// How one camera's map of the light plane has moved, and its pose. The worlds of the two calibrations are laid onto
/// each other first, by the places that all four cameras map, so a motion of one camera shows a little in the others.
struct CameraMovement {
  double xMm = 0, yMm = 0;  ///< mean of the places it maps
  double turnDeg = 0;       ///< of them, in the light plane
  double centreMm = 0;      ///< of the camera's centre in space; what the focal length took up is in it
  double poseDeg = 0;       ///< angle between its two orientations
};

struct Comparison {
  PerDimension<double> differenceMm{};  ///< what the older measures of a section that the newer one sees as nominal
  PerDimension<double> uMm{};           ///< standard uncertainty of the difference, the two taken as independent
  std::array<CameraMovement, kCameraCount> cameras;
};
/// The older one may be of a world that lies elsewhere in the plane, turned round, too.
[[nodiscard]] Expected<Comparison> compare(const RigCalibration& older, const RigCalibration& newer,
                                           const Section& section, const DimensionParameters& parameters);
/// "last calibration": worth a look if it fails, no reason to refuse the newer one.
[[nodiscard]] Check comparisonCheck(const Comparison& comparison);

}  // namespace vignole
