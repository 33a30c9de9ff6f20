#include "engine/quality/regression.h"

#include <cmath>
#include <limits>
#include <vector>

#include "engine/quality/distributions.h"

namespace vignole {

namespace {

/// Against 0; where nothing scatters, any difference from 0 is certain.
double ratio(double value, double sd) {
  if (sd > 0) return value / sd;
  return value == 0 ? 0 : std::copysign(std::numeric_limits<double>::infinity(), value);
}

}  // namespace

ValueRange Regression::band(double x, double alpha) const {
  const double half = studentQuantile(1 - alpha / 2, static_cast<double>(n) - 2) * sdResidual *
                      std::sqrt(1 / static_cast<double>(n) + (x - xMean) * (x - xMean) / sxx);
  return {at(x) - half, at(x) + half};
}

Expected<Regression> regress(std::span<const double> x, std::span<const double> y) {
  Regression fit;
  fit.n = x.size();
  if (fit.n < 3 || y.size() != fit.n) return inputError("", "a line with its uncertainty needs at least three points");
  const Sample sx = describe(x), sy = describe(y);
  fit.xMean = sx.mean;
  fit.sxx = sx.sumOfSquares;
  if (!(fit.sxx > 0)) return inputError("", "a line needs values at two different x at least; all are the same");
  double sxy = 0;
  for (std::size_t i = 0; i < fit.n; ++i) sxy += (x[i] - sx.mean) * (y[i] - sy.mean);
  fit.slope = sxy / fit.sxx;
  fit.intercept = sy.mean - fit.slope * sx.mean;
  double residual = 0;
  for (std::size_t i = 0; i < fit.n; ++i) {
    const double e = (y[i] - sy.mean) - fit.slope * (x[i] - sx.mean);
    residual += e * e;
  }
  const auto n = static_cast<double>(fit.n);
  fit.sdResidual = std::sqrt(residual / (n - 2));
  fit.sdSlope = fit.sdResidual / std::sqrt(fit.sxx);
  fit.sdIntercept = fit.sdResidual * std::sqrt(1 / n + sx.mean * sx.mean / fit.sxx);
  fit.r2 = sy.sumOfSquares > 0 ? 1 - residual / sy.sumOfSquares : 0;
  fit.tSlope = ratio(fit.slope, fit.sdSlope);
  fit.tIntercept = ratio(fit.intercept, fit.sdIntercept);
  fit.pSlope = studentTwoSided(fit.tSlope, n - 2);
  fit.pIntercept = studentTwoSided(fit.tIntercept, n - 2);
  return fit;
}

}  // namespace vignole
