#include "engine/quality/precision.h"

#include <algorithm>
#include <cmath>

#include "engine/quality/distributions.h"

namespace vignole {

namespace {

constexpr double kLimitFactor = 2.8;  // ISO 5725-6: 1.96 sqrt(2), rounded

void addConsistency(PrecisionResult& result) {
  std::vector<double> means, sds, variances;
  for (const Sample& g : result.groups) {
    means.push_back(g.mean);
    sds.push_back(g.sd());
    variances.push_back(g.variance());
  }
  result.grubbsTest = grubbs(means);
  result.doubleGrubbsTest = doubleGrubbs(means);
  const std::size_t size = result.groups.front().n;
  const bool equal =
      std::all_of(result.groups.begin(), result.groups.end(), [&](const Sample& g) { return g.n == size; });
  if (!equal) return;
  result.cochranTest = cochran(variances, size);
  result.consistency = mandel(means, sds, size);
}

}  // namespace

Expected<PrecisionResult> precisionStudy(const std::vector<PrecisionGroup>& groups, double alpha) {
  PrecisionResult result;
  std::vector<double> all;
  double within = 0, withinDegrees = 0, squaredSizes = 0;
  // From the first value: differences of means keep the digits that a large common offset would take.
  const double shift = groups.empty() || groups.front().values.empty() ? 0.0 : groups.front().values.front();
  for (const PrecisionGroup& g : groups) {
    if (g.values.empty()) return inputError("group " + g.name, "has no values");
    std::vector<double> shifted;
    for (const double v : g.values) shifted.push_back(v - shift);
    result.groups.push_back(describe(shifted));
    within += result.groups.back().sumOfSquares;
    withinDegrees += result.groups.back().degrees();
    squaredSizes += static_cast<double>(g.values.size()) * static_cast<double>(g.values.size());
    all.insert(all.end(), shifted.begin(), shifted.end());
  }
  if (groups.size() < 2) return inputError("", "precision needs at least two groups");
  if (!(withinDegrees > 0)) return inputError("", "repeatability needs at least two values in a group");

  const Sample whole = describe(all);
  result.n = whole.n;
  result.mean = whole.mean + shift;
  double between = 0;
  for (const Sample& g : result.groups)
    between += static_cast<double>(g.n) * (g.mean - whole.mean) * (g.mean - whole.mean);
  const auto p = static_cast<double>(groups.size()), n = static_cast<double>(whole.n);
  result.msBetween = between / (p - 1);
  result.msWithin = within / withinDegrees;
  result.f = result.msBetween / result.msWithin;
  result.p = fisherUpperTail(result.f, p - 1, withinDegrees);

  const double meanSize = (n - squaredSizes / n) / (p - 1);
  const double variance = std::max(0.0, (result.msBetween - result.msWithin) / meanSize);
  result.sr = std::sqrt(result.msWithin);
  result.sL = std::sqrt(variance);
  result.sR = std::sqrt(result.msWithin + variance);
  result.srInterval = sdInterval(result.sr, withinDegrees, alpha);
  result.r = kLimitFactor * result.sr;
  result.R = kLimitFactor * result.sR;
  addConsistency(result);
  for (Sample& g : result.groups) {
    g.mean += shift;
    g.min += shift;
    g.max += shift;
  }
  result.notes.formulas = {"s_r^2 = MS_within = sum (n_i - 1) s_i^2 / sum (n_i - 1)",
                           "s_L^2 = max(0, (MS_between - MS_within) / n), n = (N - sum n_i^2 / N) / (p - 1)",
                           "s_R^2 = s_r^2 + s_L^2; r = 2.8 s_r; R = 2.8 s_R",
                           "Cochran C = s_max^2 / sum s_i^2; Grubbs G = max |x - mean| / s on the group means",
                           "Mandel h = (mean_i - mean) / s(means); k = s_i / sqrt(sum s_i^2 / p)"};
  result.notes.constants = {{"limit_factor", kLimitFactor}, {"alpha", alpha}, {"n_mean", meanSize}};
  return result;
}

}  // namespace vignole
