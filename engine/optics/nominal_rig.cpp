#include "engine/optics/nominal_rig.h"

#include <Eigen/Geometry>
#include <numbers>

namespace vignole {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kCameraDistanceMm = 400;
constexpr double kElevationRad = 40 * kDegree;
constexpr double kSheetSigmaMm = 0.35;  // thickness of the laser sheet
constexpr double kBlurPx = 0.5;         // lens and pixel: 0.43 in focus, 0.7 where the field ends

NominalStation station(double azimuthDeg, const Point2& aim) {
  return {aim, azimuthDeg * kDegree, kElevationRad, kCameraDistanceMm};
}

RigCalibration drawing() {
  RigCalibration rig;
  rig.id = "nominal-rig-c";
  rig.created = "1970-01-01T00:00:00Z";
  rig.method = "drawing";
  for (std::size_t i = 0; i < kCameraCount; ++i) {
    const NominalStation& s = nominalStations()[i];
    RangeFinderCalibration& finder = rig.rangeFinders[i];
    finder.serial = "NOMINAL-" + std::to_string(i + 1);
    finder.cameraFromWorld = lookAt(s.aim, s.azimuthRad, s.elevationRad, s.distanceMm);
    finder.lightPlane.thicknessMm = kSheetSigmaMm;
    finder.blurPx = kBlurPx;
  }
  return rig;
}

}  // namespace

const std::array<NominalStation, kCameraCount>& nominalStations() {
  static const std::array<NominalStation, kCameraCount> stations = {station(140, {-22, 98}), station(40, {22, 98}),
                                                                    station(-35, {20, 58}), station(-145, {-20, 58})};
  return stations;
}

const RigCalibration& nominalRig() {
  static const RigCalibration rig = drawing();
  return rig;
}

Point3 cameraCentre(const Extrinsics& cameraFromWorld) {
  return -(cameraFromWorld.rotation.transpose() * cameraFromWorld.translationMm);
}

Extrinsics lookAt(const Point2& aim, double azimuthRad, double elevationRad, double distanceMm) {
  const Point3 back(std::cos(elevationRad) * std::cos(azimuthRad), std::cos(elevationRad) * std::sin(azimuthRad),
                    std::sin(elevationRad));
  const Point3 forward = -back;
  // Columns along the plane of light, so that the wider side of the sensor takes the wider view.
  const Point3 right = Point3(-std::sin(azimuthRad), std::cos(azimuthRad), 0);
  const Point3 down = forward.cross(right);
  Extrinsics pose;
  pose.rotation.row(0) = right;
  pose.rotation.row(1) = down;
  pose.rotation.row(2) = forward;
  pose.translationMm = -(pose.rotation * (Point3(aim.x(), aim.y(), 0) + distanceMm * back));
  return pose;
}

}  // namespace vignole
