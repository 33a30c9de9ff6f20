#include "calibration/parameter_study/factorial_design.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>

#include "calibration/parameter_study/effect_model.h"

namespace vignole {
namespace {

constexpr std::size_t kMostCandidates = 20000;  // combinations that are weighed for a fraction
constexpr double kRidge = 1e-6;                 // starts the greedy choice while too few runs are chosen

std::string counted(std::size_t n) { return std::to_string(n); }

Expected<void> check(const std::vector<Factor>& factors) {
  if (factors.empty()) return inputError("design", "has no factor; give at least one with two levels");
  std::set<std::string> names;
  for (const Factor& factor : factors) {
    if (!names.insert(factor.name).second) return inputError("factor " + factor.name, "appears twice");
    if (factor.levels.size() < 2)
      return inputError("factor " + factor.name,
                        "has " + counted(factor.levels.size()) + " level; give two or more, or leave it out");
    const std::set<FactorLevel> distinct(factor.levels.begin(), factor.levels.end());
    if (distinct.size() != factor.levels.size()) return inputError("factor " + factor.name, "has a level twice");
  }
  return {};
}

/// Number of combinations, held at `most`.
std::size_t sizeOf(const std::vector<Factor>& factors, std::size_t most) {
  std::size_t size = 1;
  for (const Factor& factor : factors) size = std::min(most, size * factor.levels.size());
  return size;
}

/// Chooses rows of a matrix of candidates so that |X'X| becomes large. Holds the inverse of X'X and the variance of
/// prediction of every candidate, both updated by rank one.
class FractionChooser {
 public:
  explicit FractionChooser(const Eigen::MatrixXd& candidates)
      : candidates_(candidates),
        inverse_(Eigen::MatrixXd::Identity(candidates.cols(), candidates.cols()) / kRidge),
        variance_(candidates.rowwise().squaredNorm() / kRidge),
        chosen_(static_cast<std::size_t>(candidates.rows()), false) {}

  void choose(int runs) {
    for (int i = 0; i < runs; ++i) change(extreme(false), 1);
    for (int round = 0; round < 4 * runs; ++round) {  // exchanges: the least useful out, the most useful in
      const Eigen::Index out = extreme(true);
      const double leaving = variance_[out];
      change(out, -1);
      const Eigen::Index in = extreme(false);
      change(in, 1);
      if (in == out || leaving >= 1 - 1e-12) break;
    }
  }
  [[nodiscard]] std::vector<std::size_t> chosen() const {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < chosen_.size(); ++i)
      if (chosen_[i]) indices.push_back(i);
    return indices;
  }

 private:
  /// The chosen candidate with the least variance, or the one that is not chosen with the largest.
  [[nodiscard]] Eigen::Index extreme(bool amongChosen) const {
    Eigen::Index best = -1;
    for (Eigen::Index i = 0; i < variance_.size(); ++i) {
      if (chosen_[static_cast<std::size_t>(i)] != amongChosen) continue;
      const bool better = best < 0 || (amongChosen ? variance_[i] < variance_[best] * (1 - 1e-9)
                                                   : variance_[i] > variance_[best] * (1 + 1e-9));
      if (better) best = i;
    }
    return best;
  }
  void change(Eigen::Index i, double sign) {
    const Eigen::VectorXd through = inverse_ * candidates_.row(i).transpose();
    const double scale = sign / (1 + sign * variance_[i]);
    const Eigen::VectorXd along = candidates_ * through;
    inverse_ -= scale * through * through.transpose();
    variance_ -= scale * along.cwiseAbs2();
    chosen_[static_cast<std::size_t>(i)] = sign > 0;
  }

  const Eigen::MatrixXd& candidates_;
  Eigen::MatrixXd inverse_;
  Eigen::VectorXd variance_;
  std::vector<bool> chosen_;
};

double logInformation(const Eigen::MatrixXd& rows) {
  const Eigen::MatrixXd gram = rows.transpose() * rows / static_cast<double>(rows.rows());
  return Eigen::LDLT<Eigen::MatrixXd>(gram).vectorD().array().max(1e-300).log().sum();
}

/// A fraction that tells all main effects and two-factor interactions apart.
Expected<void> takeFraction(FactorialDesign& design, int runs) {
  if (design.fullRuns > kMostCandidates)
    return inputError("design", "the full design has more than " + counted(kMostCandidates) +
                                    " runs; take fewer factors or levels before a fraction is chosen");
  std::vector<int> levels;
  for (const Factor& factor : design.factors) levels.push_back(static_cast<int>(factor.levels.size()));
  const EffectModel model(levels, 1, effectTerms(static_cast<int>(levels.size()), 2));
  const std::vector<Combination> all = allCombinations(design.factors);
  const auto parameters = static_cast<int>(model.row(all.front()).size());
  if (runs < parameters)
    return inputError("design.runs", counted(static_cast<std::size_t>(runs)) + " runs cannot tell the " +
                                         counted(static_cast<std::size_t>(parameters)) +
                                         " main effects and two-factor interactions apart; give at least as many, or " +
                                         "fewer levels");
  Eigen::MatrixXd candidates(static_cast<Eigen::Index>(all.size()), parameters);
  for (std::size_t i = 0; i < all.size(); ++i) candidates.row(static_cast<Eigen::Index>(i)) = model.row(all[i]);
  FractionChooser chooser(candidates);
  chooser.choose(runs);
  const std::vector<std::size_t> chosen = chooser.chosen();
  for (const std::size_t i : chosen) design.runs.push_back(all[i]);
  const Eigen::MatrixXd rows = candidates(chosen, Eigen::all);
  design.efficiency = std::exp((logInformation(rows) - logInformation(candidates)) / parameters);
  return {};
}

}  // namespace

std::string words(const FactorLevel& level) {
  if (const auto* text = std::get_if<std::string>(&level)) return *text;
  std::array<char, 32> buffer{};
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), std::get<double>(level)).ptr};
}

std::string words(const std::vector<Factor>& factors, const Combination& combination) {
  std::string text;
  for (std::size_t f = 0; f < factors.size(); ++f)
    text += (f == 0 ? "" : ", ") + factors[f].name + " " +
            words(factors[f].levels[static_cast<std::size_t>(combination[f])]);
  return text;
}

std::vector<Combination> allCombinations(const std::vector<Factor>& factors) {
  std::vector<Combination> all{{}};
  for (const Factor& factor : factors) {
    std::vector<Combination> next;
    for (const Combination& combination : all)
      for (int level = 0; level < static_cast<int>(factor.levels.size()); ++level) {
        next.push_back(combination);
        next.back().push_back(level);
      }
    all = std::move(next);
  }
  return all;
}

Expected<FactorialDesign> factorialDesign(std::vector<Factor> factors, const DesignSettings& settings) {
  if (auto checked = check(factors); !checked) return tl::unexpected(checked.error());
  FactorialDesign design;
  design.fullRuns = sizeOf(factors, kMostCandidates + 1);
  design.factors = std::move(factors);
  const auto most = static_cast<std::size_t>(std::max(1, settings.maxRuns));
  const std::size_t wanted = settings.runs ? static_cast<std::size_t>(*settings.runs) : design.fullRuns;
  if (std::min(wanted, design.fullRuns) > most) {
    const std::string runs = design.fullRuns > kMostCandidates && !settings.runs
                                 ? "more than " + counted(kMostCandidates)
                                 : counted(std::min(wanted, design.fullRuns));
    return inputError("design", "has " + runs + " runs, more than the limit of " + counted(most) +
                                    "; take fewer factors or levels, a fraction ([design] runs = N), or raise the "
                                    "limit ([design] max_runs)");
  }
  if (wanted >= design.fullRuns) {
    design.runs = allCombinations(design.factors);
    return design;
  }
  if (auto taken = takeFraction(design, *settings.runs); !taken) return tl::unexpected(taken.error());
  return design;
}

}  // namespace vignole
