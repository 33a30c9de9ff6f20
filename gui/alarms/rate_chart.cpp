#include "gui/alarms/rate_chart.h"

#include <QEvent>
#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>

namespace vignole {

namespace {
constexpr int kHours = 8, kBars = 6 * kHours, kFlood = 10, kTarget = 1;
constexpr double kBarS = 600;
}  // namespace

RateChart::RateChart(const Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme), bars_(kBars, 0) {
  connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
  show({});
}

void RateChart::show(const QVector<double>& agesS) {
  bars_.fill(0);
  for (const double age : agesS)
    if (const int back = static_cast<int>(age / kBarS); age >= 0 && back < kBars) ++bars_[kBars - 1 - back];
  const int most = *std::max_element(bars_.begin(), bars_.end());
  setAccessibleName(tr("Alarms in each ten minutes of the last %1 hours: at most %2").arg(kHours).arg(most));
  update();
}

void RateChart::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) update();
}

void RateChart::paintEvent(QPaintEvent* /*event*/) {
  const Palette& p = theme_.palette();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QFont small = uiFont(14);
  painter.setFont(small);
  const QFontMetricsF metrics(small);
  const QRectF plot(28, 6, width() - 36, height() - 46);
  const int most = std::max(12, *std::max_element(bars_.begin(), bars_.end()) + 1);
  const auto y = [&](double n) { return plot.bottom() - n / most * plot.height(); };
  painter.setPen(QPen(p.line, 1));
  painter.setBrush(p.panel2);
  painter.drawRect(plot);
  const double wide = plot.width() / kBars;
  for (int i = 0; i < kBars; ++i) {
    if (bars_[i] == 0) continue;
    const QRectF bar(plot.left() + i * wide + 1, y(bars_[i]), wide - 2, plot.bottom() - y(bars_[i]));
    painter.fillRect(bar, bars_[i] > kFlood ? p.out : p.t2);
  }
  QPen dashed(p.t1, 1.5);
  for (const auto& [level, dash] : {std::pair{kFlood, 7.0}, std::pair{kTarget, 2.0}}) {
    dashed.setDashPattern({dash, 4});
    painter.setPen(dashed);
    painter.drawLine(QPointF(plot.left(), y(level)), QPointF(plot.right(), y(level)));
    painter.setPen(p.t3);
    painter.drawText(QRectF(0, y(level) - 10, plot.left() - 6, 20), Qt::AlignRight | Qt::AlignVCenter,
                     QString::number(level));
  }
  painter.setPen(p.t2);
  painter.drawText(QPointF(plot.left() + 8, y(kFlood) - 5), tr("flood above %1").arg(kFlood));
  for (int hours = 0; hours <= kHours; hours += 2) {
    const double x = plot.right() - plot.width() * hours / kHours;
    painter.setPen(p.t3);
    const QString text = hours == 0 ? QStringLiteral("0") : QChar(0x2212) + QString::number(hours);
    painter.drawText(QPointF(x - metrics.horizontalAdvance(text) / 2, plot.bottom() + 17), text);
  }
  const QString axis = metrics.elidedText(tr("hours; dotted at %1: target").arg(kTarget), Qt::ElideRight, plot.width());
  painter.drawText(QPointF(plot.right() - metrics.horizontalAdvance(axis), plot.bottom() + 36), axis);
}

}  // namespace vignole
