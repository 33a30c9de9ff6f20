#include "gui/rails/rail_band.h"

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace vignole {

namespace {
constexpr double kSide = 14, kTop = 24, kHeight = 22;
}

RailBand::RailBand(const Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme) {
  setAccessibleName(tr("Place along the rail"));
  connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void RailBand::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::LanguageChange) return;
  setAccessibleName(tr("Place along the rail"));
  update();
}

void RailBand::setRail(double lengthM, QVector<BandStretch> stretches) {
  lengthM_ = lengthM;
  stretches_ = std::move(stretches);
  update();
}

void RailBand::setPosition(double positionM) {
  positionM_ = positionM;
  update();
}

double RailBand::xOf(double positionM) const {
  return kSide + (width() - 2 * kSide) * (lengthM_ > 0 ? positionM / lengthM_ : 0);
}

void RailBand::ask(double x) {
  if (lengthM_ > 0) emit positionAsked(std::clamp((x - kSide) / (width() - 2 * kSide), 0.0, 1.0) * lengthM_);
}

void RailBand::mousePressEvent(QMouseEvent* event) { ask(event->position().x()); }
void RailBand::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) ask(event->position().x());
}

void RailBand::paintEvent(QPaintEvent* /*event*/) {
  const Palette& p = theme_.palette();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(QRectF(kSide, kTop, width() - 2 * kSide, kHeight), p.chan);
  if (lengthM_ <= 0) return;
  for (const BandStretch& s : stretches_) {
    const double from = xOf(s.fromM), to = std::max(xOf(s.toM), from + 3);
    painter.fillRect(QRectF(from, kTop, to - from, kHeight), s.symbol == StateSymbol::Near ? p.near : p.out);
    paintSymbol(painter, QRectF((from + to) / 2 - 8, kTop - 20, 16, 16), s.symbol, p);
  }
  painter.setFont(uiFont(14));
  painter.setPen(p.t3);
  const double raw = lengthM_ / 12, ten = std::pow(10, std::floor(std::log10(raw)));
  const double step = raw / ten < 2 ? 2 * ten : raw / ten < 5 ? 5 * ten : 10 * ten;
  for (double m = 0; m <= lengthM_ + 1e-9; m += step) {
    const double x = xOf(m);
    painter.drawLine(QPointF(x, kTop + kHeight), QPointF(x, kTop + kHeight + 5));
    const QString words = locale().toString(m, 'g', 4);
    const double wide = painter.fontMetrics().horizontalAdvance(words);
    painter.drawText(QPointF(std::clamp(x - wide / 2, 0.0, width() - wide), kTop + kHeight + 20), words);
  }
  const double x = xOf(positionM_);
  painter.fillRect(QRectF(x - 1.5, kTop - 4, 3, kHeight + 12), p.accent);
}

}  // namespace vignole
