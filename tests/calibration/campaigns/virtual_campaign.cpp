#include "tests/calibration/campaigns/virtual_campaign.h"

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <stdexcept>

namespace vignole {

CalibratedIntrinsics disturbedIntrinsics(const RangeFinderCalibration& truth, int camera, std::uint64_t seed) {
  CalibratedIntrinsics found;
  found.serial = truth.serial;
  const Intrinsics& in = truth.intrinsics;
  CameraChange sd = CameraChange::Zero();
  const auto of = [&](CameraParameter p) -> double& { return sd[static_cast<int>(p)]; };
  of(CameraParameter::F) = 5e-4 * in.focalMm;
  of(CameraParameter::U0) = of(CameraParameter::V0) = 1.5;
  const double kappa = 3e-3 / (in.focalMm * in.focalMm), corner = 6.4;
  if (in.model == DistortionModel::Division) {
    of(CameraParameter::Kappa) = kappa;
  } else {
    of(CameraParameter::K1) = kappa;
    of(CameraParameter::K2) = 0.3 * kappa / std::pow(corner, 2);
    of(CameraParameter::K3) = 0.1 * kappa / std::pow(corner, 4);
    of(CameraParameter::P1) = of(CameraParameter::P2) = 0.1 * kappa * corner;
  }
  std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U),
                         static_cast<std::uint32_t>(camera), 77U};
  std::mt19937_64 random(sequence);
  std::normal_distribution<double> normal;
  CameraChange error = CameraChange::Zero();
  for (int i = 0; i < 10; ++i) error[i] = sd[i] * normal(random);
  RangeFinderCalibration disturbed = truth;
  apply(error, disturbed);
  found.intrinsics = disturbed.intrinsics;
  found.covariance.diagonal() = sd.head<10>().cwiseAbs2();
  return found;
}

Campaign renderCampaign(const CampaignSettings& settings) {
  VirtualPlateSettings virtualPlate;
  virtualPlate.plate = settings.plate;
  for (Pin& pin : virtualPlate.plate.pins) {
    pin.uCentreMm = std::max(1e-4, settings.plateErrorMm / std::sqrt(3.0));
    pin.uRadiusMm = std::max(1e-4, 0.2 * settings.plateErrorMm / std::sqrt(3.0));
  }
  virtualPlate.seed = settings.seed;
  virtualPlate.rigSeed = settings.rigSeed;
  virtualPlate.plateErrorMm = settings.plateErrorMm;
  virtualPlate.radiusErrorMm = 0.2 * settings.plateErrorMm;
  virtualPlate.placements = usualPlacements(settings.placements, settings.seed);
  virtualPlate.missingPins = settings.missingPins;
  virtualPlate.spurious = settings.spurious;
  std::mt19937_64 random(settings.seed);
  std::normal_distribution<double> normal;
  for (PlatePlacement& placement : virtualPlate.placements) {
    placement = turned(placement, settings.turnDeg * M_PI / 180);
    placement.worldFromPlate.xMm += settings.shiftMm * normal(random);
    placement.worldFromPlate.yMm += settings.shiftMm * normal(random);
  }
  if (settings.noisePx > 0) {
    virtualPlate.noisePx = settings.noisePx;
  } else {
    virtualPlate.effects.readNoiseDn = virtualPlate.effects.shotNoise = virtualPlate.effects.speckle = 0;
  }
  auto plate = VirtualPlate::create(virtualPlate);
  if (!plate) throw std::runtime_error(plate.error().message());
  Campaign campaign;
  campaign.plate = *plate;
  campaign.inputs.plate = virtualPlate.plate;
  for (int c = 0; c < kCameraCount; ++c) {
    const RangeFinderCalibration& truth = campaign.plate->calibration().rangeFinders[static_cast<std::size_t>(c)];
    CalibratedIntrinsics& camera = campaign.inputs.cameras[static_cast<std::size_t>(c)];
    if (settings.intrinsicsErr) {
      camera = disturbedIntrinsics(truth, c, settings.seed);
    } else {
      camera.serial = truth.serial;
      camera.intrinsics = truth.intrinsics;
    }
  }
  const Intrinsics& in = campaign.plate->calibration().rangeFinders[0].intrinsics;
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(in.widthPx) * static_cast<std::size_t>(in.heightPx));
  for (int m = 0; m < settings.placements; ++m) {
    PlacementLines& placement = campaign.inputs.placements.emplace_back();
    placement.folder = "placement" + std::to_string(m + 1);
    for (int c = 0; c < kCameraCount; ++c) {
      campaign.plate->render(c, m, {pixels.data(), in.widthPx, in.heightPx, in.widthPx});
      placement.pictures[static_cast<std::size_t>(c)] =
          findPinLines({pixels.data(), in.widthPx, in.heightPx, in.widthPx}, settings.lines);
    }
  }
  return campaign;
}

void associateByTruth(Campaign& campaign) {
  for (std::size_t m = 0; m < campaign.inputs.placements.size(); ++m)
    for (int c = 0; c < kCameraCount; ++c) {
      PinPicture& picture = campaign.inputs.placements[m].pictures[static_cast<std::size_t>(c)];
      for (PinArc& arc : picture.arcs) {
        const Point2 middle = arc.points[arc.points.size() / 2].px;
        double nearest = 3;
        for (const Pin& pin : campaign.inputs.plate.pins)
          for (const Point2& p : campaign.plate->visibleArc(c, static_cast<int>(m), pin.number))
            if ((p - middle).norm() < nearest) {
              nearest = (p - middle).norm();
              arc.pin = pin.number;
            }
      }
      const Transform2& placed = campaign.plate->settings().placements[m].worldFromPlate;
      const Extrinsics& truth = campaign.plate->calibration().rangeFinders[static_cast<std::size_t>(c)].cameraFromWorld;
      const Eigen::Matrix3d turn = Eigen::AngleAxisd(placed.angleRad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
      picture.cameraFromPlate.rotation = truth.rotation * turn;
      picture.cameraFromPlate.translationMm =
          truth.rotation * Eigen::Vector3d(placed.xMm, placed.yMm, 0) + truth.translationMm;
    }
}

RigChange errorOf(const RigCalibration& found, const RigCalibration& truth) {
  RigChange change = RigChange::Zero();
  for (int c = 0; c < kCameraCount; ++c) {
    const RangeFinderCalibration &f = found.rangeFinders[static_cast<std::size_t>(c)],
                                 &t = truth.rangeFinders[static_cast<std::size_t>(c)];
    const auto set = [&](CameraParameter p, double value) {
      change[c * kCameraParameters + static_cast<int>(p)] = value;
    };
    set(CameraParameter::F, f.intrinsics.focalMm - t.intrinsics.focalMm);
    set(CameraParameter::PixelHeight, f.intrinsics.pixelHeightMm - t.intrinsics.pixelHeightMm);
    set(CameraParameter::U0, f.intrinsics.cxPx - t.intrinsics.cxPx);
    set(CameraParameter::V0, f.intrinsics.cyPx - t.intrinsics.cyPx);
    set(CameraParameter::Kappa, f.intrinsics.kappa - t.intrinsics.kappa);
    set(CameraParameter::K1, f.intrinsics.k1 - t.intrinsics.k1);
    set(CameraParameter::K2, f.intrinsics.k2 - t.intrinsics.k2);
    set(CameraParameter::K3, f.intrinsics.k3 - t.intrinsics.k3);
    set(CameraParameter::P1, f.intrinsics.p1 - t.intrinsics.p1);
    set(CameraParameter::P2, f.intrinsics.p2 - t.intrinsics.p2);
    const Eigen::AngleAxisd turn(f.cameraFromWorld.rotation * t.cameraFromWorld.rotation.transpose());
    change.segment<3>(c * kCameraParameters + static_cast<int>(CameraParameter::TurnX)) = turn.angle() * turn.axis();
    change.segment<3>(c * kCameraParameters + static_cast<int>(CameraParameter::T1)) =
        f.cameraFromWorld.translationMm - t.cameraFromWorld.translationMm;
  }
  return change;
}

}  // namespace vignole
