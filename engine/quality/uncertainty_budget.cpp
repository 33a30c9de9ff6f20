#include "engine/quality/uncertainty_budget.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "engine/quality/distributions.h"

namespace vignole {

namespace {

constexpr std::array<std::string_view, 5> kDistributions = {"auto", "normal", "rectangular", "triangular", "arcsine"};

double sumOfEstimates(const UncertaintyBudget& budget, std::span<const double> x) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += budget.inputs[i].sensitivity * x[i];
  return sum;
}

double valueAt(const UncertaintyBudget& budget, std::span<const double> x) {
  return budget.model ? budget.model(x) : sumOfEstimates(budget, x);
}

/// Central differences at two steps, extrapolated (Richardson): exact for models up to the fourth order.
double derivative(const UncertaintyBudget& budget, std::vector<double>& x, std::size_t i) {
  const BudgetInput& input = budget.inputs[i];
  if (!budget.model) return input.sensitivity;
  if (!(input.u > 0)) return 0;
  const double step = 0.02 * input.u;
  const auto slope = [&](double h) {
    x[i] = input.estimate + h;
    const double above = budget.model(x);
    x[i] = input.estimate - h;
    const double below = budget.model(x);
    x[i] = input.estimate;
    return (above - below) / (2 * h);
  };
  return (4 * slope(step) - slope(2 * step)) / 3;
}

/// One draw of an input, as a deviation from its estimate.
class Draw {
 public:
  explicit Draw(const BudgetInput& input) : input_(input) {
    if (std::isfinite(input.degrees)) student_ = std::student_t_distribution<double>(input.degrees);
  }
  double operator()(std::mt19937_64& random) {
    switch (input_.distribution) {
      case InputDistribution::Rectangular:
        return input_.u * std::sqrt(3.0) * (2 * uniform_(random) - 1);
      case InputDistribution::Triangular: {
        const double a = uniform_(random), b = uniform_(random);
        return input_.u * std::sqrt(6.0) * (a + b - 1);
      }
      case InputDistribution::ArcSine:
        return input_.u * std::sqrt(2.0) * std::sin(2 * std::numbers::pi * uniform_(random));
      case InputDistribution::Normal:
        return input_.u * normal_(random);
      case InputDistribution::Auto:
        break;
    }
    return input_.u * (std::isfinite(input_.degrees) ? student_(random) : normal_(random));
  }

 private:
  const BudgetInput& input_;
  std::uniform_real_distribution<double> uniform_;
  std::normal_distribution<double> normal_;
  std::student_t_distribution<double> student_;
};

/// Sorted, p between two order statistics.
double quantileOf(std::span<const double> sorted, double p) {
  const double at = p * static_cast<double>(sorted.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at), sorted.size() - 2);
  return sorted[i] + (at - static_cast<double>(i)) * (sorted[i + 1] - sorted[i]);
}

/// Half a unit of the last of `digits` significant digits of u.
double halfUnit(double u, int digits) {
  return u > 0 ? 0.5 * std::pow(10.0, std::floor(std::log10(u)) - (digits - 1)) : 0;
}

MonteCarlo simulate(const UncertaintyBudget& budget, const UncertaintySettings& settings,
                    const UncertaintyResult& first) {
  std::mt19937_64 random(settings.seed);
  std::vector<Draw> draws;
  std::vector<double> x;
  bool hasVariance = true;
  for (std::size_t i = 0; i < budget.inputs.size(); ++i) {
    const BudgetInput& input = budget.inputs[i];
    draws.emplace_back(input);
    x.push_back(input.estimate);
    const bool student = input.distribution == InputDistribution::Auto && std::isfinite(input.degrees);
    if (student && input.degrees <= 2 && input.u > 0 && (budget.model || input.sensitivity != 0)) hasVariance = false;
  }
  std::vector<double> values;
  values.reserve(settings.trials);
  for (std::size_t t = 0; t < settings.trials; ++t) {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = budget.inputs[i].estimate + draws[i](random);
    values.push_back(valueAt(budget, x));
  }
  // Where the model is not defined for some draws, they belong to no interval; the count says so.
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  MonteCarlo result;
  result.trials = values.size();
  if (values.size() < 2) return result;
  std::sort(values.begin(), values.end());
  const Sample s = describe(values);
  result.mean = s.mean;
  if (hasVariance) result.u = s.sd();
  result.interval95 = {quantileOf(values, 0.025), quantileOf(values, 0.975)};
  result.tolerance = halfUnit(first.uc > 0 ? first.uc : s.sd(), settings.significantDigits);
  result.agrees = !first.refused && result.trials == settings.trials &&
                  std::abs(first.value - first.u95 - result.interval95.low) <= result.tolerance &&
                  std::abs(first.value + first.u95 - result.interval95.high) <= result.tolerance;
  return result;
}

/// Welch-Satterthwaite over the contributions that have finite degrees of freedom.
void addExpansion(UncertaintyResult& result, const UncertaintyBudget& budget, const UncertaintySettings& settings) {
  double sum = 0;
  for (std::size_t i = 0; i < budget.inputs.size(); ++i)
    if (std::isfinite(budget.inputs[i].degrees))
      sum += std::pow(result.lines[i].contribution / result.uc, 4) / budget.inputs[i].degrees;
  result.degrees = sum > 0 ? 1 / sum : std::numeric_limits<double>::infinity();
  double lookedUp = result.degrees;
  if (result.degrees < 1e9) {
    result.truncatedDegrees = std::max(1L, static_cast<long>(result.degrees * (1 + 1e-12)));
    lookedUp = static_cast<double>(*result.truncatedDegrees);
  }
  result.k95 = std::isinf(lookedUp) ? normalQuantile(0.975) : studentQuantile(0.975, lookedUp);
  result.k99 = std::isinf(lookedUp) ? normalQuantile(0.995) : studentQuantile(0.995, lookedUp);
  result.u95 = result.k95 * result.uc;
  result.u99 = result.k99 * result.uc;
  result.expanded = settings.k * result.uc;
}

}  // namespace

std::optional<InputDistribution> inputDistributionNamed(std::string_view name) {
  if (name.empty() || name == "t") return InputDistribution::Auto;
  for (std::size_t i = 0; i < kDistributions.size(); ++i)
    if (kDistributions.at(i) == name) return static_cast<InputDistribution>(i);
  return {};
}

Expected<UncertaintyResult> uncertaintyStudy(const UncertaintyBudget& budget, const UncertaintySettings& settings) {
  if (budget.inputs.empty()) return inputError("", "a budget needs at least one contribution");
  std::vector<double> x;
  for (const BudgetInput& input : budget.inputs) {
    if (!(input.u >= 0)) return inputError(input.symbol, "its standard uncertainty must be 0 or more");
    if (!(input.degrees > 0))
      return inputError(input.symbol, "its degrees of freedom must be above 0; empty is infinite");
    x.push_back(input.estimate);
  }
  UncertaintyResult result;
  result.value = valueAt(budget, x);
  double squares = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    BudgetLine line;
    line.sensitivity = derivative(budget, x, i);
    line.contribution = std::abs(line.sensitivity) * budget.inputs[i].u;
    squares += line.contribution * line.contribution;
    result.lines.push_back(line);
  }
  if (!std::isfinite(result.value) || !std::isfinite(squares))
    return inputError("model", "has no finite value or slope at the estimates");
  result.uc = std::sqrt(squares);
  result.refused = !(result.uc > 0);
  if (!result.refused) {
    for (BudgetLine& line : result.lines) line.percent = 100 * line.contribution * line.contribution / squares;
    addExpansion(result, budget, settings);
  }
  if (settings.trials > 1) result.monteCarlo = simulate(budget, settings, result);
  result.notes.formulas = {
      "u_c^2 = sum (c_i u_i)^2, inputs uncorrelated, first order (JCGM 100)",
      "nu_eff = u_c^4 / sum (c_i u_i)^4 / nu_i (Welch-Satterthwaite), truncated before the t look-up",
      "U_p = t((1 + p)/2, nu_eff) u_c; U = k u_c",
      "Monte Carlo (JCGM 101): t for finite degrees of freedom, else as named; first order agrees where "
      "both ends of its 95 % interval lie within half the last significant digit of u"};
  result.notes.constants = {{"k", settings.k},
                            {"trials", static_cast<double>(settings.trials)},
                            {"seed", static_cast<double>(settings.seed)},
                            {"significant_digits", settings.significantDigits}};
  return result;
}

}  // namespace vignole
