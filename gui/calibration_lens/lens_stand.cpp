#include "gui/calibration_lens/lens_stand.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/optics/camera_model.h"
#include "engine/simulator/rig_geometry.h"

namespace vignole {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kSamePosePx = 4;
constexpr std::uint64_t kTargetSeed = 21;

Eigen::Vector3d middleOf(const PlanarTarget& target) {
  const TargetRectangle area = board(target);
  const Point2 middle = (area.min + area.max) / 2;
  return {middle.x(), middle.y(), 0};
}

std::vector<Point2> outlineOf(const Extrinsics& pose, const PlanarTarget& target, const Intrinsics& in) {
  const TargetRectangle area = board(target);
  const auto camera = vignole::lens(in);
  std::vector<Point2> outline;
  for (const Point2& corner :
       {area.min, Point2(area.max.x(), area.min.y()), area.max, Point2(area.min.x(), area.max.y()), area.min})
    outline.push_back(project<double>(camera, pose.rotation, pose.translationMm, {corner.x(), corner.y(), 0}));
  return outline;
}

double rmsBetween(const TargetView& a, const TargetView& b) {
  double sum = 0;
  int count = 0;
  for (const FoundPoint& p : a.points)
    for (const FoundPoint& q : b.points)
      if (p.index == q.index) {
        sum += (p.px - q.px).squaredNorm();
        ++count;
      }
  return count == 0 ? 1e9 : std::sqrt(sum / count);
}

}  // namespace

Extrinsics extrinsicsOf(const HeldTarget& pose, const PlanarTarget& target) {
  Extrinsics result;
  result.rotation = (Eigen::AngleAxisd(pose.turnDeg * kDegree, Eigen::Vector3d::UnitZ()) *
                     Eigen::AngleAxisd(pose.tiltYDeg * kDegree, Eigen::Vector3d::UnitY()) *
                     Eigen::AngleAxisd(pose.tiltXDeg * kDegree, Eigen::Vector3d::UnitX()))
                        .toRotationMatrix();
  result.translationMm = Eigen::Vector3d(pose.xMm, pose.yMm, pose.zMm) - result.rotation * middleOf(target);
  return result;
}

HeldTarget poseOf(const Extrinsics& cameraFromTarget, const PlanarTarget& target) {
  const Eigen::Matrix3d& r = cameraFromTarget.rotation;
  const Eigen::Vector3d at = r * middleOf(target) + cameraFromTarget.translationMm;
  HeldTarget pose{at.x(), at.y(), at.z(), 0, 0, 0};
  pose.tiltYDeg = std::asin(std::clamp(-r(2, 0), -1.0, 1.0)) / kDegree;
  pose.tiltXDeg = std::atan2(r(2, 1), r(2, 2)) / kDegree;
  pose.turnDeg = std::atan2(r(1, 0), r(0, 0)) / kDegree;
  return pose;
}

RangeFinderCalibration virtualCamera(std::uint64_t rigSeed, int camera) {
  return simulator::drawRig(rigSeed).calibration.rangeFinders[static_cast<std::size_t>(camera)];
}

Expected<LensSight> lookAtTarget(const LensStandSettings& settings, const HeldTarget& pose, int take,
                                 const std::vector<TargetView>& taken) {
  VirtualTargetSettings how;
  how.target = settings.target;
  how.camera = settings.camera;
  how.targetErrorMm = settings.target.uMm * std::sqrt(3.0);
  how.seed = kTargetSeed;
  how.noiseKey = static_cast<std::uint64_t>(settings.number);
  const auto target = VirtualTarget::create(how);
  if (!target) return tl::unexpected<Error>(target.error());
  LensSight sight;
  sight.pose = pose;
  const Intrinsics& in = settings.camera.intrinsics;
  sight.picture.width = in.widthPx;
  sight.picture.height = in.heightPx;
  sight.picture.pixels.resize(static_cast<std::size_t>(in.widthPx) * static_cast<std::size_t>(in.heightPx));
  (*target)->render(extrinsicsOf(pose, settings.target), take, false,
                    {sight.picture.pixels.data(), in.widthPx, in.heightPx, in.widthPx});
  sight.view = findTarget(sight.picture.view(), settings.target);
  sight.view.file = "picture " + std::to_string(taken.size() + 1);
  if (!sight.view.usable()) return sight;
  for (std::size_t i = 0; i < taken.size(); ++i)
    if (rmsBetween(sight.view, taken[i]) < kSamePosePx) sight.sameAs = static_cast<int>(i) + 1;
  return sight;
}

NextView startingView(const PlanarTarget& target, const Intrinsics& lens, int number) {
  const std::vector<Extrinsics> views = usualViews(target, lens, number + 1, kTargetSeed);
  NextView next;
  next.pose = poseOf(views.back(), target);
  next.outlinePx = outlineOf(views.back(), target, lens);
  return next;
}

Expected<NextView> mostTelling(const std::vector<TargetView>& taken, const PlanarTarget& target, const Section& section,
                               const DimensionParameters& parameters, const Job& job) {
  IntrinsicsSettings quick;
  quick.model = DistortionModel::Division;  // the model is chosen at the end
  quick.folds = 3;
  quick.openCvReference = false;
  const auto calibration = calibrateIntrinsics(taken, target, quick, job);
  if (!calibration) return tl::unexpected<Error>(calibration.error());
  const Intrinsics& lens = calibration->camera.intrinsics;
  auto worth = worthInDimensions(lens, section, parameters);
  if (!worth) worth = worthInPicture(lens, usualDistanceMm(*calibration, target));
  if (job.cancelled()) return cancelledError();
  const auto next = nextPose(*calibration, target, *worth);
  if (!next) return tl::unexpected<Error>(next.error());
  // The same pose once more may tell most by its noise alone, but a picture of it would be refused.
  const std::vector<Point2> points = target.points();
  const auto camera = vignole::lens(lens);
  for (const TargetView& view : taken) {
    double sum = 0;
    for (const FoundPoint& p : view.points) {
      const Point2& at = points[static_cast<std::size_t>(p.index)];
      sum += (project<double>(camera, next->cameraFromTarget.rotation, next->cameraFromTarget.translationMm,
                              {at.x(), at.y(), 0}) -
              p.px)
                 .squaredNorm();
    }
    if (std::sqrt(sum / static_cast<double>(view.points.size())) < 3 * kSamePosePx)
      return startingView(target, lens, static_cast<int>(taken.size()));
  }
  return NextView{poseOf(next->cameraFromTarget, target), next->outlinePx, next->words};
}

}  // namespace vignole
