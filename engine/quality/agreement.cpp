#include "engine/quality/agreement.h"

#include <cmath>

#include "engine/quality/distributions.h"

namespace vignole {

namespace {

/// Half width of the confidence interval of a limit.
double halfOfLimit(const BlandAltman& result, const BlandAltmanSettings& settings) {
  const auto n = static_cast<double>(result.n);
  const double k2 = settings.sigmas * settings.sigmas;
  const double degrees = settings.method == LimitsMethod::BlandAltman1986 ? n : n - 1;
  return studentQuantile(1 - settings.alpha / 2, n - 1) * result.sd * std::sqrt(1 / n + k2 / (2 * degrees));
}

void addLimits(BlandAltman& result, const BlandAltmanSettings& settings) {
  const double reach = settings.sigmas * result.sd;
  result.limits = {result.bias - reach, result.bias + reach};
  if (settings.method != LimitsMethod::Exact) {
    const double half = halfOfLimit(result, settings);
    result.lowerInterval = {result.limits.low - half, result.limits.low + half};
    result.upperInterval = {result.limits.high - half, result.limits.high + half};
    return;
  }
  const double root = std::sqrt(static_cast<double>(result.n)), degrees = static_cast<double>(result.n) - 1;
  const double low = noncentralStudentQuantile(settings.alpha / 2, degrees, settings.sigmas * root) / root;
  const double high = noncentralStudentQuantile(1 - settings.alpha / 2, degrees, settings.sigmas * root) / root;
  result.upperInterval = {result.bias + low * result.sd, result.bias + high * result.sd};
  result.lowerInterval = {result.bias - high * result.sd, result.bias - low * result.sd};
}

std::string limitFormula(LimitsMethod method) {
  switch (method) {
    case LimitsMethod::BlandAltman1986:
      return "interval of a limit: limit +- t(1 - alpha/2, n - 1) s sqrt(1/n + k^2/(2n))";
    case LimitsMethod::Exact:
      return "interval of a limit: bias +- s t'(alpha/2, 1 - alpha/2; n - 1, k sqrt(n)) / sqrt(n)";
    case LimitsMethod::BlandAltman1999:
      break;
  }
  return "interval of a limit: limit +- t(1 - alpha/2, n - 1) s sqrt(1/n + k^2/(2(n - 1)))";
}

}  // namespace

Expected<BlandAltman> blandAltman(std::span<const double> differences, const BlandAltmanSettings& settings) {
  if (differences.size() < 3) return inputError("", "agreement needs at least three pairs");
  const Sample s = describe(differences);
  BlandAltman result;
  result.n = s.n;
  result.bias = s.mean;
  result.sd = s.sd();
  result.biasInterval = meanInterval(s, settings.alpha);
  if (result.sd > 0) {
    result.t = s.mean / (result.sd / std::sqrt(static_cast<double>(s.n)));
    result.p = studentTwoSided(result.t, s.degrees());
  } else {
    result.p = s.mean == 0 ? 1 : 0;
  }
  addLimits(result, settings);
  result.notes.formulas = {"bias = mean(d), s = sd(d); limits = bias -+ k s", limitFormula(settings.method)};
  result.notes.constants = {
      {"k", settings.sigmas}, {"alpha", settings.alpha}, {"t", studentQuantile(1 - settings.alpha / 2, s.degrees())}};
  return result;
}

Expected<Agreement> agreementStudy(std::span<const double> a, std::span<const double> b,
                                   const BlandAltmanSettings& settings) {
  if (a.size() != b.size()) return inputError("", "agreement needs pairs");
  Agreement result;
  for (std::size_t i = 0; i < a.size(); ++i) {
    result.difference.push_back(a[i] - b[i]);
    result.means.push_back(0.5 * (a[i] + b[i]));
  }
  auto differences = blandAltman(result.difference, settings);
  if (!differences) return tl::unexpected(differences.error());
  result.differences = std::move(*differences);
  const auto line = regress(result.means, result.difference);
  if (!line) return tl::unexpected(line.error());
  result.proportional = *line;

  const Sample sa = describe(a), sb = describe(b);
  double products = 0;
  for (std::size_t i = 0; i < a.size(); ++i) products += (a[i] - sa.mean) * (b[i] - sb.mean);
  const double norm = std::sqrt(sa.sumOfSquares * sb.sumOfSquares);
  result.correlation = norm > 0 ? products / norm : 0;
  const double offset = sa.mean - sb.mean;
  const double whole = sa.sumOfSquares + sb.sumOfSquares + static_cast<double>(a.size()) * offset * offset;
  result.concordance = whole > 0 ? 2 * products / whole : 1;
  result.differences.notes.formulas.emplace_back(
      "proportional bias: least squares of d over the means; concordance (Lin) = 2 s_ab / (s_a^2 + s_b^2 + bias^2)");
  return result;
}

}  // namespace vignole
