#pragma once
// The shapes that tell a state without colour (QPainter paths, not glyphs).

#include <QPainter>
#include <QRectF>

#include "engine/measurement/measurement.h"
#include "report/palette.h"

namespace vignole {

enum class StateSymbol { Good, NoLimit, Near, Out, NotMeasured, Held, Idle, Armed, Measuring, Fault };

[[nodiscard]] StateSymbol symbolOf(Verdict verdict);
void paintSymbol(QPainter& painter, const QRectF& box, StateSymbol symbol, const Palette& palette);

}  // namespace vignole
