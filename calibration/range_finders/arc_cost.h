#pragma once
// The residuals of one arc: how far its points lie off the pin in the light plane (optics design, section 1.3).

#include <memory>
#include <vector>

#include "engine/geometry/transform2.h"
#include "engine/optics/rig_uncertainty.h"

namespace ceres {
class CostFunction;
}

namespace vignole {

/// What the unknowns of the adjustment are counted from.
struct CameraBase {
  Intrinsics intrinsics;
  Extrinsics cameraFromWorld;
  /// Change of the first ten CameraParameter per unknown of the intrinsics: lower triangular, L L^T is their covariance.
  Eigen::Matrix<double, 10, 10> intrinsicsFactor = Eigen::Matrix<double, 10, 10>::Zero();
};

/// Blocks of unknowns, in this order: intrinsics (10, in standard deviations), pose (6: turn, then shift, as
/// RigChange), pin (3: x, y in the plate's frame, radius), placement (3: x, y, angle: worldFromPlate).
inline constexpr int kIntrinsicsUnknowns = 10, kPoseUnknowns = 6, kPinUnknowns = 3, kPlacementUnknowns = 3;
inline constexpr int kArcUnknowns = kIntrinsicsUnknowns + kPoseUnknowns + kPinUnknowns + kPlacementUnknowns;

struct ArcCostPoint {
  Point2 px{0, 0};
  double pullMm = 0;   ///< how far the ridge is expected outside of the pin
  double perMm = 1;    ///< weight: residual units per mm
};

/// residual = (distance from the pin's centre - radius - pull) * perMm, one a point.
[[nodiscard]] std::unique_ptr<ceres::CostFunction> arcCost(const CameraBase& camera, std::vector<ArcCostPoint> points);

}  // namespace vignole
