#pragma once
// How lines are drawn on pictures, in both themes: the ground stays black.

#include <QColor>
#include <QPainter>
#include <QPolygonF>
#include <vector>

namespace vignole {

inline constexpr QColor kLineColour(0x62, 0xAE, 0xF0), kMarkColour(0xFF, 0xB5, 0x2E);

/// In a painter whose unit is a pixel of the picture, drawn `scale` times as large on the screen.
inline void strokeLines(QPainter& painter, const std::vector<QPolygonF>& strokes, const QColor& colour, double scale) {
  painter.setPen(QPen(colour, 1.4 / scale));
  for (const QPolygonF& stroke : strokes) painter.drawPolyline(stroke);
}

}  // namespace vignole
