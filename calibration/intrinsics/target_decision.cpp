#include "calibration/intrinsics/target_decision.h"

#include <algorithm>
#include <cmath>

#include "calibration/intrinsics/target_errors.h"

namespace vignole {

namespace {

/// The standard deviations that the estimated points have, now that their errors are no longer noise.
TargetPrior spreadOf(const TargetFit& fit, const TargetObservations& observations, const TargetPrior& prior) {
  double inPlane = 0, outOfPlane = 0;
  for (std::size_t i = 0; i < fit.points.size(); ++i) {
    const Eigen::Vector3d off = fit.points[i] - observations.points[i];
    inPlane += off.head<2>().squaredNorm() / 2;
    outOfPlane += off.z() * off.z();
  }
  const auto count = static_cast<double>(fit.points.size());
  return {std::max(prior.inPlaneMm, std::sqrt(inPlane / count)),
          prior.outOfPlaneMm > 0 ? std::max(prior.outOfPlaneMm, std::sqrt(outOfPlane / count)) : 0};
}

struct Hypothesis {
  TargetPrior prior;
  HeldOut heldOut;
};

Expected<Hypothesis> tryOut(const TargetObservations& observations, const LensVariant& variant, const TargetFit& fit,
                            TargetPrior prior, bool priorIsGuess, CrossValidationSettings settings, const Job& job) {
  AdjustmentSettings adjustment;
  adjustment.target = prior;
  TargetFit own = prior.free() ? adjust(observations, variant, fit, adjustment) : fit;
  if (priorIsGuess) {
    adjustment.target = prior = spreadOf(own, observations, prior);
    own = adjust(observations, variant, own, adjustment);
  }
  settings.target = prior;
  auto heldOut = crossValidate(observations, std::vector{variant}, std::vector{own}, settings, job);
  if (!heldOut) return tl::unexpected<Error>(heldOut.error());
  return Hypothesis{prior, std::move(heldOut->front())};
}

}  // namespace

Expected<TargetPrior> decideTarget(const TargetObservations& observations, const LensVariant& variant,
                                   const TargetFit& fit, double statedMm, const CrossValidationSettings& settings,
                                   const Job& job) {
  constexpr double kLeastShareInPlane = 0.1;  // a bent target has its points elsewhere in the plane, too
  const TargetPrior suspected = suspectedErrors(observations, fit);
  const double inPlane = statedMm > 0 ? statedMm : suspected.inPlaneMm;
  std::vector<TargetPrior> guesses;
  if (statedMm <= 0 && inPlane > 0) guesses.push_back({inPlane, 0});
  if (suspected.outOfPlaneMm > 0)
    guesses.push_back({std::max(inPlane, kLeastShareInPlane * suspected.outOfPlaneMm), suspected.outOfPlaneMm});
  if (guesses.empty()) return TargetPrior{statedMm, 0};

  auto best = tryOut(observations, variant, fit, {statedMm, 0}, false, settings, job);
  if (!best) return tl::unexpected<Error>(best.error());
  for (const TargetPrior& guess : guesses) {
    auto hypothesis = tryOut(observations, variant, fit, guess, true, settings, job);
    if (!hypothesis) return tl::unexpected<Error>(hypothesis.error());
    if (worse(best->heldOut, hypothesis->heldOut, PointErrors::Shared, settings.confidence))
      best = std::move(hypothesis);
  }
  return best->prior;
}

}  // namespace vignole
