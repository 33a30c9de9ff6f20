#include "gui/calibration/frames_drawing.h"

#include <QEvent>
#include <QLineF>
#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <utility>

namespace vignole {

namespace {

void arrow(QPainter& painter, const QPointF& from, const QPointF& to) {
  painter.drawLine(from, to);
  const QLineF line(to, from);
  for (const double turn : {-22.0, 22.0}) {
    QLineF barb = line;
    barb.setLength(8);
    barb.setAngle(line.angle() + turn);
    painter.drawLine(barb);
  }
}

}  // namespace

FramesDrawing::FramesDrawing(const Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme) {
  connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
  retranslate();
}

void FramesDrawing::retranslate() {
  setAccessibleName(tr("Frames: world on the light plane, camera, image"));
  update();
}

void FramesDrawing::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

void FramesDrawing::paintEvent(QPaintEvent* /*event*/) {
  const Palette& p = theme_.palette();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(uiFont(14));
  // Drawn on 300 x 200, the camera at the left, the light plane at the right.
  const double scale = std::min(width() / 300.0, height() / 200.0);
  const QPointF middle(width() / 2.0, height() / 2.0);
  const auto at = [&](double x, double y) { return middle + scale * QPointF(x - 150, y - 100); };
  const auto frame = [&](const QPointF& origin, const QPointF& x, const QPointF& y, const QPointF& z,
                         const QColor& ink) {
    painter.setPen(QPen(ink, 1.5));
    const std::pair<QPointF, const char*> axes[] = {{x, "x"}, {y, "y"}, {z, "z"}};
    for (const auto& [way, name] : axes) {
      const QPointF tip = origin + scale * way;
      arrow(painter, origin, tip);
      painter.drawText(tip + 0.25 * scale * way + QPointF(-3, 4), QLatin1String(name));
    }
  };
  const QPointF centre = at(40, 120), point = at(236, 70);
  const QPolygonF sensor{at(84, 78), at(112, 66), at(112, 122), at(84, 136)};
  const QPolygonF plane{at(196, 40), at(286, 14), at(286, 130), at(196, 158)};
  painter.setPen(QPen(p.model, 1));
  painter.setBrush(p.steel);
  painter.drawPolygon(plane);
  painter.setBrush(p.panel2);
  painter.drawPolygon(sensor);
  // The ray from the point of the light plane through the image to the centre of projection.
  painter.setPen(QPen(p.accent, 1.5, Qt::DashLine));
  painter.drawLine(point, centre);
  const QPointF seen = centre + (point - centre) * 0.29;
  painter.setPen(Qt::NoPen);
  painter.setBrush(p.t1);
  for (const QPointF& dot : {point, seen, centre}) painter.drawEllipse(dot, 3, 3);
  painter.setPen(p.t1);
  painter.drawText(point + QPointF(6, -4), QStringLiteral("P(x, y, z)"));
  painter.drawText(seen + QPointF(-8, -scale * 34), QStringLiteral("P′(r, c)"));
  frame(centre, {10, 24}, {-16, 20}, {34, -9}, p.t1);
  frame(at(226, 122), {34, -10}, {0, -30}, {-20, 12}, p.t1);
  painter.setPen(p.t2);
  painter.drawText(QRectF(at(0, 168), at(110, 190)), Qt::AlignCenter, tr("Camera"));
  painter.drawText(QRectF(at(60, 140), at(150, 160)), Qt::AlignCenter, tr("Image"));
  painter.drawText(QRectF(at(180, 168), at(300, 190)), Qt::AlignCenter, tr("World"));
}

}  // namespace vignole
