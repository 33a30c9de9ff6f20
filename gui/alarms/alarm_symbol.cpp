#include "gui/alarms/alarm_symbol.h"

#include "gui/theme/theme.h"

namespace vignole {

void paintPriority(QPainter& painter, const QRectF& box, AlarmPriority priority, const Palette& p) {
  const QPointF c = box.center();
  const double r = box.width() / 2;
  QPolygonF shape;
  QColor fill, ink;
  double lower = 0;
  if (priority == AlarmPriority::Invalid) {
    shape << c - QPointF(0, r) << c + QPointF(r, 0) << c + QPointF(0, r) << c - QPointF(r, 0);
    fill = p.invalid, ink = p.panel2;
  } else if (priority == AlarmPriority::OutOfTolerance) {
    shape << box.topLeft() << box.topRight() << box.bottomRight() << box.bottomLeft();
    fill = p.out, ink = p.onOut;
  } else {
    shape << c + QPointF(-r, r * 0.85) << c + QPointF(r, r * 0.85) << c - QPointF(0, r * 0.95);
    fill = p.near, ink = p.onNear;
    lower = 0.25 * r;
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(fill);
  painter.drawPolygon(shape);
  painter.setPen(ink);
  painter.setFont(uiFont(15, 700));
  painter.drawText(box.translated(0, lower), Qt::AlignCenter, QString::number(static_cast<int>(priority)));
}

}  // namespace vignole
