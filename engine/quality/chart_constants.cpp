#include "engine/quality/chart_constants.h"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>

#include "engine/quality/distributions.h"

namespace vignole {

namespace {

/// Density of the range of n standard normal values at r > 0: n (n-1) int phi(x) phi(x + r) (Phi(x + r) -
/// Phi(x))^(n-2).
double rangeDensity(int n, double r) {
  // Centred, the integrand is even in x and analytic: the trapezoidal rule converges beyond double precision.
  constexpr double kStep = 0.125;
  constexpr int kSteps = 72;  // to 9 standard deviations on either side
  double sum = 0;
  for (int i = -kSteps; i <= kSteps; ++i) {
    const double x = kStep * i;
    const double low = x - r / 2, high = x + r / 2;
    const double between = normalProbability(high) - normalProbability(low);
    sum += std::exp(-x * x - r * r / 4) * std::pow(between, n - 2);
  }
  return n * (n - 1.0) * sum * kStep / (2 * std::numbers::pi);
}

double rangeMoment(int n, int power) {
  const auto integrand = [&](double r) { return std::pow(r, power) * rangeDensity(n, r); };
  double result = 0;
  for (const auto& [from, to] : {std::pair{0.0, 5.0}, std::pair{5.0, 16.0}})
    result += boost::math::quadrature::gauss_kronrod<double, 61>::integrate(integrand, from, to, 0);
  return result;
}

}  // namespace

double rounded(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return std::round(value * scale) / scale;
}

namespace {

ChartConstants exactConstants(int n) {
  ChartConstants c;
  c.n = n;
  c.d2 = rangeMoment(n, 1);
  c.d3 = std::sqrt(rangeMoment(n, 2) - c.d2 * c.d2);
  int sign = 0;  // lgamma_r: std::lgamma writes a global
  c.c4 = std::sqrt(2.0 / (n - 1)) * std::exp(lgamma_r(n / 2.0, &sign) - lgamma_r((n - 1) / 2.0, &sign));
  const double root = std::sqrt(static_cast<double>(n)), spread = std::sqrt(1 - c.c4 * c.c4);
  c.a2 = 3 / (c.d2 * root);
  c.d3Limit = std::max(0.0, 1 - 3 * c.d3 / c.d2);
  c.d4Limit = 1 + 3 * c.d3 / c.d2;
  c.a3 = 3 / (c.c4 * root);
  c.b3Limit = std::max(0.0, 1 - 3 * spread / c.c4);
  c.b4Limit = 1 + 3 * spread / c.c4;
  return c;
}

/// The quadratures take milliseconds, and charts ask for the same few sizes again and again.
ChartConstants known(int n) {
  static std::mutex mutex;
  static std::map<int, ChartConstants> constants;
  const std::lock_guard lock(mutex);
  const auto found = constants.find(n);
  return found != constants.end() ? found->second : constants.emplace(n, exactConstants(n)).first->second;
}

}  // namespace

ChartConstants chartConstants(int n, ConstantPrecision precision) {
  ChartConstants c = known(n);
  if (precision == ConstantPrecision::Exact) return c;
  for (double* value : {&c.d2, &c.d3, &c.a2, &c.d3Limit, &c.d4Limit, &c.a3, &c.b3Limit, &c.b4Limit})
    *value = rounded(*value, 3);
  c.c4 = rounded(c.c4, 4);
  return c;
}

double averageRangeConstant(int n, int groups) {
  const ChartConstants c = chartConstants(n, ConstantPrecision::Exact);
  return std::sqrt(c.d2 * c.d2 + c.d3 * c.d3 / groups);
}

}  // namespace vignole
