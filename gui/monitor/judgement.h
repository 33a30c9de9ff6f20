#pragma once
// What Monitor says in words: the verdict of the rail so far, whether the gauge can be trusted, which dimensions are
// nearest to their limits. Pure functions of a snapshot: no widget in here. In texts "RAS_l" stands for the name with a
// subscript (see inscription.h).

#include <QString>
#include <optional>
#include <vector>

#include "gui/bridge/line.h"
#include "report/length_unit.h"
#include "report/state_symbol.h"

namespace vignole {

struct StateWord {
  StateSymbol symbol = StateSymbol::Idle;
  QString word;
};

[[nodiscard]] StateWord lineState(LineState state);

struct VerdictText {
  StateSymbol symbol = StateSymbol::Armed;
  QString word;      ///< 64 px
  QString sentence;  ///< why, or how far
  bool held = false;
};
[[nodiscard]] VerdictText railVerdict(const LineSnapshot& line, LengthUnit unit = LengthUnit::Millimetre);

struct GaugeTrust {
  StateSymbol symbol = StateSymbol::NoLimit;
  QString word;        ///< "Trusted"
  QString cameras;     ///< "4 of 4 cameras, 66.0 profiles/s"
  QString provenance;  ///< where frames and calibration come from
};
[[nodiscard]] GaugeTrust gaugeTrust(const LineSnapshot& line);
/// The longest of its words, to keep room for.
[[nodiscard]] QString widestTrustWord();

/// The grey sentence of the alarm line when there is no alarm.
[[nodiscard]] QString quietSentence(const LineSnapshot& line);

/// Share of the way from nominal to the nearer limit, 1 at the limit, above 1 outside; empty without limits or value.
[[nodiscard]] std::optional<double> limitShare(Dimension dimension, const DimensionResult& result);
/// At most `count` dimensions with limits, nearest to their limits first. `shown` keeps its places unless another is
/// nearer by a tenth of the tolerance: charts that swap all the time cannot be read.
[[nodiscard]] std::vector<Dimension> nearestToLimits(const LineSnapshot& line, std::size_t count,
                                                     const std::vector<Dimension>& shown);
/// The dimension that the drawing points at when nobody has chosen one: the furthest outside its limits, if any.
[[nodiscard]] std::optional<Dimension> worstOutside(const LineSnapshot& line);

}  // namespace vignole
