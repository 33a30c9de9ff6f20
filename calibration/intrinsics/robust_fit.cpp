#include "calibration/intrinsics/robust_fit.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "calibration/intrinsics/zhang_start.h"
#include "calibration/parallel_for.h"

namespace vignole {

namespace {

constexpr double kHopeless = 1e9;

/// Some of the points of each view, spread over all: enough to find the right start.
TargetObservations thinned(const TargetObservations& observations) {
  constexpr std::size_t kEnough = 30;
  TargetObservations some{observations.points, observations.radiusMm, {}};
  for (const ObservedView& view : observations.views) {
    const std::size_t step = std::max<std::size_t>(1, view.size() / kEnough);
    ObservedView& thin = some.views.emplace_back();
    for (std::size_t i = 0; i < view.size(); i += step) thin.push_back(view[i]);
  }
  return some;
}

/// Sum of what each point is off, in its own sigma and bounded, so that the start that fits most points wins.
double robustCost(const TargetObservations& observations, const TargetFit& fit) {
  double cost = 0;
  const auto all = residuals(observations, fit);
  for (std::size_t v = 0; v < all.size(); ++v)
    for (std::size_t i = 0; i < all[v].size(); ++i) {
      const double square = all[v][i].squaredNorm() / std::pow(observations.views[v][i].sigmaPx, 2);
      cost += std::isfinite(square) ? std::log1p(square) : std::log(kHopeless);
    }
  return cost;
}

TargetFit startFrom(const TargetObservations& observations, const std::vector<Eigen::Matrix3d>& homographies,
                    const Intrinsics& in) {
  TargetFit start;
  start.intrinsics = in;
  start.points = observations.points;
  for (const Eigen::Matrix3d& h : homographies) start.cameraFromTarget.push_back(poseFromHomography(h, in));
  return start;
}

/// The other pose from which a small or distant flat target looks nearly the same: its normal mirrored at the line of
/// sight.
Extrinsics flipped(const Extrinsics& pose, const Eigen::Vector3d& middleInTarget) {
  const Eigen::Vector3d middle = pose.rotation * middleInTarget + pose.translationMm;
  const Eigen::Vector3d sight = middle.normalized(), normal = pose.rotation.col(2);
  const Eigen::Vector3d other = 2 * sight.dot(normal) * sight - normal;
  Extrinsics result;
  result.rotation = Eigen::Quaterniond::FromTwoVectors(normal, other).toRotationMatrix() * pose.rotation;
  result.translationMm = middle - result.rotation * middleInTarget;
  return result;
}

/// Each view by itself: where the flipped pose fits better, it is taken.
void unflip(const TargetObservations& observations, const LensVariant& variant, TargetFit& fit) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : observations.points) middle += p / static_cast<double>(observations.points.size());
  AdjustmentSettings poses;
  poses.posesOnly = true;
  poses.robust = true;
  TargetFit other = fit;
  for (Extrinsics& pose : other.cameraFromTarget) pose = flipped(pose, middle);
  other = adjust(observations, variant, other, poses);
  for (std::size_t v = 0; v < observations.views.size(); ++v) {
    const TargetObservations one{observations.points, observations.radiusMm, {observations.views[v]}};
    TargetFit here = fit, there = fit;
    here.cameraFromTarget = {fit.cameraFromTarget[v]};
    there.cameraFromTarget = {other.cameraFromTarget[v]};
    if (robustCost(one, there) < robustCost(one, here)) fit.cameraFromTarget[v] = other.cameraFromTarget[v];
  }
}

/// A robust adjustment whose measure of what is far off shrinks with the residuals.
TargetFit robustly(TargetObservations observations, const LensVariant& variant, TargetFit fit, int rounds) {
  constexpr int kMaxIterations = 40;  // who is not near by then has started at a wrong place
  AdjustmentSettings robust;
  robust.robust = true;
  robust.maxIterations = kMaxIterations;
  robust.tolerance = 1e-6;
  fit.intrinsics = asVariant(fit.intrinsics, variant);
  for (int round = 0; round < rounds; ++round) {
    weigh(observations, unexplainedNoise(observations, residuals(observations, fit)));
    fit = adjust(observations, variant, fit, robust);
  }
  return fit;
}

}  // namespace

void refine(const TargetObservations& observations, const LensVariant& variant, const AdjustmentSettings& adjustment,
            const OutlierSettings& settings, RobustFit& robust) {
  constexpr int kMaxRounds = 8;
  robust.fit.intrinsics = asVariant(robust.fit.intrinsics, variant);
  for (int round = 0; round < kMaxRounds; ++round) {
    TargetObservations used = selected(observations, robust.selection);
    robust.unexplainedPx = unexplainedNoise(used, residuals(used, robust.fit));
    weigh(used, robust.unexplainedPx);
    robust.fit = adjust(used, variant, robust.fit, adjustment);

    robust.unexplainedPx = unexplainedNoise(used, residuals(used, robust.fit));
    TargetObservations all = observations;
    weigh(all, robust.unexplainedPx);
    const Selection next = judge(all, residuals(all, robust.fit), robust.selection, settings);
    if (next == robust.selection) break;
    robust.selection = next;
  }
}

Expected<RobustFit> robustFit(const TargetObservations& observations, const LensVariant& variant,
                              const Intrinsics& like, double nominalFocalMm, const OutlierSettings& settings,
                              const Job& job) {
  std::vector<Eigen::Matrix3d> homographies;
  for (const ObservedView& view : observations.views) {
    const auto h = homography(observations.points, view);
    if (!h) return inputError("", "a view has no homography");
    homographies.push_back(*h);
  }
  std::vector<Intrinsics> starts = zhangStarts(homographies, like);
  if (nominalFocalMm > 0) {
    starts.push_back(starts.back());
    starts.back().focalMm = nominalFocalMm;
  }
  if (job.cancelled()) return cancelledError();

  const TargetObservations some = thinned(observations);
  TargetObservations evenly = some;  // the same measure for all starts
  weigh(evenly, 1);
  const LensVariant simple{DistortionModel::Polynomial, 1, false, false};
  std::vector<TargetFit> fits(starts.size());
  std::vector<double> costs(starts.size());
  parallelFor(starts.size(), [&](std::size_t i) {
    fits[i] = robustly(some, simple, startFrom(some, homographies, starts[i]), 2);
    unflip(evenly, simple, fits[i]);
    costs[i] = robustCost(evenly, fits[i]);
  });
  const auto best = static_cast<std::size_t>(std::min_element(costs.begin(), costs.end()) - costs.begin());
  if (job.cancelled()) return cancelledError();

  RobustFit robust;
  robust.fit = robustly(observations, variant, robustly(observations, simple, fits[best], 2), 2);
  robust.selection = Selection::all(observations);
  TargetObservations all = observations;
  robust.unexplainedPx = unexplainedNoise(all, residuals(all, robust.fit));
  weigh(all, robust.unexplainedPx);
  robust.selection = judge(all, residuals(all, robust.fit), robust.selection, settings);
  refine(observations, variant, {}, settings, robust);
  return robust;
}

}  // namespace vignole
