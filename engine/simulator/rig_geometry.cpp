#include "engine/simulator/rig_geometry.h"

#include <Eigen/Geometry>
#include <numbers>

#include "engine/simulator/hashing.h"

namespace vignole::simulator {

namespace {

constexpr double kSheetSigmaMm = 0.35;  // thickness of the laser sheet
constexpr double kBlurPx = 0.5;         // lens and pixel as rendered: 0.43 in focus, 0.7 where the field ends

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kCameraDistanceMm = 400;
constexpr double kElevationRad = 40 * kDegree;
constexpr double kLaserDistanceMm = 480;
constexpr double kHalfFanRad = 15 * kDegree;
const Point2 kLaserAim(0, 86);

struct Station {
  double azimuthDeg;
  Point2 aim;
  double wavelengthNm;
};
const std::array<Station, kCameraCount> kStations = {Station{140, {-22, 98}, 660}, Station{40, {22, 98}, 685},
                                                     Station{-35, {20, 58}, 660}, Station{-145, {-20, 58}, 685}};

// How far a rig that was built is from its drawing: standard deviations.
constexpr double kPoseMm = 1, kPoseRad = 0.3 * kDegree, kLaserMm = 1, kLaserRad = 0.2 * kDegree, kPrincipalPx = 3;

Intrinsics drawLens(Draws& draws, bool division) {
  Intrinsics in;
  in.focalMm = draws.uniform(16.0, 16.3);
  in.cxPx += kPrincipalPx * draws.normal();
  in.cyPx += kPrincipalPx * draws.normal();
  // A mild C-mount lens of 16 mm: about 0.5-1 % barrel at the corner (r = 6.4 mm).
  const double barrel = draws.uniform(1.2e-4, 2.4e-4);
  if (division) {
    in.model = DistortionModel::Division;
    in.kappa = -barrel;
  } else {
    in.model = DistortionModel::Polynomial;
    in.k1 = barrel;
    in.k2 = draws.uniform(-1e-6, 1e-6);
    in.k3 = draws.uniform(-5e-9, 5e-9);
    in.p1 = 2e-5 * draws.normal();
    in.p2 = 2e-5 * draws.normal();
  }
  return in;
}

Extrinsics disturbed(const Extrinsics& nominal, Draws& draws) {
  // Turned about the camera's own centre, then shifted.
  const Eigen::Vector3d turn(kPoseRad * draws.normal(), kPoseRad * draws.normal(), kPoseRad * draws.normal());
  const Eigen::Matrix3d extra = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  const Point3 shift(kPoseMm * draws.normal(), kPoseMm * draws.normal(), kPoseMm * draws.normal());
  const Point3 centre = cameraCentre(nominal) + shift;
  Extrinsics pose;
  pose.rotation = extra * nominal.rotation;
  pose.translationMm = -(pose.rotation * centre);
  return pose;
}

Laser drawLaser(const Station& station, Draws& draws) {
  const double azimuth = station.azimuthDeg * kDegree;
  Laser laser;
  laser.positionMm = kLaserAim + kLaserDistanceMm * Point2(std::cos(azimuth), std::sin(azimuth)) +
                     Point2(kLaserMm * draws.normal(), kLaserMm * draws.normal());
  const double heading = azimuth + std::numbers::pi + kLaserRad * draws.normal();
  laser.direction = {std::cos(heading), std::sin(heading)};
  laser.halfFanRad = kHalfFanRad;
  laser.wavelengthNm = station.wavelengthNm;
  return laser;
}

}  // namespace

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

RigGeometry drawRig(std::uint64_t rigSeed) {
  RigGeometry rig;
  rig.calibration.id = "virtual-rig-" + std::to_string(rigSeed);
  rig.calibration.created = "1970-01-01T00:00:00Z";  // the same rig is the same file, whenever it is drawn
  rig.calibration.method = "exact (virtual rig)";
  for (std::size_t i = 0; i < kCameraCount; ++i) {
    Draws draws(rigSeed, Stream::Rig, {i});
    const Station& station = kStations[i];
    RangeFinderCalibration& finder = rig.calibration.rangeFinders[i];
    finder.serial = "VIRTUAL-" + std::to_string(rigSeed) + "-" + std::to_string(i + 1);
    finder.intrinsics = drawLens(draws, i % 2 == 0);
    finder.cameraFromWorld =
        disturbed(lookAt(station.aim, station.azimuthDeg * kDegree, kElevationRad, kCameraDistanceMm), draws);
    finder.lightPlane.thicknessMm = kSheetSigmaMm;
    finder.blurPx = kBlurPx;
    rig.lasers[i] = drawLaser(station, draws);
    rig.focusMm[i] = kCameraDistanceMm;
  }
  return rig;
}

}  // namespace vignole::simulator
