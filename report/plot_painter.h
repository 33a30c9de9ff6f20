#pragma once
// A plot with axes, in the look of the pages.

#include <QPainter>
#include <QRectF>
#include <functional>

#include "report/document.h"
#include "report/palette.h"

namespace vignole {

/// Colours 0-3 as the cameras', 4 neutral, 5 accent, 6 out of tolerance.
[[nodiscard]] QColor curveColour(int colour, const Palette& palette);
/// Dots or a line, mapped by `map` (Point2 -> QPointF).
void paintCurve(QPainter& painter, const Curve& curve, const QColor& colour,
                const std::function<QPointF(const Point2&)>& map);
/// Values that are not finite are left out; a plot without any value says so.
void paintPlot(QPainter& painter, const QRectF& area, const Plot& plot, const Palette& palette);

}  // namespace vignole
