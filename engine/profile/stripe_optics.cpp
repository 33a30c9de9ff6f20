#include "engine/profile/stripe_optics.h"

#include <cmath>

#include "engine/optics/camera_model.h"

namespace vignole {

StripeOptics stripeOptics(const RangeFinderCalibration& finder, const MeasuringField& field) {
  StripeOptics optics;
  optics.blurPx = finder.blurPx;
  const Eigen::Vector3d& normal = finder.lightPlane.normal;
  if (std::abs(normal.z()) < 1e-3) return optics;
  const Lens<double> camera = lens(finder.intrinsics);
  const auto &low = field.low, &high = field.high;
  for (const Eigen::Vector2d& corner :
       {low, Eigen::Vector2d(high.x(), low.y()), high, Eigen::Vector2d(low.x(), high.y())}) {
    const double z = (finder.lightPlane.distanceMm - normal.x() * corner.x() - normal.y() * corner.y()) / normal.z();
    const Eigen::Vector3d inCamera = finder.cameraFromWorld.rotation * Eigen::Vector3d(corner.x(), corner.y(), z) +
                                     finder.cameraFromWorld.translationMm;
    const Eigen::Vector2d pixel =
        inCamera.z() > 0 ? projectFromCamera<double>(camera, inCamera) : Eigen::Vector2d(NAN, NAN);
    if (!pixel.allFinite()) return {finder.blurPx, {}};
    optics.field.push_back({static_cast<float>(pixel.x()), static_cast<float>(pixel.y())});
  }
  return optics;
}

}  // namespace vignole
