#include "engine/measurement/verdict.h"

#include <algorithm>

namespace vignole {
namespace {

constexpr double kCoverage = 2;

int severity(Verdict verdict) {
  switch (verdict) {
    case Verdict::Fail:
      return 4;
    case Verdict::NotMeasured:
      return 3;
    case Verdict::Near:
      return 2;
    case Verdict::Pass:
      return 1;
    case Verdict::NoLimit:
      break;
  }
  return 0;
}

Verdict worse(Verdict a, Verdict b) { return severity(a) >= severity(b) ? a : b; }

Verdict against(double value, double u, std::optional<double> lower, std::optional<double> upper) {
  double room = 1e300;  // to the nearer limit, negative beyond it
  if (lower) room = std::min(room, value - *lower);
  if (upper) room = std::min(room, *upper - value);
  const double guard = kCoverage * u;
  if (room > guard) return Verdict::Pass;
  return room < -guard ? Verdict::Fail : Verdict::Near;
}

}  // namespace

std::string_view name(Verdict verdict) {
  switch (verdict) {
    case Verdict::Pass:
      return "pass";
    case Verdict::Near:
      return "near";
    case Verdict::Fail:
      return "fail";
    case Verdict::NotMeasured:
      return "not measured";
    case Verdict::NoLimit:
      break;
  }
  return "no limit";
}

void judge(Dimension dimension, const ToleranceLimits& limits, DimensionResult& result) {
  const auto asValue = [&](std::optional<double> deviation) -> std::optional<double> {
    return deviation ? std::optional(result.nominalMm + *deviation) : std::nullopt;
  };
  result.lowerMm = asValue(limits.lowerMm);
  result.upperMm = asValue(limits.upperMm);
  if (!result.lowerMm && !result.upperMm) {
    result.verdict = result.valueMm ? Verdict::NoLimit : Verdict::NotMeasured;
    return;
  }
  if (!result.valueMm) {
    result.verdict = Verdict::NotMeasured;
    return;
  }
  const double value = dimension == Dimension::FC ? std::max(0.0, *result.valueMm) : *result.valueMm;
  result.verdict = against(value, result.uMm, result.lowerMm, result.upperMm);
  if (dimension == Dimension::HF && result.secondMm)
    result.verdict = worse(result.verdict, against(*result.secondMm, result.secondUMm, result.lowerMm, result.upperMm));
}

Verdict worstOf(const PerDimension<DimensionResult>& dimensions) {
  Verdict worst = Verdict::NoLimit;
  for (const DimensionResult& d : dimensions)
    if (d.lowerMm || d.upperMm) worst = worse(worst, d.verdict);
  return worst;
}

}  // namespace vignole
