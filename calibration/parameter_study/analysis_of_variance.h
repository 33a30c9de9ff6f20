#pragma once
// What a factorial experiment says: main effects, two-factor interactions, and which of them are more than chance.

#include <string>
#include <vector>

#include "calibration/parameter_study/factorial_design.h"

namespace vignole {

struct Observation {
  Combination combination;
  int block = 0;  ///< what was observed: a camera in a placement
  double value = 0;
};

/// One line of the table of variances.
struct VarianceLine {
  std::vector<int> factors;  ///< empty for blocks, error and total
  std::string name;          ///< "sigma_px", "exposure_ms x sigma_px", "blocks", "error", "total"
  double squares = 0;        ///< sum of squares
  int dof = 0;
  double meanSquare = 0;
  double f = 0, p = 1;      ///< against the error; NaN without degrees of freedom
  double share = 0;         ///< eta^2: of the total sum of squares less that of the blocks
  double partialShare = 0;  ///< partial eta^2: squares / (squares + error)
};

/// Mean at a level or cell, the other factors and the blocks averaged with equal weights (least-squares mean).
struct EffectMean {
  std::vector<int> levels;  ///< index of the level of each factor of the effect
  double mean = 0;          ///< NaN where the runs that are left do not determine it
  double standardError = 0;
  int count = 0;       ///< observations
  double rawMean = 0;  ///< of the observations as they are
};

struct Effect {
  std::vector<int> factors;
  std::string name;
  std::vector<EffectMean> means;  ///< the last factor changes fastest
  /// Of a main effect with two levels: last less first; of an interaction of two such factors: half the difference of
  /// the one's effects at the other's levels (Montgomery); otherwise NaN.
  double contrast = 0;
  double contrastError = 0;
  /// Largest less smallest mean; of an interaction: of what the cells differ from the sum of the main effects.
  double range = 0;
};

struct VarianceAnalysis {
  std::vector<VarianceLine> terms;  ///< main effects, then interactions
  VarianceLine blocks, error, total;
  std::vector<Effect> effects;  ///< in the order of terms
  std::vector<int> ranking;     ///< indices into terms, largest share first
  bool balanced = true;         ///< every cell of the design holds as many observations, blocks likewise
  int order = 2;                ///< of the interactions in the model; what is above is part of the error
  double mean = 0;
  std::vector<std::string> remarks;
};

/// Least squares with blocks as additive nuisance. Sums of squares of type II (each term adjusted for all that do not
/// contain it; Yates 1934); in a balanced experiment the same as the ordinary ones. Where no degree of freedom is left
/// for the error, the interactions are pooled into it, and a remark says so. Refuses fewer than 2 observations and
/// values that are not finite.
[[nodiscard]] Expected<VarianceAnalysis> analyseVariance(const std::vector<Factor>& factors,
                                                         const std::vector<Observation>& observations, int order = 2);

/// Value of the model (main effects and interactions) at a setting.
struct Prediction {
  double value = 0;  ///< NaN where the observations do not determine it
  double standardError = 0;
};
/// Of every combination in `wanted`, from the observations.
[[nodiscard]] std::vector<Prediction> predict(const std::vector<Factor>& factors,
                                              const std::vector<Observation>& observations,
                                              const std::vector<Combination>& wanted, int order);

}  // namespace vignole
