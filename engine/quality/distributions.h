#pragma once
// Distributions of statistics (Boost.Math). Every function is NaN outside its domain and never throws.

namespace vignole {

/// P(Z <= z) and its inverse, 0 < p < 1.
[[nodiscard]] double normalProbability(double z);
[[nodiscard]] double normalQuantile(double p);

/// Student's t, degrees of freedom >= 1 (any real number, infinity included).
[[nodiscard]] double studentProbability(double t, double degreesOfFreedom);
[[nodiscard]] double studentQuantile(double p, double degreesOfFreedom);
/// P(|T| >= |t|).
[[nodiscard]] double studentTwoSided(double t, double degreesOfFreedom);
/// Student's t with non-centrality `delta`.
[[nodiscard]] double noncentralStudentQuantile(double p, double degreesOfFreedom, double delta);

[[nodiscard]] double chiSquareQuantile(double p, double degreesOfFreedom);
/// P(F >= f).
[[nodiscard]] double fisherUpperTail(double f, double numeratorDegrees, double denominatorDegrees);
[[nodiscard]] double fisherQuantile(double p, double numeratorDegrees, double denominatorDegrees);

}  // namespace vignole
