#include "gui/alarms/alarm_card.h"

#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

#include "gui/alarms/alarm_symbol.h"
#include "gui/alarms/alarm_words.h"
#include "gui/theme/panel.h"

namespace vignole {

QPixmap priorityPixmap(AlarmPriority priority, const Palette& palette, int pixels) {
  QPixmap pixmap(2 * pixels, 2 * pixels);
  pixmap.setDevicePixelRatio(2);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  paintPriority(painter, QRectF(1, 1, pixels - 2, pixels - 2), priority, palette);
  return pixmap;
}

AlarmCard::AlarmCard(const Theme& theme, const AlarmRule& rule, const Alarm& alarm, bool mayAcknowledge)
    : theme_(theme) {
  const bool open = alarm.state != AlarmState::Acknowledged;
  const QString title = alarmTitle(rule, alarm.key.source, alarm.details);
  QString right = localTime(alarm.raised).toString(QStringLiteral("HH:mm:ss"));
  if (alarm.chattering) right = tr("comes and goes") + QStringLiteral("   ") + right;
  if (alarm.stale) right = tr("on for more than a day") + QStringLiteral("   ") + right;
  if (alarm.state == AlarmState::ReturnedUnacknowledged) right = tr("gone") + QStringLiteral("   ") + right;
  QGridLayout* grid = frame(alarm.priority, open, title, right);
  words(*grid, causeWords(rule, alarm), rule);
  if (open) {
    button(*grid, title, {alarm.id}, mayAcknowledge);
    return;
  }
  auto* by = makeLabel(15, 400, "t2", this);
  by->setText(tr("acknowledged by %1").arg(personWord(alarm.acknowledgedBy)));
  grid->addWidget(by, 1, 3, 3, 1, Qt::AlignRight | Qt::AlignVCenter);
}

AlarmCard::AlarmCard(const Theme& theme, const AlarmRule& rule, const AlarmGroup& group, bool mayAcknowledge)
    : theme_(theme) {
  const bool open = group.unacknowledged > 0;
  QGridLayout* grid = frame(group.priority, open, alarmTitle(rule, {}),
                            tr("%n alarm(s)", nullptr, static_cast<int>(group.alarms.size())));
  words(*grid, ruleWords(rule.cause), rule);
  if (open) button(*grid, alarmTitle(rule, {}), group.alarms, mayAcknowledge);
}

QGridLayout* AlarmCard::frame(AlarmPriority priority, bool open, const QString& title, const QString& right) {
  const Palette& p = theme_.palette();
  const bool invalid = priority == AlarmPriority::Invalid, out = priority == AlarmPriority::OutOfTolerance;
  const QColor strong = invalid ? p.invalid : out ? p.out : p.near;
  const QColor soft = !open ? p.panel2 : invalid ? p.invalidSoft : out ? p.outSoft : p.nearSoft;
  setObjectName(QStringLiteral("card"));
  setStyleSheet(
      QStringLiteral("QFrame#card { background: %1; border-left: 8px solid %2; }").arg(soft.name(), strong.name()));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(12, 8, 12, 8);
  grid->setVerticalSpacing(2);
  grid->setHorizontalSpacing(12);
  grid->setColumnStretch(2, 1);
  auto* symbol = new QLabel(this);
  symbol->setPixmap(priorityPixmap(priority, p, 28));
  symbol->setAccessibleName(tr("Priority %1").arg(static_cast<int>(priority)));
  grid->addWidget(symbol, 0, 0);
  auto* name = makeLabel(20, 500, "t1", this, true);
  name->setText(title);
  grid->addWidget(name, 0, 1, 1, 2);
  auto* time = makeLabel(18, 500, "t1", this);
  time->setText(right);
  grid->addWidget(time, 0, 3, Qt::AlignRight);
  return grid;
}

void AlarmCard::words(QGridLayout& grid, const QString& cause, const AlarmRule& rule) {
  const std::pair<QString, QString> rows[] = {
      {tr("Cause"), cause}, {tr("Consequence"), ruleWords(rule.consequence)}, {tr("Action"), ruleWords(rule.action)}};
  for (int i = 0; i < 3; ++i) {
    auto* word = makeLabel(15, 400, "t2", this);
    word->setText(rows[i].first);
    auto* text = makeLabel(16, i == 2 ? 500 : 400, "t1", this, true);
    text->setText(rows[i].second);
    grid.addWidget(word, i + 1, 1, Qt::AlignTop);
    grid.addWidget(text, i + 1, 2);
  }
}

void AlarmCard::button(QGridLayout& grid, const QString& title, const std::vector<std::uint64_t>& alarms,
                       bool mayAcknowledge) {
  QPushButton* acknowledge = makeButton(theme_, {}, this, true);
  acknowledge->setText(tr("Acknowledge"));
  acknowledge->setAccessibleName(tr("Acknowledge: %1").arg(title));
  acknowledge->setEnabled(mayAcknowledge);
  connect(acknowledge, &QPushButton::clicked, this, [this, alarms] { emit acknowledged(alarms); });
  grid.addWidget(acknowledge, 1, 3, 3, 1, Qt::AlignRight | Qt::AlignVCenter);
}

}  // namespace vignole
