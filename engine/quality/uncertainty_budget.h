#pragma once
// A measurement uncertainty budget after the GUM (JCGM 100), checked by Monte Carlo (JCGM 101).

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/geometry/expected.h"
#include "engine/quality/sample.h"

namespace vignole {

/// What is drawn for an input. Auto: Student's t where its degrees of freedom are finite, else normal (JCGM 101, 6.4).
enum class InputDistribution { Auto, Normal, Rectangular, Triangular, ArcSine };
[[nodiscard]] std::optional<InputDistribution> inputDistributionNamed(std::string_view name);

struct BudgetInput {
  std::string symbol, description, unit;
  double estimate = 0;
  double u = 0;  ///< standard uncertainty
  double degrees = std::numeric_limits<double>::infinity();
  double sensitivity = 1;  ///< taken from the model where there is one
  InputDistribution distribution = InputDistribution::Auto;
};

struct UncertaintyBudget {
  std::string measurand, unit;
  std::vector<BudgetInput> inputs;  ///< uncorrelated
  /// Value of the measurand from the inputs; without it, the sum of sensitivity x estimate.
  std::function<double(std::span<const double>)> model;
};

struct UncertaintySettings {
  double k = 2;                  ///< U = k u
  std::size_t trials = 1000000;  ///< of the Monte Carlo; 0: none
  std::uint64_t seed = 1;
  int significantDigits = 2;  ///< of u, to which first order and Monte Carlo must agree (JCGM 101, 7.9.2)
};

struct BudgetLine {
  double sensitivity = 0;
  double contribution = 0;  ///< |sensitivity| u
  double percent = 0;       ///< of the variance
};

struct MonteCarlo {
  std::size_t trials = 0;
  double mean = 0;
  std::optional<double> u;  ///< empty where an input with at most two degrees of freedom has no variance
  ValueRange interval95;    ///< probabilistically symmetric
  double tolerance = 0;     ///< half a unit of the last significant digit of u
  bool agrees = false;      ///< both ends of the first-order 95 % interval lie within the tolerance
};

struct UncertaintyResult {
  double value = 0;
  double uc = 0;
  std::vector<BudgetLine> lines;
  double degrees = 0;                         ///< Welch-Satterthwaite; infinite where no input has finite ones
  std::optional<long> truncatedDegrees;       ///< before the t look-up; empty: infinite
  double k95 = 0, k99 = 0, u95 = 0, u99 = 0;  ///< t quantiles, expanded uncertainties
  double expanded = 0;                        ///< k uc
  bool refused = false;                       ///< first order gives 0: it says nothing, see the Monte Carlo
  std::optional<MonteCarlo> monteCarlo;
  StudyNotes notes;
};

/// Errors: no inputs, a negative u, a model that is not finite at the estimates.
[[nodiscard]] Expected<UncertaintyResult> uncertaintyStudy(const UncertaintyBudget& budget,
                                                           const UncertaintySettings& settings = {});

}  // namespace vignole
