#pragma once
// Studies of a gauge on one part or on a few references: type 1 (Cg, Cgk) and linearity (AIAG MSA, VDA 5).

#include <optional>
#include <span>
#include <vector>

#include "engine/geometry/expected.h"
#include "engine/quality/regression.h"
#include "engine/quality/sample.h"

namespace vignole {

struct Type1Settings {
  double reference = 0;
  std::optional<double> tolerance;  ///< T = upper - lower limit; without it no Cg
  double kPercent = 20;             ///< share K of the tolerance that the gauge may use
  double sigmas = 6;                ///< width of the gauge's spread in s: 6, or 4
  double alpha = 0.05;              ///< of the interval of the bias
};

struct Type1Result {
  Sample sample;
  double bias = 0;
  ValueRange biasInterval;
  double t = 0, p = 0;  ///< bias against 0
  /// Cg = K/100 T / (sigmas s); Cgk = (K/200 T - |bias|) / (sigmas/2 s). Empty without a tolerance or where s is 0.
  std::optional<double> cg, cgk;
  std::optional<double> percentRepeatability, percentRepeatabilityAndBias;  ///< K / Cg, K / Cgk
  StudyNotes notes;
};
/// At least two values.
[[nodiscard]] Expected<Type1Result> type1Study(std::span<const double> values, const Type1Settings& settings);

struct LinearitySettings {
  double alpha = 0.05;
  std::optional<double> processVariation;  ///< 6 sigma of the process, or the tolerance: %linearity and %bias
};

struct LinearityLevel {
  double reference = 0;
  Sample bias;
  double t = 0, p = 0;  ///< against 0, from this level alone
  ValueRange band;      ///< of the line here
};

struct LinearityResult {
  Regression line;  ///< of bias = value - reference over reference
  std::vector<LinearityLevel> levels;
  Sample bias;                                   ///< over all values
  double repeatability = 0;                      ///< pooled s within the levels
  double percentLinearity = 0;                   ///< 100 |slope|
  std::optional<double> linearity, percentBias;  ///< |slope| x process variation; 100 |mean bias| / it
  bool zeroInBand = false;  ///< the line of no bias lies within the band at every reference: acceptable
  StudyNotes notes;
};
[[nodiscard]] Expected<LinearityResult> linearityStudy(std::span<const double> reference, std::span<const double> value,
                                                       const LinearitySettings& settings = {});

}  // namespace vignole
