#include "gui/calibration_rig/plate_drawing.h"

#include <QPainter>

namespace vignole {

namespace {
constexpr double kMarginMm = 12;
}

PlateDrawing::PlateDrawing(const Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme) {
  connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void PlateDrawing::show(const PinPlate& plate, const PlatePose& wanted, const std::optional<PlatePose>& seen) {
  plate_ = plate;
  wanted_ = wanted;
  seen_ = seen;
  update();
}

void PlateDrawing::paintEvent(QPaintEvent* /*event*/) {
  if (plate_.pins.empty()) return;
  const Palette& p = theme_.palette();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Transform2 wanted = placementAt(wanted_).worldFromPlate;
  Point2 low(1e9, 1e9), high(-1e9, -1e9);
  for (const Pin& pin : plate_.pins) {
    low = low.cwiseMin(wanted * pin.centreMm);
    high = high.cwiseMax(wanted * pin.centreMm);
  }
  low -= Point2(kMarginMm, kMarginMm);
  high += Point2(kMarginMm, kMarginMm);
  const double scale = std::min(width() / (high.x() - low.x()), height() / (high.y() - low.y()));
  const Point2 middle = (low + high) / 2;
  const auto map = [&](const Point2& mm) {
    return QPointF(width() / 2.0 + (mm.x() - middle.x()) * scale, height() / 2.0 - (mm.y() - middle.y()) * scale);
  };
  painter.setPen(QPen(p.line, 1));
  painter.setBrush(p.panel2);
  painter.drawRect(QRectF(map({low.x(), high.y()}), map({high.x(), low.y()})).adjusted(0.5, 0.5, -0.5, -0.5));
  if (seen_) {
    const Transform2 seen = placementAt(*seen_).worldFromPlate;
    painter.setPen(QPen(p.accent, 1.5, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    for (const Pin& pin : plate_.pins)
      painter.drawEllipse(map(seen * pin.centreMm), pin.radiusMm * scale, pin.radiusMm * scale);
  }
  painter.setFont(uiFont(14));
  for (const Pin& pin : plate_.pins) {
    const QPointF at = map(wanted * pin.centreMm);
    painter.setPen(QPen(p.t3, 1.5));
    painter.setBrush(p.chan);
    painter.drawEllipse(at, pin.radiusMm * scale, pin.radiusMm * scale);
    painter.setPen(p.t1);
    painter.drawText(at + QPointF(pin.radiusMm * scale + 3, 5), QString::number(pin.number));
  }
}

}  // namespace vignole
