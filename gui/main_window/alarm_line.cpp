#include "gui/main_window/alarm_line.h"

#include <QFontMetricsF>
#include <QPainter>
#include <cmath>

#include "gui/alarms/alarm_symbol.h"
#include "gui/theme/inscription.h"
#include "report/state_symbol.h"

namespace vignole {

AlarmLine::AlarmLine(const Theme& theme, std::function<QDateTime()> clock, QWidget* parent)
    : QWidget(parent), theme_(theme), clock_(std::move(clock)) {
  setFixedHeight(48);
  connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void AlarmLine::show(const LineSnapshot& line) {
  std::optional<AlarmSentence> now = highestAlarm(line);
  // The time is that of the cause; a text that only counts up does not start a new alarm.
  if (now && (!alarm_ || alarm_->priority != now->priority)) since_ = clock_();
  alarm_ = std::move(now);
  quiet_ = quietSentence(line);
  setAccessibleName(alarm_ ? tr("Alarm, priority %1: %2. %3")
                                 .arg(alarm_->priority)
                                 .arg(QString(alarm_->cause).replace('_', ' '), alarm_->action)
                           : quiet_);
  update();
}

void AlarmLine::paintEvent(QPaintEvent* /*event*/) {
  const Palette& p = theme_.palette();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double baseline = height() / 2.0 + 7;
  if (!alarm_) {
    painter.fillRect(rect(), p.bg);
    painter.fillRect(QRectF(0, 0, width(), 1), p.line);
    paintSymbol(painter, QRectF(26, height() / 2.0 - 10, 20, 20), StateSymbol::Good, p);
    painter.setPen(p.t2);
    painter.setFont(uiFont(18));
    painter.drawText(QPointF(60, baseline), quiet_);
    return;
  }
  const QColor soft = alarm_->priority == 1 ? p.invalidSoft : alarm_->priority == 2 ? p.outSoft : p.nearSoft;
  const QColor strong = alarm_->priority == 1 ? p.invalid : alarm_->priority == 2 ? p.out : p.near;
  painter.fillRect(rect(), soft);
  painter.fillRect(QRectF(0, 0, 8, height()), strong);
  paintPriority(painter, QRectF(24, height() / 2.0 - 12, 24, 24), static_cast<AlarmPriority>(alarm_->priority), p);
  painter.setPen(p.t2);
  painter.setFont(uiFont(18));
  const QString time = since_.toString(QStringLiteral("HH:mm:ss"));
  painter.drawText(QPointF(62, baseline), time);
  const double left = 62 + QFontMetricsF(painter.font()).horizontalAdvance(time) + 14;
  painter.setPen(p.t1);
  const double used = paintInscription(painter, left, baseline, uiFont(18, 500), alarm_->cause, width() - left - 16);
  painter.setPen(p.t2);
  const double room = width() - left - used - 40;
  if (room > 60) paintInscription(painter, left + used + 24, baseline, uiFont(18), alarm_->action, room);
}

}  // namespace vignole
