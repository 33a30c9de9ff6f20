#include "gui/calibration_rig/plate_stand.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "calibration/assessment/pin_centres.h"
#include "calibration/parallel_for.h"

namespace vignole {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kCertifiedUMm = 0.0015;
constexpr double kWrongPlateMm = 0.3;  // another plate of the same drawing
constexpr std::uint64_t kPlateSeed = 13;
constexpr int kMissingPin = 4;

const Point2& fieldMiddle() {
  // What stays where it is when the plate is turned by half a turn.
  static const Point2 middle = [] {
    const Transform2 half = turned({}, std::numbers::pi).worldFromPlate;
    return Point2(half.xMm / 2, half.yMm / 2);
  }();
  return middle;
}

PlatePose poseOf(const Transform2& worldFromPlate) {
  const Point2 shift = worldFromPlate * fieldMiddle() - fieldMiddle();
  return {shift.x(), shift.y(), worldFromPlate.angleRad / kDegree, 0};
}

VirtualPlateSettings standing(const PlateStandSettings& settings, const PlatePose& pose, int placement, int take) {
  VirtualPlateSettings virtualPlate;
  virtualPlate.plate = settings.known.plate;
  virtualPlate.rigSeed = settings.rigSeed;
  virtualPlate.seed = kPlateSeed;
  virtualPlate.plateErrorMm = kCertifiedUMm * std::sqrt(3.0);
  virtualPlate.radiusErrorMm = virtualPlate.plateErrorMm / 5;
  if (settings.fault == PlateFault::Mirrored)
    for (Pin& pin : virtualPlate.plate.pins) pin.centreMm.x() = -pin.centreMm.x();
  if (settings.fault == PlateFault::WrongPlate) virtualPlate.plateErrorMm = kWrongPlateMm;
  if (settings.fault == PlateFault::PinMissing) virtualPlate.missingPins = {kMissingPin};
  // The last of so many: its noise is that of this placement and take.
  virtualPlate.placements.assign(static_cast<std::size_t>(placement * 16 + take % 16 + 1), placementAt(pose));
  return virtualPlate;
}

Transform2 plateInWorld(const PlateStandSettings& settings, const PinPicture& picture, std::size_t camera) {
  const Extrinsics &pose = picture.cameraFromPlate, &stands = settings.inForce.rangeFinders[camera].cameraFromWorld;
  const Eigen::Matrix3d turn = stands.rotation.transpose() * pose.rotation;
  const Point2 middle = fieldMiddle();
  const Eigen::Vector3d at = stands.rotation.transpose() * (pose.rotation * Eigen::Vector3d(middle.x(), middle.y(), 0) +
                                                            pose.translationMm - stands.translationMm);
  Transform2 plate{0, 0, std::atan2(turn(1, 0) - turn(0, 1), turn(0, 0) + turn(1, 1))};
  const Point2 shift = Point2(at.head<2>()) - plate.rotate(middle);
  plate.xMm = shift.x();
  plate.yMm = shift.y();
  return plate;
}

/// Where most pictures have the plate: the middle one of each figure.
std::optional<PlatePose> seenPose(const PlateStandSettings& settings, const PlacementLines& lines) {
  std::vector<PlatePose> all;
  for (std::size_t c = 0; c < lines.pictures.size(); ++c)
    if (lines.pictures[c].usable()) all.push_back(poseOf(plateInWorld(settings, lines.pictures[c], c)));
  if (all.empty()) return {};
  const double about = all.front().turnDeg;
  PlatePose mean;
  for (const PlatePose& p : all) {
    mean.xMm += p.xMm / static_cast<double>(all.size());
    mean.yMm += p.yMm / static_cast<double>(all.size());
    mean.turnDeg += (about + std::remainder(p.turnDeg - about, 360.0)) / static_cast<double>(all.size());
  }
  return mean;
}

}  // namespace

PinPlate certifiedPlate() {
  PinPlate plate = plate13();
  plate.measured = true;
  for (Pin& pin : plate.pins) {
    pin.uCentreMm = kCertifiedUMm;
    pin.uRadiusMm = kCertifiedUMm / 5;
  }
  return plate;
}

PlatePlacement placementAt(const PlatePose& pose) {
  PlatePlacement placement = turned({}, pose.turnDeg * kDegree);
  placement.worldFromPlate.xMm += pose.xMm;
  placement.worldFromPlate.yMm += pose.yMm;
  placement.tiltXRad = pose.tiltDeg * kDegree;
  return placement;
}

PlatePose wantedPose(int placement) {
  switch (placement) {
    case 0:
      return {};
    case 1:
      return {0, 0, 180, 0};
    case 2:
      return {5, -4, 4, 0};
    case 3:
      return {-4, 3, 176, 0};
    default:
      return {placement % 2 == 0 ? 4.0 : -4.0, 3.0 - placement, (placement % 2) * 180.0 + 2.0 * placement, 0};
  }
}

bool PlateSight::usable() const {
  return std::all_of(lines.pictures.begin(), lines.pictures.end(), [](const PinPicture& p) { return p.usable(); });
}

Expected<PlateSight> lookAtPlate(const PlateStandSettings& settings, const PlatePose& pose, int placement, int take,
                                 const Job& job) {
  VirtualPlateSettings how = standing(settings, pose, placement, take);
  const int last = static_cast<int>(how.placements.size()) - 1;
  const auto plate = VirtualPlate::create(std::move(how));
  if (!plate) return tl::unexpected<Error>(plate.error());
  PlateSight sight;
  sight.pose = pose;
  RigInputs inputs = settings.known;
  inputs.placements.assign(1, {});
  const PinLineSettings lines;
  parallelFor(kCameraCount, [&](std::size_t c) {
    if (job.cancelled()) return;
    const Intrinsics& in = settings.known.cameras[c].intrinsics;
    Picture& picture = sight.pictures[c];
    picture.width = in.widthPx;
    picture.height = in.heightPx;
    picture.pixels.resize(static_cast<std::size_t>(in.widthPx) * static_cast<std::size_t>(in.heightPx));
    (*plate)->render(static_cast<int>(c), last, {picture.pixels.data(), in.widthPx, in.heightPx, in.widthPx});
    inputs.placements[0].pictures[c] = findPinLines(picture.view(), lines);
  });
  if (job.cancelled()) return cancelledError();
  AssociationSettings association;
  association.drawing = settings.inForce;
  associate(inputs, association);
  sight.lines = std::move(inputs.placements[0]);
  sight.lines.folder = "placement " + std::to_string(placement + 1);
  sight.seen = seenPose(settings, sight.lines);
  for (int c = 0; c < kCameraCount; ++c) {
    const auto camera = static_cast<std::size_t>(c);
    for (const PinArc& arc : sight.lines.pictures[camera].arcs)
      if (arc.pin > 0 && arc.usable()) sight.found[camera].push_back(arc.pin);
    std::sort(sight.found[camera].begin(), sight.found[camera].end());
    const auto ends = std::unique(sight.found[camera].begin(), sight.found[camera].end());
    sight.found[camera].erase(ends, sight.found[camera].end());
    for (const Pin& pin : settings.known.plate.pins)
      if (!std::binary_search(sight.found[camera].begin(), sight.found[camera].end(), pin.number))
        sight.missing[camera].push_back(pin.number);
  }
  return sight;
}

std::vector<std::vector<Point2>> pinOutlines(const PlateStandSettings& settings, const PlatePose& pose, int camera) {
  constexpr int kSteps = 16;
  const RangeFinderCalibration& finder = settings.inForce.rangeFinders[static_cast<std::size_t>(camera)];
  const Transform2 plate = placementAt(pose).worldFromPlate;
  const Point2 eye = cameraCentre(finder.cameraFromWorld).head<2>();
  std::vector<std::vector<Point2>> outlines;
  for (const Pin& pin : settings.known.plate.pins) {
    const Point2 centre = plate * pin.centreMm;
    const double towards = std::atan2(eye.y() - centre.y(), eye.x() - centre.x());
    std::vector<Point2> curve;
    for (int i = 0; i <= kSteps; ++i) {
      const double angle = towards + (static_cast<double>(i) / kSteps - 0.5) * std::numbers::pi * 0.9;
      const Point2 px = pixelOf(finder, centre + pin.radiusMm * Point2(std::cos(angle), std::sin(angle)));
      if (px.x() < 0 || px.y() < 0 || px.x() > finder.intrinsics.widthPx - 1 ||
          px.y() > finder.intrinsics.heightPx - 1) {
        curve.clear();
        break;
      }
      curve.push_back(px);
    }
    outlines.push_back(std::move(curve));
  }
  return outlines;
}

}  // namespace vignole
