#pragma once
// Agreement of two instruments or of an instrument with itself: Bland and Altman for values, Cohen's kappa for
// verdicts.

#include <span>
#include <string>
#include <vector>

#include "engine/geometry/expected.h"
#include "engine/quality/regression.h"
#include "engine/quality/sample.h"

namespace vignole {

/// How the confidence intervals of the limits of agreement are computed. Bland and Altman 1999: var = s^2 (1/n +
/// k^2 / 2(n - 1)); 1986: s^2 (1/n + k^2 / 2n), with k = 2 their 3 s^2/n; exact: non-central t (Carkeet 2015).
enum class LimitsMethod { BlandAltman1999, BlandAltman1986, Exact };

struct BlandAltmanSettings {
  double sigmas = 1.96;  ///< limits at bias +- sigmas s
  double alpha = 0.05;   ///< of the confidence intervals
  LimitsMethod method = LimitsMethod::BlandAltman1999;
};

struct BlandAltman {
  std::size_t n = 0;
  double bias = 0;  ///< mean of the differences
  double sd = 0;
  ValueRange limits;
  ValueRange biasInterval, lowerInterval, upperInterval;
  double t = 0, p = 0;  ///< bias against 0
  StudyNotes notes;
};

/// At least three differences.
[[nodiscard]] Expected<BlandAltman> blandAltman(std::span<const double> differences,
                                                const BlandAltmanSettings& settings = {});

struct Agreement {
  BlandAltman differences;                  ///< a - b
  std::vector<double> means, difference;    ///< per pair: what is drawn
  Regression proportional;                  ///< of the differences over the means: a slope says that they drift apart
  double correlation = 0, concordance = 0;  ///< Pearson; Lin
};
[[nodiscard]] Expected<Agreement> agreementStudy(std::span<const double> a, std::span<const double> b,
                                                 const BlandAltmanSettings& settings = {});

enum class KappaWeights { None, Linear, Quadratic };

struct Kappa {
  std::vector<std::string> categories;
  std::vector<std::vector<std::size_t>> counts;  ///< [a][b]
  std::size_t n = 0;
  double observed = 0, expected = 0;  ///< share that agrees, and by chance
  double kappa = 0;
  double se = 0, se0 = 0;  ///< of kappa (Fleiss, Cohen, Everitt 1969), and where the true one is 0
  ValueRange interval;
  double z = 0, p = 0;  ///< against 0
  StudyNotes notes;
};
/// Categories in ascending order, numbers by value and before words; the order matters to weighted kappa.
[[nodiscard]] Expected<Kappa> kappaStudy(const std::vector<std::string>& a, const std::vector<std::string>& b,
                                         KappaWeights weights = KappaWeights::None, double alpha = 0.05);

}  // namespace vignole
