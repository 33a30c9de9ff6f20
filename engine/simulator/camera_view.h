#pragma once
// A camera of the virtual rig as the renderers need it: where points of the light plane are seen, how much of each
// laser's light the filter passes, and how light is blurred there.

#include <array>

#include "engine/optics/camera_model.h"
#include "engine/simulator/light_kernels.h"
#include "engine/simulator/rail_motion.h"
#include "engine/simulator/rig_geometry.h"

namespace vignole::simulator {

class CameraView {
 public:
  /// `cameraFromWorld`: where the camera is, which a fault may have moved off its calibration.
  CameraView(const RigGeometry& rig, int camera, const Extrinsics& cameraFromWorld, double crosstalk, double defocus);
  [[nodiscard]] Eigen::Vector2d pixel(const Point2& world, double z = 0) const {
    return project<double>(lens, rotation, translation, {world.x(), world.y(), z});
  }
  /// The blur of light on a sheet of that thickness: by sheet, lens, pixel and movement within the exposure.
  [[nodiscard]] SplatKernel kernelAt(const ExposedPose& pose, const Point2& world, double sheetSigmaMm,
                                     double offPlaneMm) const;

  Lens<double> lens;
  Eigen::Matrix3d rotation;
  Point3 translation;
  Point3 centre;
  std::array<double, kCameraCount> passes{};  ///< share of each laser's light that the filter lets through
  double sheetSigmaMm;

 private:
  double focusMm_, defocus_, wavelengthNm_;
};

}  // namespace vignole::simulator
