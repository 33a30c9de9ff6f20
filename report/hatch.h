#pragma once
// Hatching at 45 degrees by lines, not by a brush pattern: the same on a screen, in a picture and on paper.

#include <QColor>
#include <QPainter>
#include <QRectF>

namespace vignole {

void paintHatch(QPainter& painter, const QRectF& area, const QColor& colour, double pitch = 8, double width = 2);

}  // namespace vignole
