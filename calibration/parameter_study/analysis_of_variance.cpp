#include "calibration/parameter_study/analysis_of_variance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "calibration/parameter_study/effect_model.h"
#include "engine/quality/running_statistics.h"

namespace vignole {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::vector<int> levelCounts(const std::vector<Factor>& factors) {
  std::vector<int> counts;
  for (const Factor& factor : factors) counts.push_back(static_cast<int>(factor.levels.size()));
  return counts;
}

std::string nameOf(const EffectTerm& term, const std::vector<Factor>& factors) {
  std::string name;
  for (const int f : term) name += (name.empty() ? "" : " x ") + factors[static_cast<std::size_t>(f)].name;
  return name;
}

/// Blocks numbered without gaps, in ascending order.
std::map<int, int> denseBlocks(const std::vector<Observation>& observations) {
  std::map<int, int> dense;
  for (const Observation& o : observations) dense.emplace(o.block, 0);
  int next = 0;
  for (auto& [block, index] : dense) index = next++;
  return dense;
}

EffectModel modelOf(const std::vector<Factor>& factors, const std::vector<Observation>& observations, int order) {
  const auto blocks = denseBlocks(observations);
  EffectModel model(levelCounts(factors), std::max(1, static_cast<int>(blocks.size())),
                    effectTerms(static_cast<int>(factors.size()), order));
  for (const Observation& o : observations) model.add(o.combination, blocks.at(o.block), o.value);
  return model;
}

bool contains(const EffectTerm& outer, const EffectTerm& inner) {
  return std::includes(outer.begin(), outer.end(), inner.begin(), inner.end());
}

bool isBalanced(const std::vector<Factor>& factors, const std::vector<Observation>& observations) {
  std::map<std::pair<Combination, int>, int> cells;
  std::set<int> blocks;
  for (const Observation& o : observations) {
    ++cells[{o.combination, o.block}];
    blocks.insert(o.block);
  }
  std::size_t all = blocks.size();
  for (const Factor& factor : factors) all *= factor.levels.size();
  const auto same = [&](const auto& cell) { return cell.second == cells.begin()->second; };
  return cells.size() == all && std::all_of(cells.begin(), cells.end(), same);
}

/// All cells of the factors of a term; the last factor changes fastest.
std::vector<std::vector<int>> cellsOf(const EffectTerm& term, const std::vector<int>& counts) {
  std::vector<std::vector<int>> cells{{}};
  for (const int f : term) {
    std::vector<std::vector<int>> next;
    for (const auto& cell : cells)
      for (int level = 0; level < counts[static_cast<std::size_t>(f)]; ++level) {
        next.push_back(cell);
        next.back().push_back(level);
      }
    cells = std::move(next);
  }
  return cells;
}

Combination at(const EffectTerm& term, const std::vector<int>& cell, std::size_t factors) {
  Combination combination(factors, EffectModel::kAveraged);
  for (std::size_t i = 0; i < term.size(); ++i) combination[static_cast<std::size_t>(term[i])] = cell[i];
  return combination;
}

/// Two-level factors: the sum of the cells' rows with the signs of the contrast.
Eigen::VectorXd contrastRow(const EffectModel& model, const EffectTerm& term, const std::vector<int>& counts) {
  Eigen::VectorXd row;
  for (const auto& cell : cellsOf(term, counts)) {
    double sign = std::pow(0.5, static_cast<double>(term.size()) - 1);
    for (const int level : cell) sign *= level == 0 ? -1 : 1;
    const Eigen::VectorXd part = sign * model.row(at(term, cell, counts.size()));
    row = row.size() == 0 ? part : Eigen::VectorXd(row + part);
  }
  return row;
}

/// What a cell has beyond the mean and the terms within it: by inclusion and exclusion over the cell's factors.
double ownPart(const EffectModel& model, const EffectTerm& term, const std::vector<int>& cell, std::size_t factors) {
  double own = 0;
  for (unsigned subset = 0; subset < (1U << term.size()); ++subset) {
    Combination combination(factors, EffectModel::kAveraged);
    int left = static_cast<int>(term.size());
    for (std::size_t i = 0; i < term.size(); ++i)
      if ((subset >> i & 1U) != 0) {
        combination[static_cast<std::size_t>(term[i])] = cell[i];
        --left;
      }
    const auto estimate = model.estimate(model.row(combination));
    if (!estimate.estimable) return kNone;
    own += (left % 2 == 0 ? 1 : -1) * estimate.value;
  }
  return own;
}

double rangeOf(const std::vector<double>& values) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double v : values)
    if (std::isfinite(v)) {
      low = std::min(low, v);
      high = std::max(high, v);
    }
  return high >= low ? high - low : kNone;
}

Effect effectOf(const EffectTerm& term, const EffectModel& model, const std::vector<Factor>& factors,
                const std::vector<Observation>& observations, double variance) {
  const std::vector<int> counts = levelCounts(factors);
  Effect effect{term, nameOf(term, factors), {}, kNone, kNone, kNone};
  std::vector<double> compared;
  for (const auto& cell : cellsOf(term, counts)) {
    EffectMean mean{cell, kNone, kNone, 0, kNone};
    double sum = 0;
    for (const Observation& o : observations) {
      bool here = true;
      for (std::size_t i = 0; i < term.size(); ++i)
        here = here && o.combination[static_cast<std::size_t>(term[i])] == cell[i];
      if (!here) continue;
      sum += o.value;
      ++mean.count;
    }
    if (mean.count > 0) mean.rawMean = sum / mean.count;
    if (const auto e = model.estimate(model.row(at(term, cell, counts.size()))); e.estimable) {
      mean.mean = e.value;
      mean.standardError = std::sqrt(e.gain * variance);
    }
    compared.push_back(term.size() == 1 ? mean.mean : ownPart(model, term, cell, counts.size()));
    effect.means.push_back(std::move(mean));
  }
  effect.range = rangeOf(compared);
  const auto twoLevels = [&](int f) { return counts[static_cast<std::size_t>(f)] == 2; };
  if (!std::all_of(term.begin(), term.end(), twoLevels)) return effect;
  if (const auto e = model.estimate(contrastRow(model, term, counts)); e.estimable) {
    effect.contrast = e.value;
    effect.contrastError = std::sqrt(e.gain * variance);
  }
  return effect;
}

/// The terms of a model with what they explain; `least` is the model's own fit.
void judge(VarianceLine& line, double squares, int dof, const VarianceLine& error, double adjustedTotal) {
  line.squares = std::max(0.0, squares);
  line.dof = dof;
  line.meanSquare = dof > 0 ? line.squares / dof : kNone;
  line.f = error.dof > 0 && dof > 0 ? line.meanSquare / error.meanSquare : kNone;
  line.p = fisherUpperTail(line.f, dof, error.dof);
  line.share = adjustedTotal > 0 ? line.squares / adjustedTotal : 0;
  line.partialShare = line.squares + error.squares > 0 ? line.squares / (line.squares + error.squares) : 0;
}

void addRemarks(VarianceAnalysis& analysis, int asked) {
  if (analysis.order < asked)
    analysis.remarks.emplace_back(
        "no replicates are left to tell interactions from chance: they are pooled into the error, main effects alone "
        "are judged");
  if (analysis.error.dof == 0)
    analysis.remarks.emplace_back("nothing is left to tell effects from chance: no F, no p; take more placements");
  if (!analysis.balanced)
    analysis.remarks.emplace_back(
        "unbalanced: cells hold unequal numbers of observations; sums of squares are of type II (each term adjusted "
        "for "
        "all that do not contain it), means are least-squares means");
  for (const VarianceLine& line : analysis.terms)
    if (line.dof == 0)
      analysis.remarks.push_back(line.name + " cannot be told apart from the other terms in the runs that are left");
}

}  // namespace

Expected<VarianceAnalysis> analyseVariance(const std::vector<Factor>& factors,
                                           const std::vector<Observation>& observations, int order) {
  if (observations.size() < 2) return inputError("analysis", "needs at least two observations");
  for (const Observation& o : observations)
    if (!std::isfinite(o.value)) return inputError("analysis", "an observation is no finite number");
  VarianceAnalysis analysis;
  const int asked = std::clamp(order, 1, static_cast<int>(factors.size()));
  analysis.order = asked;
  const auto n = static_cast<int>(observations.size());
  EffectModel model = modelOf(factors, observations, analysis.order);
  EffectModel::Fit whole = model.fit(std::vector<bool>(model.terms().size(), true));
  while (whole.rank == n && analysis.order > 1) {
    model = modelOf(factors, observations, --analysis.order);
    whole = model.fit(std::vector<bool>(model.terms().size(), true));
  }
  const std::vector<bool> all(model.terms().size(), true);
  analysis.balanced = isBalanced(factors, observations);
  for (const Observation& o : observations) analysis.mean += o.value / n;

  analysis.total = {{}, "total", model.totalSquares(), n - 1, kNone, kNone, kNone, kNone, kNone};
  analysis.error = {{}, "error", whole.residualSquares, n - whole.rank, kNone, kNone, kNone, kNone, kNone};
  if (analysis.error.dof > 0) analysis.error.meanSquare = analysis.error.squares / analysis.error.dof;
  const EffectModel::Fit withoutBlocks = model.fit(all, false);
  const EffectModel::Fit blocksAlone = model.fit(std::vector<bool>(all.size(), false));
  analysis.blocks.name = "blocks";
  judge(analysis.blocks, withoutBlocks.residualSquares - whole.residualSquares, whole.rank - withoutBlocks.rank,
        analysis.error, analysis.total.squares);
  const double adjusted = blocksAlone.residualSquares;  // what is left to explain once blocks are known

  for (const EffectTerm& term : model.terms()) {
    std::vector<bool> keep;
    for (const EffectTerm& other : model.terms()) keep.push_back(!contains(other, term));
    const EffectModel::Fit before = model.fit(keep);
    keep[static_cast<std::size_t>(&term - model.terms().data())] = true;
    const EffectModel::Fit after = model.fit(keep);
    VarianceLine line;
    line.factors = term;
    line.name = nameOf(term, factors);
    judge(line, before.residualSquares - after.residualSquares, after.rank - before.rank, analysis.error, adjusted);
    analysis.terms.push_back(std::move(line));
    analysis.effects.push_back(effectOf(term, model, factors, observations, analysis.error.meanSquare));
  }
  analysis.ranking.resize(analysis.terms.size());
  std::iota(analysis.ranking.begin(), analysis.ranking.end(), 0);
  std::stable_sort(analysis.ranking.begin(), analysis.ranking.end(), [&](int a, int b) {
    return analysis.terms[static_cast<std::size_t>(a)].share > analysis.terms[static_cast<std::size_t>(b)].share;
  });
  addRemarks(analysis, asked);
  return analysis;
}

std::vector<Prediction> predict(const std::vector<Factor>& factors, const std::vector<Observation>& observations,
                                const std::vector<Combination>& wanted, int order) {
  const EffectModel model = modelOf(factors, observations, order);
  const auto whole = model.fit(std::vector<bool>(model.terms().size(), true));
  const int dof = model.observations() - whole.rank;
  const double variance = dof > 0 ? whole.residualSquares / dof : kNone;
  std::vector<Prediction> predictions;
  for (const Combination& combination : wanted) {
    const auto e = model.estimate(model.row(combination));
    predictions.push_back(e.estimable ? Prediction{e.value, std::sqrt(e.gain * variance)} : Prediction{kNone, kNone});
  }
  return predictions;
}

}  // namespace vignole
