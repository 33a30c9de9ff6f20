#pragma once
// Which lens model: judged by pictures that it has not seen.

#include <span>

#include "calibration/intrinsics/target_adjustment.h"
#include "calibration/job.h"

namespace vignole {

struct CrossValidationSettings {
  int folds = 6;  ///< of views; as many as views if there are fewer
  TargetPrior target;
  double confidence = 0.995;  ///< with which a simpler model must be the worse one, to be left
};

/// One variant before pictures that its adjustment was not given: half of the points of such a picture fit its pose,
/// the others are judged, and the other way round.
struct HeldOut {
  double rmsPx = 0;                             ///< over all points
  std::vector<std::vector<double>> squaresPx2;  ///< of each point's residual, as TargetObservations::views
};

/// Of each variant. `fits` are theirs to all views. At least three views have points.
[[nodiscard]] Expected<std::vector<HeldOut>> crossValidate(const TargetObservations& observations,
                                                           std::span<const LensVariant> variants,
                                                           std::span<const TargetFit> fits,
                                                           const CrossValidationSettings& settings, const Job& job);

/// How far the errors of the points of a picture are independent.
enum class PointErrors {
  Independent,  ///< noise: the models were adjusted to other pictures, so each point is a trial of its own
  Shared        ///< by whatever is wrong with a picture: each picture is a trial
};

/// Whether `a` predicts worse than `b` with this confidence, by Student's t over the trials: of points the differences
/// of their squared residuals, of pictures the logarithms of the ratios of theirs (no single picture decides). Trials
/// of points find more where they are allowed: a model that is wrong may be so in the few pictures that reach the
/// edges.
[[nodiscard]] bool worse(const HeldOut& a, const HeldOut& b, PointErrors errors, double confidence);

/// The simplest variant that is not worse than the best; of several with as many parameters the best.
[[nodiscard]] std::size_t chooseSimplest(std::span<const LensVariant> variants, std::span<const HeldOut> heldOut,
                                         PointErrors errors, double confidence);

}  // namespace vignole
