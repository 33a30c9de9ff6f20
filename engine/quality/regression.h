#pragma once
// A straight line through points by least squares, from deviations of the means: nothing cancels.

#include <span>

#include "engine/geometry/expected.h"
#include "engine/quality/sample.h"

namespace vignole {

struct Regression {
  std::size_t n = 0;
  double slope = 0, intercept = 0;
  double sdSlope = 0, sdIntercept = 0;
  double sdResidual = 0;  ///< n - 2 degrees of freedom
  double r2 = 0;
  double tSlope = 0, pSlope = 0, tIntercept = 0, pIntercept = 0;  ///< against 0, two-sided
  double xMean = 0, sxx = 0;

  [[nodiscard]] double at(double x) const { return intercept + slope * x; }
  /// Of the line (not of a single value) at x.
  [[nodiscard]] ValueRange band(double x, double alpha) const;
};

/// At least three points at two different x.
[[nodiscard]] Expected<Regression> regress(std::span<const double> x, std::span<const double> y);

}  // namespace vignole
