#include "engine/quality/accuracy.h"

#include <cmath>
#include <map>
#include <set>

namespace vignole {

namespace {

constexpr double kCoverage = 2;  // E_n compares expanded uncertainties, k = 2 (ISO 13528)

AccuracyFigures figuresOf(const std::vector<const AccuracyPoint*>& points) {
  std::vector<double> errors, references;
  double squares = 0, max = 0, maxReference = 0;
  for (const AccuracyPoint* p : points) {
    const double error = p->value - p->reference;
    errors.push_back(error);
    references.push_back(p->reference);
    squares += error * error;
    if (std::abs(error) >= std::abs(max)) {
      max = error;
      maxReference = p->reference;
    }
  }
  const Sample s = describe(errors);
  AccuracyFigures f;
  f.n = s.n;
  f.bias = s.mean;
  f.sd = s.sd();
  f.rms = std::sqrt(squares / static_cast<double>(s.n));
  f.max = max;
  const double reference = meanOf(references);
  if (reference != 0) {
    f.biasPercent = 100 * f.bias / std::abs(reference);
    f.rmsPercent = 100 * f.rms / std::abs(reference);
  }
  if (maxReference != 0) f.maxPercent = 100 * f.max / std::abs(maxReference);
  return f;
}

void addNormalisedErrors(AccuracyResult& result, const std::vector<AccuracyPoint>& points) {
  for (const AccuracyPoint& p : points) {
    if (!(p.u > 0 && p.uReference > 0)) continue;
    const double en = (p.value - p.reference) / (kCoverage * std::hypot(p.u, p.uReference));
    result.en.push_back(en);
    result.enMax = std::max(result.enMax, std::abs(en));
    if (std::abs(en) > 1) ++result.enBeyond1;
  }
}

}  // namespace

Expected<AccuracyResult> accuracyStudy(const std::vector<AccuracyPoint>& points, const BlandAltmanSettings& settings) {
  if (points.empty()) return inputError("", "accuracy needs at least one value with its reference");
  AccuracyResult result;
  std::map<double, std::vector<const AccuracyPoint*>> byPosition;
  std::vector<const AccuracyPoint*> all;
  std::set<std::string> runs;
  std::vector<double> errors;
  for (const AccuracyPoint& p : points) {
    all.push_back(&p);
    byPosition[p.positionM].push_back(&p);
    runs.insert(p.run);
    errors.push_back(p.value - p.reference);
  }
  result.whole = figuresOf(all);
  result.positions = byPosition.size();
  result.runs = runs.size();
  std::vector<double> positionBias;
  for (const auto& [position, here] : byPosition) {
    result.positionM.push_back(position);
    result.perPosition.push_back(figuresOf(here));
    positionBias.push_back(result.perPosition.back().bias);
  }
  if (positionBias.size() >= 2) result.biasInterval = meanInterval(describe(positionBias), settings.alpha);
  if (errors.size() >= 3)
    if (auto agreement = blandAltman(errors, settings)) result.agreement = std::move(*agreement);
  addNormalisedErrors(result, points);
  result.notes.formulas = {
      "error = value - reference; bias = mean(error); RMS = sqrt(mean(error^2)); % of the reference",
      "interval of the bias: means of the positions, Student's t",
      "E_n = error / sqrt(U^2 + U_ref^2), U = 2 u; |E_n| <= 1 agrees"};
  if (result.agreement)
    result.notes.formulas.insert(result.notes.formulas.end(), result.agreement->notes.formulas.begin(),
                                 result.agreement->notes.formulas.end());
  result.notes.constants = {{"alpha", settings.alpha}, {"k_agreement", settings.sigmas}, {"k_U", kCoverage}};
  return result;
}

}  // namespace vignole
