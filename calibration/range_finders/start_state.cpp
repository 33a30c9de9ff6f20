#include "calibration/range_finders/start_state.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/optics/nominal_rig.h"

namespace vignole {

namespace {

constexpr double kLaserMm = 480;  // of the drawing, from the middle of the field
constexpr double kBlurPx2 = 0.25, kSheetMm2 = 0.1225;

bool usable(const RigInputs& inputs, int placement, int camera) {
  const PinPicture& picture =
      inputs.placements[static_cast<std::size_t>(placement)].pictures[static_cast<std::size_t>(camera)];
  return picture.usable() &&
         std::any_of(picture.arcs.begin(), picture.arcs.end(), [](const PinArc& arc) { return arc.pin != 0; });
}

const Extrinsics& cameraFromPlate(const RigInputs& inputs, int placement, int camera) {
  return inputs.placements[static_cast<std::size_t>(placement)]
      .pictures[static_cast<std::size_t>(camera)]
      .cameraFromPlate;
}

/// A turn and shift in the plane.
Extrinsics inSpace(const Transform2& t) {
  return {Eigen::AngleAxisd(t.angleRad, Eigen::Vector3d::UnitZ()).toRotationMatrix(),
          Eigen::Vector3d(t.xMm, t.yMm, 0)};
}

Extrinsics product(const Extrinsics& a, const Extrinsics& b) {
  return {a.rotation * b.rotation, a.rotation * b.translationMm + a.translationMm};
}

Extrinsics inverse(const Extrinsics& a) {
  return {a.rotation.transpose(), -(a.rotation.transpose() * a.translationMm)};
}

/// What of it lies in the plane.
Transform2 inPlane(const Extrinsics& t) {
  return {t.translationMm.x(), t.translationMm.y(),
          std::atan2(t.rotation(1, 0) - t.rotation(0, 1), t.rotation(0, 0) + t.rotation(1, 1))};
}

}  // namespace

RigStart startState(const RigInputs& inputs, std::span<const int> cameras, std::optional<int> referencePlacement) {
  RigStart result;
  ArcStart& start = result.start;
  const auto placements = static_cast<int>(inputs.placements.size());
  start.state.pins = inputs.plate.pins;
  start.state.worldFromPlate.resize(inputs.placements.size());
  const auto seen = [&](int m) {
    return std::count_if(cameras.begin(), cameras.end(), [&](int c) { return usable(inputs, m, c); });
  };
  int reference = 0;
  for (int m = 1; m < placements; ++m)
    if (seen(m) > seen(reference)) reference = m;
  start.referencePlacement = referencePlacement.value_or(reference);

  std::vector<bool> placed(inputs.placements.size(), false);
  std::array<bool, kCameraCount> known{};
  placed[static_cast<std::size_t>(start.referencePlacement)] = true;
  for (bool changed = true; changed;) {
    changed = false;
    for (int m = 0; m < placements; ++m)
      for (const int c : cameras) {
        if (!usable(inputs, m, c)) continue;
        const auto camera = static_cast<std::size_t>(c), placement = static_cast<std::size_t>(m);
        RangeFinderCalibration& finder = start.state.finders[camera];
        if (placed[placement] && !known[camera]) {
          finder.cameraFromWorld =
              product(cameraFromPlate(inputs, m, c), inverse(inSpace(start.state.worldFromPlate[placement])));
          known[camera] = changed = true;
        } else if (known[camera] && !placed[placement]) {
          start.state.worldFromPlate[placement] =
              inPlane(product(inverse(finder.cameraFromWorld), cameraFromPlate(inputs, m, c)));
          placed[placement] = changed = true;
        }
      }
  }
  Point2 middle(0, 0);
  for (const Pin& pin : inputs.plate.pins) middle += pin.centreMm / static_cast<double>(inputs.plate.pins.size());
  // A laser stands beside its camera, as seen along the rail; what is drawn serves for cameras that are not known.
  std::array<Point2, kCameraCount> lasers;
  for (std::size_t c = 0; c < kCameraCount; ++c) {
    const Extrinsics& pose = known[c] ? start.state.finders[c].cameraFromWorld
                                      : nominalRig().rangeFinders[c].cameraFromWorld;
    const Point2 towards = cameraCentre(pose).head<2>() - middle;
    lasers[c] = middle + kLaserMm * towards.normalized();
  }
  for (const int c : cameras) {
    const auto camera = static_cast<std::size_t>(c);
    (known[camera] ? result.cameras : result.unconnected).push_back(c);
    RangeFinderCalibration& finder = start.state.finders[camera];
    finder.serial = inputs.cameras[camera].serial;
    finder.intrinsics = inputs.cameras[camera].intrinsics;
    CameraLight& light = start.lights[camera];
    light.blurPx2 = {kBlurPx2, 0, 0};
    light.thicknessMm2 = kSheetMm2;
    light.laserMm = lasers[camera];
    for (std::size_t k = 0, other = 0; k < kCameraCount; ++k)
      if (k != camera) light.othersMm[other++] = lasers[k];
  }
  return result;
}

}  // namespace vignole
