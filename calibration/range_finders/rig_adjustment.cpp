#include "calibration/range_finders/rig_adjustment.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "calibration/range_finders/arc_adjustment.h"
#include "calibration/range_finders/error_sources.h"
#include "calibration/range_finders/paper_adjustment.h"
#include "calibration/range_finders/pin_metrics.h"
#include "calibration/range_finders/start_state.h"
#include "engine/optics/plane_map.h"

namespace vignole {

namespace {

/// Mean variance, over the pins of the plate, of where the cameras' maps put a point of theirs: mm^2.
double mapVariance(const ArcAdjustment& adjustment, const Influence& answer, std::span<const int> cameras) {
  constexpr double kStep = 1e-3;  // of a standard deviation
  double sum = 0;
  int count = 0;
  for (const int c : cameras) {
    const RangeFinderCalibration& finder = adjustment.state.finders[static_cast<std::size_t>(c)];
    const Eigen::MatrixXd covariance =
        answer.covariance.block<kCameraParameters, kCameraParameters>(c * kCameraParameters, c * kCameraParameters);
    const Lens<double> camera = lens(finder.intrinsics);
    const PlaneMap map(finder);
    std::vector<Point2> pixels;
    for (const Pin& pin : adjustment.state.pins) {
      const Point2 at = adjustment.state.worldFromPlate[static_cast<std::size_t>(adjustment.referencePlacement)] *
                        pin.centreMm;
      pixels.push_back(project<double>(camera, finder.cameraFromWorld.rotation, finder.cameraFromWorld.translationMm,
                                       {at.x(), at.y(), 0}));
    }
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(2 * static_cast<Eigen::Index>(pixels.size()), kCameraParameters);
    for (int k = 0; k < kCameraParameters; ++k) {
      const double step = kStep * std::sqrt(std::max(covariance(k, k), 0.0));
      if (!(step > 0)) continue;
      CameraChange change = CameraChange::Zero();
      change[k] = step;
      RangeFinderCalibration moved = finder;
      apply(change, moved);
      const PlaneMap movedMap(moved);
      for (std::size_t i = 0; i < pixels.size(); ++i) {
        const PlanePoint a = map(pixels[i].x(), pixels[i].y()), b = movedMap(pixels[i].x(), pixels[i].y());
        const auto row = 2 * static_cast<Eigen::Index>(i);
        jacobian(row, k) = (b.x - a.x) / step;
        jacobian(row + 1, k) = (b.y - a.y) / step;
      }
    }
    sum += (jacobian * covariance * jacobian.transpose()).trace();
    count += static_cast<int>(pixels.size());
  }
  return count > 0 ? sum / count : 0;
}

bool intrinsicsUncertain(const ArcAdjustment& adjustment, std::span<const int> cameras) {
  return std::any_of(cameras.begin(), cameras.end(), [&](int c) {
    return !adjustment.base[static_cast<std::size_t>(c)].intrinsicsFactor.isZero(0);
  });
}

/// The adjustment of some cameras in one world, the intrinsics held or freed as asked for or as leaves less
/// uncertainty.
struct Solved {
  ArcAdjustment adjustment;
  Influence answer;
};

Expected<Solved> solve(const RigInputs& inputs, const ArcStart& start, std::span<const int> cameras, bool pins,
                       const RigAdjustmentSettings& settings, const Job& job) {
  ArcFreedom freedom{pins, settings.intrinsics == IntrinsicsUse::Freed ||
                               (settings.intrinsics == IntrinsicsUse::Decide && pins)};
  auto adjusted = adjustArcs(inputs, start, observations(inputs, cameras), freedom, settings, job);
  if (!adjusted) return tl::unexpected<Error>(adjusted.error());
  Influence answer = influence(*adjusted, inputs.plate, cameras, freedom);
  if (settings.intrinsics == IntrinsicsUse::Decide && intrinsicsUncertain(*adjusted, cameras)) {
    ArcFreedom other = freedom;
    other.intrinsics = !other.intrinsics;
    const Influence otherAnswer = influence(*adjusted, inputs.plate, cameras, other);
    if (mapVariance(*adjusted, otherAnswer, cameras) < mapVariance(*adjusted, answer, cameras)) {
      ArcStart again{adjusted->state, adjusted->lights, adjusted->referencePlacement};
      for (const int c : cameras)
        again.state.finders[static_cast<std::size_t>(c)].intrinsics =
            inputs.cameras[static_cast<std::size_t>(c)].intrinsics;
      again.state.pins = inputs.plate.pins;
      adjusted = adjustArcs(inputs, again, observations(inputs, cameras), other, settings, job);
      if (!adjusted) return tl::unexpected<Error>(adjusted.error());
      answer = influence(*adjusted, inputs.plate, cameras, other);
    }
  }
  return Solved{*std::move(adjusted), std::move(answer)};
}

/// What one solution says of its cameras.
void takeCameras(const Solved& solved, const RigInputs& inputs, std::span<const int> cameras, RigAdjustment& result) {
  const ArcAdjustment& a = solved.adjustment;
  const std::vector<PinView> views = pinViews(a, inputs);
  for (const int c : cameras) {
    const auto camera = static_cast<std::size_t>(c);
    RangeFinderCalibration& finder = result.calibration.rangeFinders[camera];
    finder = a.state.finders[camera];
    finder.lightPlane = {};
    finder.lightPlane.thicknessMm = std::sqrt(a.lights[camera].thicknessMm2);
    RangeFinderFit& fit = result.finders[camera];
    fit = fitOf(views, c);
    fit.noisePx = fit.expectedNoisePx = 0;
    double blur = 0;
    int arcs = 0, points = 0;
    for (const ArcObservation& arc : a.arcs) {
      if (arc.camera != c || !arc.used()) continue;
      blur += a.lights[camera].blurAt(arc.distanceMm);
      fit.correlatedPoints = arc.correlatedPoints(a.lights[camera]);
      ++arcs;
      for (std::size_t i = 0; i < arc.inside.size(); ++i)
        if (arc.inside[i] != 0) {
          fit.expectedNoisePx += arc.sigmaPx[i];
          ++points;
        }
    }
    if (arcs > 0) finder.blurPx = std::sqrt(blur / arcs);
    if (points > 0) fit.expectedNoisePx /= points;
    fit.noisePx = a.lights[camera].noise * fit.expectedNoisePx;
  }
  result.pins.insert(result.pins.end(), views.begin(), views.end());
  addSources(result.sources, errorSources(solved.answer, inputs.plate, cameras));
}

void takePins(const Solved& solved, const RigInputs& inputs, RigAdjustment& result) {
  for (std::size_t p = 0; p < inputs.plate.pins.size(); ++p) {
    const Pin& found = solved.adjustment.state.pins[p];
    const auto row = kRigParameters + static_cast<Eigen::Index>(p) * kPinUnknowns;
    const Eigen::Vector3d variance = solved.answer.covariance.diagonal().segment<3>(row);
    if (!(variance.sum() > 0) && solved.adjustment.freedom.pins) continue;  // no camera has seen it
    result.calibration.pins.push_back({found.number, found.centreMm.x(), found.centreMm.y(), found.radiusMm,
                                       std::sqrt((variance[0] + variance[1]) / 2), std::sqrt(variance[2])});
  }
}

void takePlacements(const ArcAdjustment& adjustment, const RigInputs& inputs, RigAdjustment& result) {
  for (std::size_t m = 0; m < inputs.placements.size(); ++m)
    result.placements.push_back({inputs.placements[m].folder, adjustment.state.worldFromPlate[m]});
}

void noteArcsWithoutPin(const RigInputs& inputs, RigAdjustment& result) {
  for (std::size_t m = 0; m < inputs.placements.size(); ++m)
    for (int c = 0; c < kCameraCount; ++c) {
      const PinPicture& picture = inputs.placements[m].pictures[static_cast<std::size_t>(c)];
      for (const Pin& pin : inputs.plate.pins) {
        const auto is = [&](const PinView& v) {
          return v.pin == pin.number && v.camera == c && v.placement == static_cast<int>(m);
        };
        if (std::any_of(result.pins.begin(), result.pins.end(), is)) continue;
        PinView view;
        view.pin = pin.number;
        view.camera = c;
        view.placement = static_cast<int>(m);
        view.reason = "not seen";
        view.cdMm = view.rdMm = view.pdMm = view.pdNominalMm = view.leaveOneOutMm = std::nan("");
        for (const PinArc& arc : picture.arcs)
          if (arc.pin == pin.number && !arc.usable()) view.reason = arc.reason;
        if (!picture.usable()) view.reason = "its picture is of no use";
        result.pins.push_back(std::move(view));
      }
    }
  std::stable_sort(result.pins.begin(), result.pins.end(), [](const PinView& a, const PinView& b) {
    return std::tuple(a.placement, a.camera, a.pin) < std::tuple(b.placement, b.camera, b.pin);
  });
}

Expected<void> adjustJoint(const RigInputs& inputs, const RigAdjustmentSettings& settings, const Job& job,
                           RigAdjustment& result) {
  std::vector<int> all(kCameraCount);
  std::iota(all.begin(), all.end(), 0);
  const RigStart start = startState(inputs, all);
  for (const int c : start.unconnected)
    result.refusals.push_back("refused, because camera " + std::to_string(c + 1) +
                              " has no usable picture of the plate; repeat the placements with its laser and exposure "
                              "checked");
  if (!start.unconnected.empty()) return {};
  const auto solved = solve(inputs, start.start, start.cameras, true, settings, job);
  if (!solved) return tl::unexpected<Error>(solved.error());
  takeCameras(*solved, inputs, start.cameras, result);
  takePins(*solved, inputs, result);
  takePlacements(solved->adjustment, inputs, result);
  result.intrinsicsFreed = solved->adjustment.freedom.intrinsics && intrinsicsUncertain(solved->adjustment, all);
  result.chi2PerDof = solved->adjustment.chi2PerDof;
  return {};
}

Expected<void> adjustPerCamera(const RigInputs& inputs, const RigAdjustmentSettings& settings, const Job& job,
                               RigAdjustment& result) {
  std::vector<int> all(kCameraCount);
  std::iota(all.begin(), all.end(), 0);
  const RigStart whole = startState(inputs, all);
  const int reference = whole.start.referencePlacement;
  for (int c = 0; c < kCameraCount; ++c) {
    if (job.cancelled()) return cancelledError();
    const std::array<int, 1> one{c};
    const PinPicture& first =
        inputs.placements[static_cast<std::size_t>(reference)].pictures[static_cast<std::size_t>(c)];
    const RigStart start = startState(inputs, one, reference);
    if (!first.usable() || start.cameras.empty()) {
      result.refusals.push_back("refused, because camera " + std::to_string(c + 1) + " has no usable picture of " +
                                inputs.placements[static_cast<std::size_t>(reference)].folder +
                                ", which the world is counted from; repeat that placement or use the method joint");
      continue;
    }
    // How much the lines scatter is told by an adjustment that the pins' errors do not disturb.
    const auto scatter = adjustArcs(inputs, start.start, observations(inputs, one), {true, true}, settings, job);
    if (!scatter) return tl::unexpected<Error>(scatter.error());
    ArcStart again{scatter->state, scatter->lights, reference};
    again.state.pins = inputs.plate.pins;
    again.state.finders[static_cast<std::size_t>(c)].intrinsics =
        inputs.cameras[static_cast<std::size_t>(c)].intrinsics;
    const auto solved = solve(inputs, again, one, false, settings, job);
    if (!solved) return tl::unexpected<Error>(solved.error());
    takeCameras(*solved, inputs, one, result);
    if (c == 0) {
      takePins(*solved, inputs, result);
      takePlacements(solved->adjustment, inputs, result);
    }
    result.intrinsicsFreed =
        result.intrinsicsFreed || (solved->adjustment.freedom.intrinsics && intrinsicsUncertain(solved->adjustment, one));
    result.chi2PerDof += solved->adjustment.chi2PerDof / kCameraCount;
  }
  return {};
}

}  // namespace

std::string_view name(RigMethod method) {
  switch (method) {
    case RigMethod::Joint:
      return "joint";
    case RigMethod::PerCamera:
      return "per-camera";
    case RigMethod::Paper:
      break;
  }
  return "paper";
}

Expected<RigAdjustment> adjustRig(const RigInputs& inputs, const RigAdjustmentSettings& settings, const Job& job) {
  const auto started = std::chrono::steady_clock::now();
  if (inputs.placements.empty()) return inputError("placements", "there must be at least one");
  RigAdjustment result;
  result.method = settings.method;
  result.calibration.method = name(settings.method);
  result.calibration.plate = inputs.plate.id;
  Expected<void> done;
  if (settings.method == RigMethod::Joint) done = adjustJoint(inputs, settings, job, result);
  if (settings.method == RigMethod::PerCamera) done = adjustPerCamera(inputs, settings, job, result);
  if (settings.method == RigMethod::Paper) done = adjustByPaper(inputs, settings, job, result);
  if (!done) return tl::unexpected<Error>(done.error());
  noteArcsWithoutPin(inputs, result);
  result.calibration.covariance = covarianceOf(result.sources);
  result.solveS = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  return result;
}

}  // namespace vignole
