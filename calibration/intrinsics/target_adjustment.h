#pragma once
// The paper's Eq. (1) over all views of a flat target: residuals in distorted pixels, by Ceres.

#include <vector>

#include "calibration/intrinsics/lens_variant.h"
#include "calibration/intrinsics/reprojection.h"

namespace vignole {

struct Observation {
  int point = 0;  ///< index in TargetObservations::points
  Point2 px{0, 0};
  double uPx = 0;      ///< standard uncertainty of each coordinate by the finder
  double sigmaPx = 1;  ///< what it is weighted by: uPx and what that does not know of
};
using ObservedView = std::vector<Observation>;

struct TargetObservations {
  std::vector<Eigen::Vector3d> points;  ///< of the target, as stated, mm
  double radiusMm = 0;                  ///< of circles
  std::vector<ObservedView> views;
};

/// What an adjustment estimates, and where it starts.
struct TargetFit {
  Intrinsics intrinsics;
  std::vector<Extrinsics> cameraFromTarget;  ///< a pose for each view
  std::vector<Eigen::Vector3d> points;       ///< of the target
  bool converged = false;
};

/// What is known beforehand of where the target's points are: normal, around where they are stated. In-plane 0: they
/// are as stated, and no unknowns; out of plane 0: the target is flat.
struct TargetPrior {
  double inPlaneMm = 0;  ///< standard deviation of x and of y
  double outOfPlaneMm = 0;
  [[nodiscard]] bool free() const { return inPlaneMm > 0; }
};

struct AdjustmentSettings {
  bool robust = false;     ///< Cauchy loss beyond two standard deviations of a point
  bool posesOnly = false;  ///< intrinsics and points stay
  TargetPrior target;
  int maxIterations = 100;
  double tolerance = 1e-10;  ///< least relative change of the cost to go on: a thousandth of a standard deviation
};

/// Parameters that the variant has not stay as they are in `start` (see asVariant).
[[nodiscard]] TargetFit adjust(const TargetObservations& observations, const LensVariant& variant,
                               const TargetFit& start, const AdjustmentSettings& settings = {});

/// Residuals in px (predicted less observed), view by view in the order of the observations; NaN where a point cannot
/// be projected.
[[nodiscard]] std::vector<std::vector<Point2>> residuals(const TargetObservations& observations, const TargetFit& fit);

}  // namespace vignole
