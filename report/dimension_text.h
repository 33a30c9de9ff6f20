#pragma once
// How dimensions, numbers and states are written: fixed decimals, a real minus sign, lowered indices.

#include <QPainter>
#include <QString>

#include "engine/measurement/measurement.h"
#include "engine/rail/dimension.h"
#include "report/length_unit.h"

namespace vignole {

/// Between a number's whole and its fraction, in every text of this room: a point unless a language says otherwise.
/// Thread: any.
void setDecimalMark(QChar mark);
[[nodiscard]] QChar decimalMark();

/// Decimals of a value in mm: 3, but 1 for HR.
[[nodiscard]] int decimalsOf(Dimension dimension);
/// Fixed decimals with U+2212; what rounds to zero has no sign.
[[nodiscard]] QString numberText(double value, int decimals);
/// The same with + for positive values.
[[nodiscard]] QString deviationText(double value, int decimals);
/// A limit as deviation: two decimals, three where the third is not zero.
[[nodiscard]] QString limitText(double deviationMm);
/// "Rail height" ...
[[nodiscard]] QString titleOf(Dimension dimension);
/// "Good", "Near limit", "Out", "Not measured", "No limit".
[[nodiscard]] QString wordOf(Verdict verdict);
/// "0.032 above the limit", "0.010 below the limit", "Near limit" ...; for HF and FC after their own rules.
[[nodiscard]] QString verdictSentence(Dimension dimension, const DimensionResult& result,
                                      LengthUnit unit = LengthUnit::Millimetre);
/// A length in its unit, without the unit's name; `decimals` are those in mm.
[[nodiscard]] QString lengthText(double mm, int decimals, LengthUnit unit);

/// "FT_l" as FT with a small lowered l, in the painter's font and pen, from the left end of the base line.
/// Returns the advance.
double drawDimensionName(QPainter& painter, const QPointF& baseLine, Dimension dimension);
[[nodiscard]] double dimensionNameWidth(const QFont& font, Dimension dimension);

}  // namespace vignole
