#include "engine/simulator/rig_geometry.h"

#include <Eigen/Geometry>
#include <numbers>

#include "engine/optics/nominal_rig.h"
#include "engine/simulator/hashing.h"

namespace vignole::simulator {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kLaserDistanceMm = 480;
constexpr double kHalfFanRad = 15 * kDegree;
const Point2 kLaserAim(0, 86);
constexpr std::array<double, kCameraCount> kWavelengthsNm = {660, 685, 660, 685};

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

Laser drawLaser(double azimuthRad, double wavelengthNm, Draws& draws) {
  Laser laser;
  laser.positionMm = kLaserAim + kLaserDistanceMm * Point2(std::cos(azimuthRad), std::sin(azimuthRad)) +
                     Point2(kLaserMm * draws.normal(), kLaserMm * draws.normal());
  const double heading = azimuthRad + std::numbers::pi + kLaserRad * draws.normal();
  laser.direction = {std::cos(heading), std::sin(heading)};
  laser.halfFanRad = kHalfFanRad;
  laser.wavelengthNm = wavelengthNm;
  return laser;
}

}  // namespace

RigGeometry drawRig(std::uint64_t rigSeed) {
  RigGeometry rig;
  rig.calibration = nominalRig();
  rig.calibration.id = "virtual-rig-" + std::to_string(rigSeed);
  rig.calibration.method = "exact (virtual rig)";  // `created` stays the drawing's: the same rig is the same file
  for (std::size_t i = 0; i < kCameraCount; ++i) {
    Draws draws(rigSeed, Stream::Rig, {i});
    const NominalStation& station = nominalStations()[i];
    RangeFinderCalibration& finder = rig.calibration.rangeFinders[i];
    finder.serial = "VIRTUAL-" + std::to_string(rigSeed) + "-" + std::to_string(i + 1);
    finder.intrinsics = drawLens(draws, i % 2 == 0);
    finder.cameraFromWorld = disturbed(finder.cameraFromWorld, draws);
    rig.lasers[i] = drawLaser(station.azimuthRad, kWavelengthsNm[i], draws);
    rig.focusMm[i] = station.distanceMm;
  }
  return rig;
}

}  // namespace vignole::simulator
