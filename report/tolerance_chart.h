#pragma once
// A dimension along the rail with its expected value and both limits (the paper's Fig. 9a).

#include <QPainter>
#include <QRectF>

#include "engine/inspection/rail_summary.h"
#include "report/palette.h"

namespace vignole {

/// Title row with symbol, name and figures, then the chart. The painter's font is body text (16 px in the mock-ups) and
/// sets the size of all others. Stretches without values are hatched, exceptions thick with the square.
void paintToleranceChart(QPainter& painter, const QRectF& area, const DimensionSummary& summary, double lengthM,
                         const Palette& palette);

/// Step of an axis of this length with at most `most` steps: 1, 2 or 5 times a power of ten.
[[nodiscard]] double axisStep(double length, int most);

}  // namespace vignole
