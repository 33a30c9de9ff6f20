#pragma once
// How dimensions, numbers and states are written: fixed decimals, a real minus sign, lowered indices.

#include <QPainter>
#include <QString>

#include "engine/measurement/measurement.h"
#include "engine/rail/dimension.h"

namespace vignole {

/// Decimals of a value in mm: 3, but 1 for HR.
[[nodiscard]] int decimalsOf(Dimension dimension);
/// Fixed decimals with U+2212; what rounds to zero has no sign.
[[nodiscard]] QString numberText(double value, int decimals);
/// The same with + for positive values.
[[nodiscard]] QString deviationText(double value, int decimals);
/// A limit as deviation: two decimals, three where the third is not zero.
[[nodiscard]] QString limitText(double deviationMm);
/// "Good", "Near limit", "Out", "Not measured", "No limit".
[[nodiscard]] QString wordOf(Verdict verdict);
/// "0.032 above the limit", "0.010 below the limit", "Near limit" ...; for HF and FC after their own rules.
[[nodiscard]] QString verdictSentence(Dimension dimension, const DimensionResult& result);

/// "FT_l" as FT with a small lowered l, in the painter's font and pen, from the left end of the base line.
/// Returns the advance.
double drawDimensionName(QPainter& painter, const QPointF& baseLine, Dimension dimension);
[[nodiscard]] double dimensionNameWidth(const QFont& font, Dimension dimension);

}  // namespace vignole
