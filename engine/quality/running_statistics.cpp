#include "engine/quality/running_statistics.h"

namespace vignole {

namespace {

/// Continued fraction of the incomplete beta function by Lentz's method (Numerical Recipes, 6.4; DLMF 8.17.22).
double betaFraction(double a, double b, double x) {
  constexpr double kTiny = 1e-300;
  const auto kept = [](double v) { return std::abs(v) < kTiny ? kTiny : v; };
  double c = 1;
  double d = 1 / kept(1 - (a + b) * x / (a + 1));
  double fraction = d;
  for (int m = 1; m < 100000; ++m) {
    const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
    d = 1 / kept(1 + even * d);
    c = kept(1 + even / c);
    fraction *= d * c;
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
    d = 1 / kept(1 + odd * d);
    c = kept(1 + odd / c);
    fraction *= d * c;
    if (std::abs(d * c - 1) < 1e-15) break;
  }
  return fraction;
}

/// std::lgamma writes a global sign: two threads that ask for their statistics would race.
double logGamma(double x) {
  int sign = 0;
  return lgamma_r(x, &sign);
}

/// Regularised incomplete beta function I_x(a, b), `y` = 1 - x given apart so that nothing is lost near 1.
double incompleteBeta(double a, double b, double x, double y) {
  if (x <= 0) return 0;
  if (y <= 0) return 1;
  const double logX = x < 0.5 ? std::log(x) : std::log1p(-y);
  const double front = std::exp(logGamma(a + b) - logGamma(a) - logGamma(b) + a * logX + b * std::log(y));
  if (x < (a + 1) / (a + b + 2)) return front * betaFraction(a, b, x) / a;
  return 1 - front * betaFraction(b, a, y) / b;
}

/// Probability of exceeding t >= 0.
double upperTail(double t, double nu) {
  const double sum = nu + t * t;
  return 0.5 * incompleteBeta(nu / 2, 0.5, nu / sum, t * t / sum);
}

}  // namespace

double studentQuantile(double p, double degreesOfFreedom) {
  if (!(p > 0 && p < 1 && degreesOfFreedom >= 1)) return std::numeric_limits<double>::quiet_NaN();
  if (p == 0.5) return 0;
  const double nu = std::min(degreesOfFreedom, 1e7);  // beyond, less than 1e-6 from the normal distribution
  const double tail = std::min(p, 1 - p);

  double low = 0, high = 1;
  while (upperTail(high, nu) > tail) {
    low = high;
    high *= 2;
  }
  // The tail falls monotonically: halving the bracket to the last bit is simple and never fails.
  for (int i = 0; i < 200 && high - low > 1e-14 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (upperTail(middle, nu) > tail ? low : high) = middle;
  }
  const double t = 0.5 * (low + high);
  return p < 0.5 ? -t : t;
}

double fisherUpperTail(double f, double dofNumerator, double dofDenominator) {
  if (!(f >= 0 && dofNumerator > 0 && dofDenominator > 0)) return std::numeric_limits<double>::quiet_NaN();
  if (std::isinf(f)) return 0;
  const double sum = dofDenominator + dofNumerator * f;
  return incompleteBeta(dofDenominator / 2, dofNumerator / 2, dofDenominator / sum, dofNumerator * f / sum);
}

double ucl99(const RunningStatistics& statistics) {
  const std::uint64_t n = statistics.count();
  if (n < 2) return statistics.mean();
  const auto count = static_cast<double>(n);
  return statistics.mean() + studentQuantile(0.995, count - 1) * statistics.sd() / std::sqrt(count);
}

}  // namespace vignole
