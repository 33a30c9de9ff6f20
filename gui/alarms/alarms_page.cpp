#include "gui/alarms/alarms_page.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDateTime>
#include <QEvent>
#include <QFileDialog>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QSaveFile>
#include <QScrollArea>
#include <QShortcut>
#include <QTableWidget>

#include "gui/alarms/alarm_symbol.h"
#include "gui/alarms/alarm_words.h"
#include "gui/theme/inscription.h"
#include "gui/theme/panel.h"

namespace vignole {

namespace {

constexpr std::array<int, 4> kMinutes = {15, 30, 60, 240};
constexpr int kOperatorsMinutes = 60;

QString shown(const std::string& text) { return QString::fromStdString(text); }

QPixmap priorityPixmap(AlarmPriority priority, const Palette& palette, int pixels) {
  QPixmap pixmap(2 * pixels, 2 * pixels);
  pixmap.setDevicePixelRatio(2);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  paintPriority(painter, QRectF(1, 1, pixels - 2, pixels - 2), priority, palette);
  return pixmap;
}

QString csvField(QString text) { return '"' + text.replace('"', QStringLiteral("\"\"")) + '"'; }

}  // namespace

AlarmsPage::AlarmsPage(Workplace& place, AlarmWatch& watch, QWidget* parent)
    : Page(parent), place_(place), watch_(watch) {
  setObjectName(QStringLiteral("page"));
  setFocusPolicy(Qt::ClickFocus);
  active_ = new Panel(this);
  acknowledge_ = makeButton(place.theme, QStringLiteral("acknowledge"), active_);
  active_->head()->addWidget(acknowledge_);
  connect(acknowledge_, &QPushButton::clicked, &watch_, &AlarmWatch::acknowledgeAll);
  auto* scroll = new QScrollArea(active_);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  auto* inside = new QWidget(scroll);
  cards_ = new QVBoxLayout(inside);
  cards_->setContentsMargins(0, 0, 0, 0);
  cards_->setSpacing(8);
  scroll->setWidget(inside);
  quiet_ = makeLabel(18, 400, "t2", active_);
  active_->content()->addWidget(quiet_);
  active_->content()->addWidget(scroll, 1);

  history_ = new Panel(this);
  export_ = makeButton(place.theme, QStringLiteral("export"), history_);
  history_->head()->addWidget(export_);
  connect(export_, &QPushButton::clicked, this, &AlarmsPage::exportHistory);
  historyTable_ = new QTableWidget(0, 5, history_);
  styleTable(*historyTable_);
  historyTable_->setIconSize({20, 20});
  history_->content()->addWidget(historyTable_, 1);

  rate_ = new Panel(this);
  auto* figures = new QGridLayout;
  tenMinutes_ = makeLabel(28, 500, "t1", rate_);
  hour_ = makeLabel(28, 500, "t1", rate_);
  day_ = makeLabel(28, 500, "t1", rate_);
  flood_ = makeLabel(15, 400, "t2", rate_, true);
  for (int i = 0; i < 3; ++i) {
    figures->addWidget(makeLabel(15, 400, "t2", rate_), 0, i);
    figures->addWidget(std::array{tenMinutes_, hour_, day_}[static_cast<std::size_t>(i)], 1, i);
  }
  rate_->content()->addLayout(figures);
  rate_->content()->addWidget(flood_);

  shelving_ = new Panel(this);
  what_ = new QComboBox(shelving_);
  minutes_ = new QComboBox(shelving_);
  reason_ = new QLineEdit(shelving_);
  for (QWidget* w : std::initializer_list<QWidget*>{what_, minutes_, reason_}) w->setFont(uiFont(16));
  what_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  what_->setMinimumContentsLength(12);
  shelveButton_ = makeButton(place.theme, QStringLiteral("shelve"), shelving_);
  connect(shelveButton_, &QPushButton::clicked, this, &AlarmsPage::shelve);
  auto* row = new QHBoxLayout;
  row->addWidget(minutes_);
  row->addWidget(shelveButton_, 1);
  limit_ = makeLabel(15, 400, "t2", shelving_, true);
  shelving_->content()->addWidget(what_);
  shelving_->content()->addWidget(reason_);
  shelving_->content()->addLayout(row);
  shelving_->content()->addWidget(limit_);
  shelving_->content()->addStretch(1);

  shelved_ = new Panel(this);
  unshelve_ = makeButton(place.theme, QStringLiteral("revert"), shelved_);
  shelved_->head()->addWidget(unshelve_);
  shelvedTable_ = new QTableWidget(0, 3, shelved_);
  styleTable(*shelvedTable_);
  shelved_->content()->addWidget(shelvedTable_, 1);
  connect(unshelve_, &QPushButton::clicked, this, [this] {
    const std::vector<Alarm> all = watch_.book().shelved();
    const int chosen = shelvedTable_->currentRow();
    if (chosen < 0 || static_cast<std::size_t>(chosen) >= all.size()) return;
    if (auto done = watch_.unshelve(all[static_cast<std::size_t>(chosen)].key); !done)
      shelved_->setNote(shown(done.error().message()));
  });

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(16, 16, 16, 16);
  grid->setSpacing(16);
  grid->addWidget(active_, 0, 0, 2, 1);
  grid->addWidget(history_, 2, 0, 2, 1);
  grid->addWidget(rate_, 0, 1);
  grid->addWidget(shelving_, 1, 1, 2, 1);
  grid->addWidget(shelved_, 3, 1);
  grid->setColumnStretch(0, 11);
  grid->setColumnStretch(1, 5);
  grid->setRowStretch(0, 1);
  grid->setRowStretch(1, 3);
  grid->setRowStretch(2, 1);
  grid->setRowStretch(3, 2);
  connect(&watch_, &AlarmWatch::changed, this, [this] {
    if (isVisible()) refresh();
  });
  connect(&place_.theme, &Theme::changed, this, [this] {
    shownActive_.clear();
    if (isVisible()) refresh();
  });
  retranslate();
}

void AlarmsPage::retranslate() {
  active_->setTitle(tr("Active"));
  acknowledge_->setText(tr("Acknowledge page"));
  acknowledge_->setAccessibleName(tr("Acknowledge all that are shown"));
  acknowledge_->setToolTip(tr("Acknowledge all that are shown (Ctrl+Shift+A)"));
  history_->setTitle(tr("What happened"));
  export_->setText(tr("Export…"));
  export_->setAccessibleName(tr("Export as CSV"));
  historyTable_->setHorizontalHeaderLabels({tr("Time"), tr("What"), tr("Alarm"), tr("Details"), tr("By")});
  historyTable_->setAccessibleName(tr("Lives of the alarms, newest first"));
  rate_->setTitle(tr("Rate"));
  const QStringList spans = {tr("10 min"), tr("Hour"), tr("Day")};
  auto* figures = qobject_cast<QGridLayout*>(rate_->content()->itemAt(0)->layout());
  for (int i = 0; i < 3; ++i) qobject_cast<QLabel*>(figures->itemAtPosition(0, i)->widget())->setText(spans[i]);
  shelving_->setTitle(tr("Shelve"));
  shelving_->setNote(tr("hides an alarm for a while"));
  what_->setAccessibleName(tr("Alarm to shelve"));
  reason_->setPlaceholderText(tr("Reason"));
  reason_->setAccessibleName(tr("Reason for shelving"));
  minutes_->setAccessibleName(tr("For how long"));
  shelveButton_->setText(tr("Shelve"));
  shelveButton_->setAccessibleName(tr("Shelve"));
  shelved_->setTitle(tr("Shelved"));
  shelved_->setNote(tr("comes back by itself"));
  unshelve_->setText(tr("Bring back"));
  unshelve_->setAccessibleName(tr("Bring back the chosen alarm"));
  shelvedTable_->setHorizontalHeaderLabels({tr("Alarm"), tr("Until"), tr("Reason")});
  shelvedTable_->setAccessibleName(tr("Shelved alarms"));
  limit_->setText(tr("An operator may shelve for %1 minutes at most.").arg(kOperatorsMinutes));
  shownActive_.clear();
  refresh();
}

void AlarmsPage::changeEvent(QEvent* event) {
  Page::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

void AlarmsPage::showEvent(QShowEvent* event) {
  Page::showEvent(event);
  refresh();
}

void AlarmsPage::showLine(const LineSnapshot& /*line*/, PullDetail detail) {
  if (detail == PullDetail::Everything) showRates();
}

void AlarmsPage::refresh() {
  showActive();
  showHistory();
  showShelved();
  showRates();
  const bool mayLonger = place_.session.may(Permission::TuneLines);
  const int chosen = minutes_->currentIndex();
  minutes_->clear();
  for (const int minutes : kMinutes)
    if (mayLonger || minutes <= kOperatorsMinutes) minutes_->addItem(tr("%1 min").arg(minutes), minutes);
  minutes_->setCurrentIndex(std::clamp(chosen, 0, minutes_->count() - 1));
}

QWidget* AlarmsPage::card(const Alarm& alarm) {
  const AlarmRule* rule = watch_.book().rule(alarm.key.rule);
  const Palette& p = place_.theme.palette();
  auto* frame = new QFrame;
  const QColor strong = alarm.priority == AlarmPriority::Invalid          ? p.invalid
                        : alarm.priority == AlarmPriority::OutOfTolerance ? p.out
                                                                          : p.near;
  const bool open = alarm.state != AlarmState::Acknowledged;
  const QColor soft = !open                                             ? p.panel2
                      : alarm.priority == AlarmPriority::Invalid        ? p.invalidSoft
                      : alarm.priority == AlarmPriority::OutOfTolerance ? p.outSoft
                                                                        : p.nearSoft;
  frame->setStyleSheet(
      QStringLiteral("QFrame#card { background: %1; border-left: 8px solid %2; }").arg(soft.name(), strong.name()));
  frame->setObjectName(QStringLiteral("card"));
  auto* grid = new QGridLayout(frame);
  grid->setContentsMargins(12, 8, 12, 8);
  grid->setVerticalSpacing(2);
  grid->setHorizontalSpacing(12);
  auto* symbol = new QLabel(frame);
  symbol->setPixmap(priorityPixmap(alarm.priority, p, 28));
  symbol->setAccessibleName(tr("Priority %1").arg(static_cast<int>(alarm.priority)));
  grid->addWidget(symbol, 0, 0);
  auto* title = makeLabel(20, 500, "t1", frame, true);
  title->setText(alarmTitle(*rule, alarm.key.source));
  grid->addWidget(title, 0, 1, 1, 2);
  auto* time = makeLabel(18, 500, "t1", frame);
  time->setText(localTime(alarm.raised).toString(QStringLiteral("HH:mm:ss")));
  grid->addWidget(time, 0, 3, Qt::AlignRight);
  const std::pair<QString, QString> rows[] = {{tr("Cause"), causeWords(*rule, alarm)},
                                              {tr("Consequence"), ruleWords(rule->consequence)},
                                              {tr("Action"), ruleWords(rule->action)}};
  for (int i = 0; i < 3; ++i) {
    auto* word = makeLabel(15, 400, "t2", frame);
    word->setText(rows[i].first);
    auto* text = makeLabel(16, i == 2 ? 500 : 400, "t1", frame, true);
    text->setText(rows[i].second);
    grid->addWidget(word, i + 1, 1, Qt::AlignTop);
    grid->addWidget(text, i + 1, 2);
  }
  if (open) {
    auto* button = makeButton(place_.theme, {}, frame, true);
    button->setText(tr("Acknowledge"));
    button->setAccessibleName(tr("Acknowledge: %1").arg(title->text()));
    button->setEnabled(place_.session.may(Permission::AcknowledgeAlarms));
    connect(button, &QPushButton::clicked, &watch_, [this, id = alarm.id] { watch_.acknowledge(id); });
    grid->addWidget(button, 1, 3, 3, 1, Qt::AlignRight | Qt::AlignVCenter);
  } else {
    auto* by = makeLabel(15, 400, "t2", frame);
    by->setText(tr("acknowledged by %1").arg(shown(alarm.acknowledgedBy)));
    grid->addWidget(by, 1, 3, 3, 1, Qt::AlignRight | Qt::AlignVCenter);
  }
  grid->setColumnStretch(2, 1);
  return frame;
}

void AlarmsPage::showActive() {
  const std::vector<Alarm> all = watch_.book().active();
  std::size_t open = 0;
  QString now;
  for (const Alarm& alarm : all) {
    if (alarm.state != AlarmState::Acknowledged) ++open;
    now += QStringLiteral("%1/%2/%3 ").arg(alarm.id).arg(static_cast<int>(alarm.state)).arg(alarm.details.size());
  }
  active_->setNote(all.empty() ? QString()
                               : tr("%n alarm(s)", nullptr, static_cast<int>(all.size())) + QStringLiteral(", ") +
                                     tr("%n not acknowledged", nullptr, static_cast<int>(open)));
  acknowledge_->setEnabled(open > 0 && place_.session.may(Permission::AcknowledgeAlarms));
  quiet_->setVisible(all.empty());
  quiet_->setText(tr("Nothing is wrong. Alarms appear here with their cause, their consequence and what to do."));
  if (now == shownActive_ && !now.isEmpty()) return;
  shownActive_ = now;
  while (QLayoutItem* item = cards_->takeAt(0)) {
    if (item->widget() != nullptr) item->widget()->deleteLater();
    delete item;
  }
  for (const Alarm& alarm : all) cards_->addWidget(card(alarm));
  cards_->addStretch(1);
  const QString before = what_->currentData().toString();
  what_->clear();
  for (const Alarm& alarm : all)
    what_->addItem(alarmTitle(*watch_.book().rule(alarm.key.rule), alarm.key.source),
                   shown(alarm.key.rule) + '\n' + shown(alarm.key.source));
  if (const int at = what_->findData(before); at >= 0) what_->setCurrentIndex(at);
  shelveButton_->setEnabled(!all.empty());
}

void AlarmsPage::showHistory() {
  const auto& events = watch_.log().steps();
  historyTable_->setRowCount(static_cast<int>(events.size()));
  const Palette& p = place_.theme.palette();
  for (int i = 0; i < static_cast<int>(events.size()); ++i) {
    const AlarmEvent& e = events[static_cast<std::size_t>(i)];
    const AlarmRule* rule = watch_.book().rule(e.key.rule);
    const QString cells[] = {localTime(e.time).toString(QStringLiteral("HH:mm:ss")), eventWord(e.kind),
                             rule != nullptr ? alarmTitle(*rule, e.key.source) : tr("alarms"), shown(e.text),
                             shown(e.who)};
    for (int column = 0; column < 5; ++column) {
      auto* item = new QTableWidgetItem(cells[column]);
      item->setToolTip(cells[column]);
      if (column == 1 && rule != nullptr) item->setIcon(priorityPixmap(e.priority, p, 20));
      historyTable_->setItem(i, column, item);
    }
  }
  const int wide = historyTable_->viewport()->width();
  const int shares[] = {10, 16, 40, 22};
  for (int column = 0; column < 4; ++column) historyTable_->setColumnWidth(column, wide * shares[column] / 100);
  history_->setNote(events.empty() ? tr("nothing since the program started") : tr("since the program started"));
  export_->setEnabled(!events.empty());
}

void AlarmsPage::showShelved() {
  const std::vector<Alarm> all = watch_.book().shelved();
  shelvedTable_->setRowCount(static_cast<int>(all.size()));
  for (int i = 0; i < static_cast<int>(all.size()); ++i) {
    const Alarm& alarm = all[static_cast<std::size_t>(i)];
    const QString cells[] = {alarmTitle(*watch_.book().rule(alarm.key.rule), alarm.key.source),
                             localTime(alarm.shelf->until).toString(QStringLiteral("HH:mm")),
                             shown(alarm.shelf->reason)};
    for (int column = 0; column < 3; ++column) {
      auto* item = new QTableWidgetItem(cells[column]);
      item->setToolTip(cells[column]);
      shelvedTable_->setItem(i, column, item);
    }
  }
  const int wide = shelvedTable_->viewport()->width();
  shelvedTable_->setColumnWidth(0, wide / 2);
  shelvedTable_->setColumnWidth(1, wide / 5);
  unshelve_->setEnabled(!all.empty());
}

void AlarmsPage::showRates() {
  const AlarmRates rates = watch_.rates();
  tenMinutes_->setText(QString::number(rates.tenMinutes));
  hour_->setText(QString::number(rates.hour));
  day_->setText(QString::number(rates.day));
  flood_->setText(rates.flood ? tr("Flood: more than 10 alarms in 10 minutes. Look for one cause behind them.")
                              : tr("Target: below 1 in 10 minutes; above 10 it is a flood."));
}

void AlarmsPage::shelve() {
  const QStringList key = what_->currentData().toString().split('\n');
  if (key.size() != 2) return;
  const auto done = watch_.shelve({key[0].toStdString(), key[1].toStdString()}, reason_->text().trimmed().toStdString(),
                                  std::chrono::minutes(minutes_->currentData().toInt()));
  if (done) reason_->clear();
  limit_->setText(done ? tr("An operator may shelve for %1 minutes at most.").arg(kOperatorsMinutes)
                       : shown(done.error().message()));
}

void AlarmsPage::exportHistory() {
  const QString name = QFileDialog::getSaveFileName(this, tr("Export as CSV"), QStringLiteral("alarms.csv"));
  if (name.isEmpty()) return;
  QString text = QStringLiteral("time,what,rule,source,priority,details,by\n");
  for (const AlarmEvent& e : watch_.log().steps())
    text += QStringList{localTime(e.time).toString(Qt::ISODateWithMs),
                        QString::fromUtf8(vignole::name(e.kind).data()),
                        shown(e.key.rule),
                        csvField(shown(e.key.source)),
                        QString::number(static_cast<int>(e.priority)),
                        csvField(shown(e.text)),
                        csvField(shown(e.who))}
                .join(',') +
            '\n';
  QSaveFile file(name);
  if (!file.open(QIODevice::WriteOnly) || file.write(text.toUtf8()) < 0 || !file.commit())
    history_->setNote(tr("%1 cannot be written: %2").arg(name, file.errorString()));
}

}  // namespace vignole
