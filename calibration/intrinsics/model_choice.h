#pragma once
// Which lens model: judged by pictures that it has not seen.

#include <span>

#include "calibration/intrinsics/target_adjustment.h"
#include "calibration/job.h"

namespace vignole {

struct CrossValidationSettings {
  int folds = 6;              ///< of views; as many as views if there are fewer
  double pointSigmaMm = 0;    ///< the target's points are unknowns with this prior, as in AdjustmentSettings
  double standardErrors = 1;  ///< a simpler model is taken when it is worse by no more than so many
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

/// Mean over points of how much worse `a` is than `b`, px^2, and its standard error: the models were adjusted to other
/// pictures, so the noise of these points is independent of both, and of point to point. (Over views the error would be
/// larger than chance makes it: where a model is wrong it is so in the pictures that reach the edges alone.)
struct PairedDifference {
  double mean = 0, standardError = 0;
};
[[nodiscard]] PairedDifference difference(const HeldOut& a, const HeldOut& b);

/// The simplest variant that is not worse than the best by more than the standard errors allow; of several with as many
/// parameters the best.
[[nodiscard]] std::size_t chooseSimplest(std::span<const LensVariant> variants, std::span<const HeldOut> heldOut,
                                         double standardErrors);

}  // namespace vignole
