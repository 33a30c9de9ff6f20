#pragma once
// Accuracy against a reference per position (CMM, MiniProf) as in the paper's Table V, one dimension at a time.

#include <optional>
#include <string>
#include <vector>

#include "engine/geometry/expected.h"
#include "engine/quality/agreement.h"

namespace vignole {

struct AccuracyPoint {
  double positionM = 0;
  std::string run;
  double value = 0, reference = 0;
  double u = 0, uReference = 0;  ///< standard uncertainties; 0: not known
};

/// Over one position, or over all of them.
struct AccuracyFigures {
  std::size_t n = 0;
  double bias = 0, rms = 0, max = 0;  ///< of value - reference; max is the largest amount, with its sign
  double sd = 0;
  std::optional<double> biasPercent, rmsPercent, maxPercent;  ///< of the reference; empty where it is 0
};

struct AccuracyResult {
  AccuracyFigures whole;
  std::size_t positions = 0, runs = 0;
  std::optional<ValueRange> biasInterval;  ///< from the means of the positions: runs at one position share its error
  std::vector<double> positionM;
  std::vector<AccuracyFigures> perPosition;
  std::optional<BlandAltman> agreement;  ///< from three values on
  std::vector<double> en;  ///< per point with both uncertainties: (value - reference) / sqrt(U^2 + U_ref^2)
  double enMax = 0;        ///< largest amount
  std::size_t enBeyond1 = 0;
  StudyNotes notes;
};

/// At least one point. Positions in ascending order.
[[nodiscard]] Expected<AccuracyResult> accuracyStudy(const std::vector<AccuracyPoint>& points,
                                                     const BlandAltmanSettings& settings = {});

}  // namespace vignole
