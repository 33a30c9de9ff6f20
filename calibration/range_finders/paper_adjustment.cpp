#include "calibration/range_finders/paper_adjustment.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

#include "calibration/range_finders/arc_adjustment.h"
#include "calibration/range_finders/error_sources.h"
#include "calibration/range_finders/pin_metrics.h"
#include "calibration/range_finders/start_state.h"
#include "engine/optics/nominal_rig.h"

namespace vignole {

namespace {

constexpr int kPose = static_cast<int>(CameraParameter::TurnX);

/// What leads from one pose to another, as CameraChange counts it.
Eigen::Matrix<double, 6, 1> between(const Extrinsics& from, const Extrinsics& to) {
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(to.rotation * from.rotation.transpose()));
  Eigen::Matrix<double, 6, 1> change;
  change << turn.axis() * turn.angle(), to.translationMm - from.translationMm;
  return change;
}

/// The pose with other pins or another lens, the association held: how the estimate answers to errors of both.
class PoseAnswer {
 public:
  PoseAnswer(const PinPicture& picture, const PaperPose& pose, const RigAdjustmentSettings& settings)
      : picture_(picture), pose_(pose), settings_(settings.paper) {
    settings_.fourSteps = false;
    settings_.maxRmsPx = 1e9;
    for (PinArc& arc : picture_.arcs) {
      arc.pin = 0;
      arc.reason.clear();
    }
    for (const PaperEllipse& e : pose.ellipses) picture_.arcs[static_cast<std::size_t>(e.arc)].pin = e.pin;
  }
  [[nodiscard]] Eigen::Matrix<double, 6, 1> operator()(const PinPlate& plate, const Intrinsics& in) const {
    const PaperPose other = paperPose(picture_, plate, in, pose_.cameraFromPlate, settings_);
    return between(pose_.cameraFromPlate, other.cameraFromPlate);
  }
  [[nodiscard]] const PinPicture& picture() const { return picture_; }

 private:
  PinPicture picture_;
  const PaperPose& pose_;
  PaperSettings settings_;
};

std::vector<ErrorSource> sourcesOf(int camera, const PoseAnswer& answer, const PaperPose& pose,
                                   const RigInputs& inputs) {
  std::vector<ErrorSource> sources;
  const CalibratedIntrinsics& stated = inputs.cameras[static_cast<std::size_t>(camera)];
  const int first = camera * kCameraParameters;
  const auto add = [&](const std::string& name, const Eigen::Ref<const Eigen::MatrixXd>& ofCamera) {
    ErrorSource source{name, {}};
    source.effects.setZero(kRigParameters, ofCamera.cols());
    source.effects.middleRows(first, kCameraParameters) = ofCamera;
    sources.push_back(std::move(source));
  };
  for (std::size_t p = 0; p < inputs.plate.pins.size(); ++p) {
    Eigen::MatrixXd effects = Eigen::MatrixXd::Zero(kCameraParameters, 2);
    for (int axis = 0; axis < 2; ++axis) {
      PinPlate plate = inputs.plate;
      plate.pins[p].centreMm[axis] += plate.pins[p].uCentreMm;
      effects.block<6, 1>(kPose, axis) = answer(plate, stated.intrinsics);
    }
    add("pin " + std::to_string(inputs.plate.pins[p].number), effects);
  }
  const Eigen::Matrix<double, 10, 10> factor = intrinsicsFactor(stated.covariance);
  for (int k = 0; k < 10; ++k) {
    if (!(factor.col(k).norm() > 0)) continue;
    CameraChange change = CameraChange::Zero();
    change.head<10>() = factor.col(k);
    RangeFinderCalibration other;
    other.intrinsics = stated.intrinsics;
    apply(change, other);
    change.segment<6>(kPose) = answer(inputs.plate, other.intrinsics);
    add("camera " + std::to_string(camera + 1) + " " + std::string(longName(static_cast<CameraParameter>(k))), change);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> lines(pose.covariance);
  Eigen::MatrixXd effects = Eigen::MatrixXd::Zero(kCameraParameters, 6);
  effects.middleRows<6>(kPose) =
      lines.eigenvectors() * lines.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal().toDenseMatrix();
  add("camera " + std::to_string(camera + 1) + " lines", effects);
  return sources;
}

/// The ridge as it is: the paper takes nothing off it.
void withoutPull(std::vector<ArcObservation>& arcs) {
  for (ArcObservation& arc : arcs)
    for (std::size_t i = 0; i < arc.pullMm.size(); ++i) {
      arc.residualPx[i] += arc.pullMm[i] / std::max(arc.mmPerPx[i], 1e-9);
      arc.pullMm[i] = 0;
      arc.weight[i] = 1;
    }
}

}  // namespace

Expected<void> adjustByPaper(const RigInputs& inputs, const RigAdjustmentSettings& settings, const Job& job,
                             RigAdjustment& result) {
  RigInputs first = inputs;  // its pins are those that the ellipses found
  first.placements.resize(1);
  const RigCalibration drawing = nominalRig();
  ArcAdjustment found;
  found.state.pins = inputs.plate.pins;
  found.state.worldFromPlate.resize(1);
  std::vector<int> cameras;
  for (int c = 0; c < kCameraCount; ++c) {
    if (job.cancelled()) return cancelledError();
    job.report(static_cast<double>(c) / kCameraCount, "camera " + std::to_string(c + 1) + ": ellipses");
    const auto i = static_cast<std::size_t>(c);
    PinPicture& picture = first.placements.front().pictures[i];
    const PaperPose pose = paperPose(
        picture, inputs.plate, inputs.cameras[i].intrinsics,
        settings.paper.fourSteps ? drawing.rangeFinders[i].cameraFromWorld : picture.cameraFromPlate, settings.paper);
    RangeFinderCalibration& finder = result.calibration.rangeFinders[i];
    finder.serial = inputs.cameras[i].serial;
    finder.intrinsics = inputs.cameras[i].intrinsics;
    finder.cameraFromWorld = pose.refusal.empty() ? pose.cameraFromPlate : drawing.rangeFinders[i].cameraFromWorld;
    found.state.finders[i] = finder;
    if (!pose.refusal.empty()) {
      result.refusals.push_back("refused, because in camera " + std::to_string(c + 1) + " of " +
                                inputs.placements.front().folder + " " + pose.refusal +
                                "; use the method joint, which associates by the drawing of the rig");
      continue;
    }
    const PoseAnswer answer(picture, pose, settings);
    addSources(result.sources, sourcesOf(c, answer, pose, inputs));
    picture = answer.picture();
    for (const PaperEllipse& e : pose.ellipses) picture.arcs[static_cast<std::size_t>(e.arc)].reason = e.reason;
    picture.refusal.clear();
    cameras.push_back(c);
  }
  result.placements.push_back({inputs.placements.front().folder, {}});
  if (inputs.placements.size() > 1)
    result.warnings.push_back("the paper's method takes one placement: " + inputs.placements.front().folder);
  result.warnings.emplace_back(
      "ellipses of short arcs shrink and pull their centres towards the arc: this is not in the uncertainties");
  for (const Pin& pin : inputs.plate.pins)
    result.calibration.pins.push_back(
        {pin.number, pin.centreMm.x(), pin.centreMm.y(), pin.radiusMm, pin.uCentreMm, pin.uRadiusMm});

  std::vector<int> all(kCameraCount);
  std::iota(all.begin(), all.end(), 0);
  found.lights = startState(inputs, all).start.lights;
  found.arcs = observations(first, cameras);
  predict(found.state, found.lights, settings, 1, found.arcs);
  withoutPull(found.arcs);
  result.pins = pinViews(found, inputs);
  for (const int c : cameras) result.finders[static_cast<std::size_t>(c)] = fitOf(result.pins, c);
  return {};
}

}  // namespace vignole
