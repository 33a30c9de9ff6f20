#pragma once
// Points and pictures that do not fit the others.

#include <string>
#include <vector>

#include "calibration/intrinsics/target_adjustment.h"

namespace vignole {

struct OutlierSettings {
  double pointSigmas = 5;       ///< a point further off than this many standard deviations is rejected
  double viewRatio = 3;         ///< a picture whose points are this many times as far off as those of all is rejected
  double maxPointShare = 0.25;  ///< a picture is rejected that loses more of its points than this
};

/// Which points of which views count; a view that is rejected has its reason.
struct Selection {
  std::vector<std::vector<bool>> points;   ///< as TargetObservations::views
  std::vector<std::string> viewRejection;  ///< empty: used

  [[nodiscard]] static Selection all(const TargetObservations& observations);
  [[nodiscard]] std::size_t usedViews() const;
  friend bool operator==(const Selection&, const Selection&) = default;
};

/// Only what counts; rejected views stay as empty ones.
[[nodiscard]] TargetObservations selected(const TargetObservations& all, const Selection& selection);

/// The noise that the points' own uncertainties do not account for, the same for all points, px: added in squares it
/// makes the median residual what it should be. 0 where they account for all.
[[nodiscard]] double unexplainedNoise(const TargetObservations& observations,
                                      const std::vector<std::vector<Point2>>& residuals);
/// The same by the sum of squares of the residuals (no outliers among them), with their degrees of freedom.
[[nodiscard]] double unexplainedNoise(const TargetObservations& observations,
                                      const std::vector<std::vector<Point2>>& residuals, double degreesOfFreedom);
/// sigmaPx of every point by uPx and that noise.
void weigh(TargetObservations& observations, double unexplainedPx);

/// Judges all points, also those that were rejected before, by their residuals and sigmaPx. Views rejected in `before`
/// stay rejected.
[[nodiscard]] Selection judge(const TargetObservations& all, const std::vector<std::vector<Point2>>& residuals,
                              const Selection& before, const OutlierSettings& settings);

}  // namespace vignole
