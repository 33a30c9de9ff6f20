#pragma once
// The readings of a gauge study as a balanced table.

#include <string>
#include <vector>

#include "engine/geometry/expected.h"
#include "engine/quality/gauge_rr.h"

namespace vignole {

/// values[operator][part][trial], relative to `shift`: sums of squares keep the digits that a common offset would take.
struct GaugeCells {
  std::vector<std::string> operators;
  std::vector<std::vector<std::string>> parts;  ///< per operator; the same for all where crossed
  std::size_t trials = 0;
  double shift = 0;
  std::vector<std::vector<std::vector<double>>> values;

  [[nodiscard]] std::size_t partsPerOperator() const { return parts.front().size(); }
};

/// In the order in which names first appear. Crossed: every operator measured every part. Nested: a part belongs to its
/// operator, whatever others call theirs, and all operators have the same number of parts.
[[nodiscard]] Expected<GaugeCells> gaugeCells(const std::vector<GaugeReading>& readings, bool nested);

}  // namespace vignole
