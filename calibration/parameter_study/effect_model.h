#pragma once
// The linear model behind a factorial experiment: mean + blocks + main effects + interactions, fitted by least squares,
// whatever cells are empty or missing.

#include <Eigen/Core>
#include <span>
#include <vector>

namespace vignole {

/// The factors that a term crosses, ascending; one factor: its main effect, two: their interaction.
using EffectTerm = std::vector<int>;

/// All terms of up to `order` factors: main effects first.
[[nodiscard]] std::vector<EffectTerm> effectTerms(int factors, int order);

/// Effects are coded to sum to zero over the levels of each factor (and over the blocks), so that a factor that is left
/// out of a row is averaged over its levels with equal weights.
class EffectModel {
 public:
  static constexpr int kAveraged = -1;

  /// `levels`: number of levels of each factor. `blocks`: what every run meets alike but is not asked about (cameras,
  /// placements); 1: none.
  EffectModel(std::vector<int> levels, int blocks, std::vector<EffectTerm> terms);

  void add(std::span<const int> combination, int block, double value);
  [[nodiscard]] int observations() const { return observations_; }
  [[nodiscard]] const std::vector<EffectTerm>& terms() const { return terms_; }
  /// About the mean.
  [[nodiscard]] double totalSquares() const;

  struct Fit {
    int rank = 0;  ///< parameters that the observations can tell apart, the mean included
    double residualSquares = 0;
  };
  /// The model with the terms for which `keep` holds, with or without blocks.
  [[nodiscard]] Fit fit(const std::vector<bool>& keep, bool blocks = true) const;

  /// Regressors of a setting; kAveraged: over the factor's levels. Always averaged over the blocks.
  [[nodiscard]] Eigen::VectorXd row(std::span<const int> combination) const;

  struct Estimate {
    double value = 0;
    double gain = 0;         ///< its variance over that of one observation
    bool estimable = false;  ///< false: the observations do not determine it
  };
  /// A linear combination of the parameters of the whole model. Solves it at the first call after add().
  [[nodiscard]] Estimate estimate(const Eigen::VectorXd& row) const;

 private:
  [[nodiscard]] Eigen::VectorXd regressors(std::span<const int> combination, int block) const;

  std::vector<int> levels_;
  int blocks_ = 1;
  std::vector<EffectTerm> terms_;
  std::vector<int> firstColumn_;  ///< of each term, and one past the last
  Eigen::MatrixXd gram_;          ///< X'X
  Eigen::VectorXd moment_;        ///< X'(y - centre)
  double centre_ = 0, sum_ = 0, squares_ = 0;
  int observations_ = 0;
  mutable bool solved_ = false;
  mutable Eigen::MatrixXd inverse_;
  mutable Eigen::VectorXd coefficients_;
};

}  // namespace vignole
