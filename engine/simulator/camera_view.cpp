#include "engine/simulator/camera_view.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/optics/nominal_rig.h"

namespace vignole::simulator {

namespace {

constexpr double kPixelSigmaPx = 0.28867513459481287;  // of a square pixel: 1/sqrt(12)
constexpr int kMostReachPx = kMargin - 8;

constexpr double kernelReach(double sigma) { return 4 * sigma; }

}  // namespace

CameraView::CameraView(const RigGeometry& rig, int camera, const Extrinsics& cameraFromWorld, double crosstalk,
                       double defocus)
    : lens(vignole::lens(rig.calibration.rangeFinders[static_cast<std::size_t>(camera)].intrinsics)),
      rotation(cameraFromWorld.rotation),
      translation(cameraFromWorld.translationMm),
      centre(cameraCentre(cameraFromWorld)),
      sheetSigmaMm(rig.calibration.rangeFinders[static_cast<std::size_t>(camera)].lightPlane.thicknessMm),
      focusMm_(rig.focusMm[static_cast<std::size_t>(camera)]),
      defocus_(defocus),
      wavelengthNm_(rig.lasers[static_cast<std::size_t>(camera)].wavelengthNm) {
  for (std::size_t i = 0; i < kCameraCount; ++i)
    passes[i] = rig.lasers[i].wavelengthNm == wavelengthNm_ ? 1 : crosstalk;
}

SplatKernel CameraView::kernelAt(const ExposedPose& pose, const Point2& world, double sheetMm,
                                 double offPlaneMm) const {
  const Point3 inCamera = rotation * Point3(world.x(), world.y(), offPlaneMm) + translation;
  const double z = inCamera.z();
  const double fx = lens.focalMm / lens.pixelWidthMm / z, fy = lens.focalMm / lens.pixelHeightMm / z;
  Eigen::Matrix<double, 2, 3> j;  // d pixel / d world; the lens' distortion changes it by less than 2 %
  j.row(0) = fx * (rotation.row(0) - inCamera.x() / z * rotation.row(2));
  j.row(1) = fy * (rotation.row(1) - inCamera.y() / z * rotation.row(2));

  // Lens: disk of confusion of a thin lens that is focused at the aim (variance d^2/16), diffraction, pixel.
  const double aperture = lens.focalMm / kFNumber;
  const double disk =
      defocus_ * aperture * lens.focalMm / (focusMm_ - lens.focalMm) * std::abs(z - focusMm_) / z / lens.pixelWidthMm;
  const double wavelengthMm = wavelengthNm_ * 1e-6;
  const double diffraction = 0.45 * wavelengthMm * kFNumber / lens.pixelWidthMm;
  const double round = disk * disk / 16 + diffraction * diffraction + kPixelSigmaPx * kPixelSigmaPx;

  // Movement within the exposure: shift, and turn about the section's origin.
  const Point2 arm = world - Point2(pose.worldFromSection.xMm, pose.worldFromSection.yMm);
  Eigen::Matrix<double, 2, 3> moved;
  moved << 1, 0, -arm.y(), 0, 1, arm.x();
  const Eigen::Matrix<double, 2, 3> image = j.leftCols<2>() * moved;
  Eigen::Matrix2d covariance = image * pose.covariance * image.transpose();
  covariance += sheetMm * sheetMm * j.col(2) * j.col(2).transpose();
  covariance(0, 0) += round;
  covariance(1, 1) += round;

  const double det = covariance.determinant();
  SplatKernel kernel;
  kernel.a = static_cast<float>(covariance(1, 1) / det);
  kernel.b = static_cast<float>(-covariance(0, 1) / det);
  kernel.c = static_cast<float>(covariance(0, 0) / det);
  kernel.scale = static_cast<float>(1 / (2 * std::numbers::pi * std::sqrt(det)));
  kernel.bend = std::exp(-kernel.c);
  kernel.halfWidth = static_cast<float>(std::min<double>(kMostReachPx, kernelReach(std::sqrt(covariance(0, 0)))));
  kernel.halfHeight = std::min(kMostReachPx, static_cast<int>(std::ceil(kernelReach(std::sqrt(covariance(1, 1))))));
  return kernel;
}

}  // namespace vignole::simulator
