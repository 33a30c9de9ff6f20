#include "report/hatch.h"

#include <QLineF>
#include <QList>
#include <QPen>
#include <cmath>

namespace vignole {

void paintHatch(QPainter& painter, const QRectF& area, const QColor& colour, double pitch, double width) {
  if (area.isEmpty() || pitch <= 0) return;
  painter.save();
  painter.setClipRect(area, Qt::IntersectClip);
  painter.setPen(QPen(colour, width));
  // Lines x + y = k: counted from the origin, so that neighbouring areas join without a seam.
  const double step = pitch * std::sqrt(2.0);
  QList<QLineF> lines;
  for (double k = std::ceil((area.left() + area.top()) / step) * step; k < area.right() + area.bottom(); k += step)
    lines << QLineF(k - area.top(), area.top(), k - area.bottom(), area.bottom());
  painter.drawLines(lines);
  painter.restore();
}

}  // namespace vignole
