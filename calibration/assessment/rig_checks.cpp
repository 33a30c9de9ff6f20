#include "calibration/assessment/rig_checks.h"

namespace vignole {

namespace {

/// A part of a job, from .. to of its share.
Job part(const Job& whole, double from, double to) {
  return {[&whole, from, to](double share, std::string_view doing) { whole.report(from + share * (to - from), doing); },
          whole.stop};
}

}  // namespace

Expected<RigChecks> checkRig(const RigInputs& inputs, const RigAdjustmentSettings& settings,
                             const RigAdjustment& adjustment, const Section& section,
                             const DimensionParameters& parameters, const RigCheckSettings& what, const Job& job) {
  RigChecks result;
  if (!adjustment.refusals.empty()) return result;
  result.residuals = residualStatistics(adjustment);
  result.checks = residualChecks(adjustment);
  const std::vector<PinPixels> arcs = pinPixels(adjustment);
  result.seams = pairSeams(arcs, adjustment.calibration, adjustment.calibration.pins);
  result.checks.push_back(seamCheck(result.seams));
  if (what.pinFolds > 1) {
    auto folds = pinFolds(inputs, settings, adjustment, what.pinFolds, part(job, 0, 0.4));
    if (!folds) return tl::unexpected(folds.error());
    result.pinFolds = std::move(*folds);
    result.checks.push_back(foldCheck("k-fold over pins", result.pinFolds));
  }
  if (what.placements) {
    auto folds = placementFolds(inputs, settings, adjustment, part(job, 0.4, 0.8));
    if (!folds) return tl::unexpected(folds.error());
    result.placementFolds = std::move(*folds);
    result.checks.push_back(foldCheck("k-fold over placements", result.placementFolds));
  }
  if (what.reversal) {
    auto reversal = plateReversal(inputs, settings, adjustment, section, parameters, part(job, 0.8, 1));
    if (!reversal) return tl::unexpected(reversal.error());
    result.reversal = *reversal;
    result.checks.push_back(reversalCheck(result.reversal));
  }
  if (what.previous) {
    auto comparison = compare(*what.previous, adjustment.calibration, section, parameters);
    if (comparison) {
      result.comparison = *comparison;
      result.checks.push_back(comparisonCheck(*comparison));
    } else {
      result.checks.push_back({"last calibration", false, 0, 0, "", false, comparison.error().message(), ""});
    }
  }
  return result;
}

}  // namespace vignole
