#include "gui/main_window/alarm_line.h"

#include <QEvent>
#include <QFontMetricsF>
#include <QPainter>
#include <QPushButton>
#include <algorithm>

#include "gui/alarms/alarm_symbol.h"
#include "gui/alarms/alarm_words.h"
#include "gui/monitor/judgement.h"
#include "gui/theme/inscription.h"
#include "gui/theme/panel.h"

namespace vignole {

AlarmLine::AlarmLine(const Theme& theme, QWidget* parent)
    : QWidget(parent), theme_(theme), acknowledge_(makeButton(theme, {}, this)) {
  setFixedHeight(48);
  acknowledge_->setObjectName(QStringLiteral("inLine"));
  acknowledge_->hide();
  connect(acknowledge_, &QPushButton::clicked, this, [this] {
    if (alarm_) emit acknowledged(alarm_->id);
  });
  connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
  retranslate();
}

void AlarmLine::show(const LineSnapshot& line, const AlarmBook& book) {
  const std::vector<Alarm> active = book.active();  // those that nobody has seen come first
  const auto open = static_cast<std::size_t>(std::count_if(
      active.begin(), active.end(), [](const Alarm& alarm) { return alarm.state != AlarmState::Acknowledged; }));
  alarm_ = open > 0 ? std::optional(active.front()) : std::nullopt;
  quiet_ = quietSentence(line);
  if (alarm_) {
    const AlarmRule& rule = *book.rule(alarm_->key.rule);
    cause_ = alarmTitle(rule, alarm_->key.source, alarm_->details);
    action_ = ruleWords(rule.action);
    position_ = open > 1 ? tr("1 of %1").arg(open) : QString();
    setAccessibleName(tr("Alarm, priority %1: %2. %3")
                          .arg(static_cast<int>(alarm_->priority))
                          .arg(QString(cause_).replace('_', ' '), action_));
  } else {
    cause_.clear();
    if (!active.empty()) quiet_ = tr("%n alarm(s) acknowledged, still on", nullptr, static_cast<int>(active.size()));
    setAccessibleName(quiet_);
  }
  acknowledge_->setVisible(alarm_.has_value());
  update();
}

void AlarmLine::retranslate() {
  acknowledge_->setText(tr("Acknowledge"));
  acknowledge_->setAccessibleName(tr("Acknowledge the shown alarm"));
  acknowledge_->setToolTip(tr("Acknowledge the shown alarm (Ctrl+A)"));
  resizeEvent(nullptr);
}

void AlarmLine::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

void AlarmLine::resizeEvent(QResizeEvent* /*event*/) {
  const int wide = acknowledge_->sizeHint().width();
  acknowledge_->setGeometry(width() - wide - 16, 2, wide, height() - 4);
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
  const AlarmPriority priority = alarm_->priority;
  const bool invalid = priority == AlarmPriority::Invalid, out = priority == AlarmPriority::OutOfTolerance;
  painter.fillRect(rect(), invalid ? p.invalidSoft : out ? p.outSoft : p.nearSoft);
  painter.fillRect(QRectF(0, 0, 8, height()), invalid ? p.invalid : out ? p.out : p.near);
  paintPriority(painter, QRectF(24, height() / 2.0 - 12, 24, 24), priority, p);
  painter.setPen(p.t2);
  painter.setFont(uiFont(18));
  const QString time = localTime(alarm_->raised).toString(QStringLiteral("HH:mm:ss"));
  painter.drawText(QPointF(62, baseline), time);
  const QFontMetricsF metrics(painter.font());
  double right = acknowledge_->x() - 16;
  if (!position_.isEmpty()) {
    right -= metrics.horizontalAdvance(position_);
    painter.drawText(QPointF(right, baseline), position_);
    right -= 24;
  }
  const double left = 62 + metrics.horizontalAdvance(time) + 14;
  painter.setPen(p.t1);
  const double used = paintInscription(painter, left, baseline, uiFont(18, 500), cause_, right - left);
  painter.setPen(p.t2);
  const double room = right - left - used - 24;
  if (room > 60) paintInscription(painter, left + used + 24, baseline, uiFont(18), action_, room);
}

}  // namespace vignole
