#pragma once
// What OpenCV's calibrateCamera makes of the same points with as many parameters: a second opinion.

#include <optional>

#include "calibration/intrinsics/target_adjustment.h"

namespace vignole {

struct OpenCvReference {
  double rmsPx = 0;
  double fxPx = 0, fyPx = 0, cxPx = 0, cyPx = 0;
  double k1 = 0, k2 = 0, p1 = 0, p2 = 0, k3 = 0;
  int parameters = 0;  ///< intrinsic ones that it estimated
};

/// `observations` as used, with the target's points as the adjustment has them. The division model is answered by k1
/// alone. OpenCV takes centres of ellipses for images of centres of circles and weighs all points alike. Nothing where
/// it fails.
[[nodiscard]] std::optional<OpenCvReference> openCvReference(const TargetObservations& observations,
                                                             const std::vector<Eigen::Vector3d>& points,
                                                             const LensVariant& variant, const Intrinsics& like);

}  // namespace vignole
