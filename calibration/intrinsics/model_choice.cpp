#include "calibration/intrinsics/model_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "calibration/parallel_for.h"
#include "engine/quality/running_statistics.h"

namespace vignole {

namespace {

constexpr double kTolerance = 1e-8;  // what is left to go moves no prediction that matters

/// The views that have points, dealt out to folds in turn.
std::vector<std::vector<std::size_t>> foldsOf(const TargetObservations& observations, int wanted) {
  std::vector<std::size_t> views;
  for (std::size_t v = 0; v < observations.views.size(); ++v)
    if (!observations.views[v].empty()) views.push_back(v);
  const std::size_t count = std::min(views.size(), static_cast<std::size_t>(std::max(2, wanted)));
  std::vector<std::vector<std::size_t>> folds(count);
  for (std::size_t i = 0; i < views.size(); ++i) folds[i % count].push_back(views[i]);
  return folds;
}

/// Squares of the residuals of all points of a view, each judged while the other half fits the pose.
std::vector<double> judgedSquares(const ObservedView& view, std::size_t v, const TargetObservations& observations,
                                  const LensVariant& variant, const TargetFit& trained) {
  AdjustmentSettings pose;
  pose.posesOnly = true;
  pose.tolerance = kTolerance;
  std::vector<double> squares(view.size());
  for (const std::size_t half : {0U, 1U}) {
    TargetObservations fitted{observations.points, observations.radiusMm, {{}}}, judged = fitted;
    for (std::size_t i = 0; i < view.size(); ++i) (i % 2 == half ? fitted : judged).views[0].push_back(view[i]);
    const TargetFit start{trained.intrinsics, {trained.cameraFromTarget[v]}, trained.points, true};
    const auto all = residuals(judged, adjust(fitted, variant, start, pose));
    for (std::size_t i = 0; i < all.front().size(); ++i) squares[2 * i + 1 - half] = all.front()[i].squaredNorm();
  }
  return squares;
}

void holdOut(const std::vector<std::size_t>& fold, const TargetObservations& observations, const LensVariant& variant,
             const TargetFit& fit, const TargetPrior& target, HeldOut& result) {
  TargetObservations training = observations;
  for (const std::size_t v : fold) training.views[v].clear();
  AdjustmentSettings settings;
  settings.target = target;
  settings.tolerance = kTolerance;
  const TargetFit trained = adjust(training, variant, fit, settings);
  for (const std::size_t v : fold)
    result.squaresPx2[v] = judgedSquares(observations.views[v], v, observations, variant, trained);
}

double rms(const HeldOut& h) {
  double sum = 0, points = 0;
  for (const auto& view : h.squaresPx2)
    for (const double square : view) {
      sum += square;
      points += 1;
    }
  return std::isfinite(sum) ? std::sqrt(sum / points) : std::numeric_limits<double>::infinity();
}

/// Values whose mean is asked for.
class Trials {
 public:
  void add(double value) {
    count_ += 1;
    sum_ += value;
    squares_ += value * value;
  }
  /// The mean lies above 0.
  [[nodiscard]] bool beyondChance(double confidence) const {
    if (count_ < 2) return false;
    const double mean = sum_ / count_;
    const double variance = std::max(0.0, squares_ / count_ - mean * mean) / (count_ - 1);
    return mean > studentQuantile(confidence, count_ - 1) * std::sqrt(variance);
  }

 private:
  double count_ = 0, sum_ = 0, squares_ = 0;
};

Trials trialsOfPoints(const HeldOut& a, const HeldOut& b) {
  Trials trials;
  for (std::size_t v = 0; v < a.squaresPx2.size(); ++v)
    for (std::size_t i = 0; i < a.squaresPx2[v].size(); ++i) trials.add(a.squaresPx2[v][i] - b.squaresPx2[v][i]);
  return trials;
}

Trials trialsOfViews(const HeldOut& a, const HeldOut& b) {
  Trials trials;
  for (std::size_t v = 0; v < a.squaresPx2.size(); ++v) {
    if (a.squaresPx2[v].empty()) continue;
    const auto sum = [v](const HeldOut& h) {
      return std::accumulate(h.squaresPx2[v].begin(), h.squaresPx2[v].end(), std::numeric_limits<double>::min());
    };
    trials.add(std::log(sum(a) / sum(b)));
  }
  return trials;
}

}  // namespace

Expected<std::vector<HeldOut>> crossValidate(const TargetObservations& observations,
                                             std::span<const LensVariant> variants, std::span<const TargetFit> fits,
                                             const CrossValidationSettings& settings, const Job& job) {
  const auto folds = foldsOf(observations, settings.folds);
  std::vector<HeldOut> heldOut(variants.size());
  for (HeldOut& h : heldOut) h.squaresPx2.resize(observations.views.size());
  parallelFor(variants.size() * folds.size(), [&](std::size_t i) {
    const std::size_t variant = i / folds.size();
    if (job.cancelled()) return;
    holdOut(folds[i % folds.size()], observations, variants[variant], fits[variant], settings.target, heldOut[variant]);
  });
  if (job.cancelled()) return cancelledError();
  for (HeldOut& h : heldOut) h.rmsPx = rms(h);
  return heldOut;
}

bool worse(const HeldOut& a, const HeldOut& b, PointErrors errors, double confidence) {
  // What could not be predicted at all has no mean to be compared.
  if (!std::isfinite(a.rmsPx) || !std::isfinite(b.rmsPx)) return !std::isfinite(a.rmsPx) && std::isfinite(b.rmsPx);
  const Trials trials = errors == PointErrors::Independent ? trialsOfPoints(a, b) : trialsOfViews(a, b);
  return trials.beyondChance(confidence);
}

std::size_t chooseSimplest(std::span<const LensVariant> variants, std::span<const HeldOut> heldOut, PointErrors errors,
                           double confidence) {
  const auto better = [&](std::size_t a, std::size_t b) { return heldOut[a].rmsPx < heldOut[b].rmsPx; };
  std::size_t best = 0;
  for (std::size_t i = 1; i < variants.size(); ++i)
    if (better(i, best)) best = i;
  std::size_t chosen = best;
  const auto size = [&](std::size_t i) { return freeParameters(variants[i]).size(); };
  for (std::size_t i = 0; i < variants.size(); ++i) {
    if (size(i) > size(chosen) || (size(i) == size(chosen) && !better(i, chosen))) continue;
    if (!worse(heldOut[i], heldOut[best], errors, confidence)) chosen = i;
  }
  return chosen;
}

}  // namespace vignole
