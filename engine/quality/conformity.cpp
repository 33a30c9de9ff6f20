#include "engine/quality/conformity.h"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "engine/quality/distributions.h"

namespace vignole {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

double lowerOf(const ToleranceZone& zone) { return zone.lower.value_or(-kInfinite); }
double upperOf(const ToleranceZone& zone) { return zone.upper.value_or(kInfinite); }

/// P(low <= N(mean, sd) <= high), from the tail that is small.
double between(double low, double high, double mean, double sd) {
  if (!(high > low)) return 0;
  const double a = (low - mean) / sd, b = (high - mean) / sd;
  if (a > 0) return normalProbability(-a) - normalProbability(-b);
  return normalProbability(b) - normalProbability(a);
}

/// Integral over the process of `outcome(true value)`, from low to high, cut where the integrand bends.
template <typename Outcome>
double overProcess(const ProcessSpread& process, double u, double low, double high, const ToleranceZone& acceptance,
                   Outcome outcome) {
  constexpr double kFar = 10;
  low = std::max(low, process.mean - kFar * process.sd);
  high = std::min(high, process.mean + kFar * process.sd);
  if (!(high > low)) return 0;
  const auto integrand = [&](double eta) {
    const double z = (eta - process.mean) / process.sd;
    return std::exp(-0.5 * z * z) / (process.sd * std::sqrt(2 * std::numbers::pi)) * outcome(eta);
  };
  std::vector<double> cuts = {low, high};
  for (const double edge : {lowerOf(acceptance), upperOf(acceptance)})
    for (const double away : {-8.0, -2.0, 0.0, 2.0, 8.0})
      if (const double cut = edge + away * u; cut > low && cut < high) cuts.push_back(cut);
  for (const double away : {-3.0, 0.0, 3.0})
    if (const double cut = process.mean + away * process.sd; cut > low && cut < high) cuts.push_back(cut);
  std::sort(cuts.begin(), cuts.end());
  double sum = 0;
  for (std::size_t i = 1; i < cuts.size(); ++i)
    sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(integrand, cuts[i - 1], cuts[i], 0);
  return sum;
}

}  // namespace

std::string_view name(Conformity conformity) {
  constexpr std::array<std::string_view, 3> kNames = {"conforms", "does not conform", "cannot be decided"};
  return kNames.at(static_cast<std::size_t>(conformity));
}

ToleranceZone acceptanceZone(double u, const ToleranceZone& tolerance, double guardSigmas) {
  ToleranceZone zone = tolerance;
  if (zone.lower) *zone.lower += guardSigmas * u;
  if (zone.upper) *zone.upper -= guardSigmas * u;
  return zone;
}

Conformity conformity(double value, double u, const ToleranceZone& tolerance, double guardSigmas) {
  const ToleranceZone accepted = acceptanceZone(u, tolerance, guardSigmas);
  const ToleranceZone rejected = acceptanceZone(u, tolerance, -guardSigmas);
  if (value < lowerOf(rejected) || value > upperOf(rejected)) return Conformity::DoesNotConform;
  if (value >= lowerOf(accepted) && value <= upperOf(accepted)) return Conformity::Conforms;
  return Conformity::CannotBeDecided;
}

double conformanceProbability(double value, double u, const ToleranceZone& tolerance) {
  const double low = lowerOf(tolerance), high = upperOf(tolerance);
  if (!(u > 0)) return value >= low && value <= high ? 1 : 0;
  return between(low, high, value, u);
}

ConformityRisks conformityRisks(const ProcessSpread& process, double u, const ToleranceZone& tolerance,
                                const ToleranceZone& acceptance) {
  const double low = lowerOf(tolerance), high = upperOf(tolerance);
  const double from = lowerOf(acceptance), to = upperOf(acceptance);
  const auto accepted = [&](double eta) { return between(from, to, eta, u); };
  const auto rejected = [&](double eta) {
    return to > from ? normalProbability((from - eta) / u) + normalProbability((eta - to) / u) : 1.0;
  };
  ConformityRisks risks;
  risks.consumer = overProcess(process, u, -kInfinite, low, acceptance, accepted) +
                   overProcess(process, u, high, kInfinite, acceptance, accepted);
  risks.producer = overProcess(process, u, low, high, acceptance, rejected);
  risks.bad =
      normalProbability((low - process.mean) / process.sd) + normalProbability((process.mean - high) / process.sd);
  return risks;
}

}  // namespace vignole
