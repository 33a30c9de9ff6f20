#include "gui/alarms/alarms_page.h"

#include <QComboBox>
#include <QDateTime>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QTableWidget>
#include <algorithm>

#include "gui/alarms/alarm_card.h"
#include "gui/alarms/alarm_history_panel.h"
#include "gui/alarms/alarm_words.h"
#include "gui/alarms/rate_chart.h"
#include "gui/theme/panel.h"
#include "report/dimension_text.h"
#include "report/state_symbol.h"

namespace vignole {

namespace {

constexpr std::array<int, 4> kMinutes = {15, 30, 60, 240};
constexpr int kOperatorsMinutes = 60;
constexpr int kHeightForAll = 800;  ///< lower pages leave out the chart and the health

QString shown(const std::string& text) { return QString::fromStdString(text); }

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
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* inside = new QWidget(scroll);
  cards_ = new QVBoxLayout(inside);
  cards_->setContentsMargins(0, 0, 0, 0);
  cards_->setSpacing(8);
  scroll->setWidget(inside);
  quiet_ = makeLabel(18, 400, "t2", active_, true);
  active_->content()->addWidget(quiet_);
  active_->content()->addWidget(scroll, 1);
  history_ = new AlarmHistoryPanel(place.theme, watch, this);
  makeRate();
  makeShelving();
  makeHealth();

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(16, 16, 16, 16);
  grid->setSpacing(16);
  auto* right = new QVBoxLayout;
  right->setSpacing(16);
  right->addWidget(rate_, 4);
  right->addWidget(shelving_);
  right->addWidget(shelved_, 3);
  right->addWidget(healthPanel_);
  grid->addWidget(active_, 0, 0);
  grid->addWidget(history_, 1, 0);
  grid->addLayout(right, 0, 1, 2, 1);
  grid->setColumnStretch(0, 11);
  grid->setColumnStretch(1, 5);
  grid->setRowStretch(0, 3);
  grid->setRowStretch(1, 2);
  connect(&watch_, &AlarmWatch::changed, this, [this] {
    if (isVisible()) refresh();
  });
  connect(&place_.session, &Session::changed, this, [this] {
    shownActive_.clear();
    if (isVisible()) refresh();
  });
  connect(&place_.theme, &Theme::changed, this, [this] {
    shownActive_.clear();
    if (isVisible()) refresh();
  });
  setWhole(false);
  retranslate();
}

void AlarmsPage::makeRate() {
  rate_ = new Panel(this);
  chart_ = new RateChart(place_.theme, rate_);
  rate_->content()->addWidget(chart_, 1);
  auto* figures = new QGridLayout;
  figures->setVerticalSpacing(0);
  QLabel** numbers[] = {&tenMinutes_, &hour_, &day_};
  for (int i = 0; i < 3; ++i) {
    words_[i] = makeLabel(15, 400, "t2", rate_);
    *numbers[i] = makeLabel(28, 500, "t1", rate_);
    figures->addWidget(words_[i], 0, i);
    figures->addWidget(*numbers[i], 1, i);
    figures->setColumnStretch(i, 1);
  }
  flood_ = makeLabel(15, 400, "t2", rate_, true);
  rate_->content()->addLayout(figures);
  rate_->content()->addWidget(flood_);
}

void AlarmsPage::makeShelving() {
  shelving_ = new Panel(this);
  what_ = new QComboBox(shelving_);
  minutes_ = new QComboBox(shelving_);
  reason_ = new QLineEdit(shelving_);
  for (QWidget* w : std::initializer_list<QWidget*>{what_, minutes_, reason_}) w->setFont(uiFont(16));
  what_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  what_->setMinimumContentsLength(12);
  shelveButton_ = makeButton(place_.theme, QStringLiteral("shelve"), shelving_);
  connect(shelveButton_, &QPushButton::clicked, this, &AlarmsPage::shelve);
  auto* row = new QHBoxLayout;
  row->addWidget(minutes_);
  row->addWidget(shelveButton_, 1);
  limit_ = makeLabel(15, 400, "t2", shelving_, true);
  shelving_->content()->addWidget(what_);
  shelving_->content()->addWidget(reason_);
  shelving_->content()->addLayout(row);
  shelving_->content()->addWidget(limit_);

  shelved_ = new Panel(this);
  unshelve_ = makeButton(place_.theme, QStringLiteral("revert"), shelved_);
  shelved_->head()->addWidget(unshelve_);
  shelvedTable_ = new QTableWidget(0, 3, shelved_);
  styleTable(*shelvedTable_);
  shelved_->content()->addWidget(shelvedTable_, 1);
  connect(unshelve_, &QPushButton::clicked, this, [this] {
    const std::vector<Alarm> all = watch_.book().shelved();
    const int chosen = std::max(0, shelvedTable_->currentRow());
    if (static_cast<std::size_t>(chosen) >= all.size()) return;
    if (auto done = watch_.unshelve(all[static_cast<std::size_t>(chosen)].key); !done)
      shelved_->setNote(shown(done.error().message()));
  });
}

void AlarmsPage::makeHealth() {
  healthPanel_ = new Panel(this);
  health_ = new QTableWidget(4, 2, healthPanel_);
  styleTable(*health_);
  health_->setSelectionMode(QAbstractItemView::NoSelection);
  health_->setFocusPolicy(Qt::NoFocus);
  health_->horizontalHeader()->hide();
  health_->verticalHeader()->setDefaultSectionSize(30);
  health_->setFixedHeight(4 * 30 + 2);
  health_->setIconSize({18, 18});
  healthPanel_->content()->addWidget(health_);
}

void AlarmsPage::retranslate() {
  active_->setTitle(tr("Active"));
  acknowledge_->setText(tr("Acknowledge page"));
  acknowledge_->setAccessibleName(tr("Acknowledge all that are shown"));
  acknowledge_->setToolTip(tr("Acknowledge all that are shown (Ctrl+Shift+A)"));
  rate_->setTitle(tr("Rate"));
  rate_->setNote(tr("alarms in 10 minutes"));
  words_[0]->setText(tr("10 min"));
  words_[1]->setText(tr("Hour"));
  words_[2]->setText(tr("Day"));
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
  healthPanel_->setTitle(tr("Health of the alarms"));
  healthPanel_->setNote(tr("since the program started"));
  health_->setAccessibleName(tr("Health of the alarms"));
  shownActive_.clear();
  history_->retranslate();
  refresh();
}

void AlarmsPage::changeEvent(QEvent* event) {
  Page::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

void AlarmsPage::showEvent(QShowEvent* event) {
  Page::showEvent(event);
  setWhole(height() >= kHeightForAll);
  shownActive_.clear();
  refresh();
}

void AlarmsPage::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  setWhole(height() >= kHeightForAll);
}

void AlarmsPage::hideEvent(QHideEvent* event) {
  Page::hideEvent(event);
  setWhole(false);  // a page that is not shown must not keep the window from getting smaller
}

void AlarmsPage::setWhole(bool whole) {
  chart_->setVisible(whole);
  healthPanel_->setVisible(whole);
  layout()->activate();
}

void AlarmsPage::showLine(const LineSnapshot& /*line*/, PullDetail detail) {
  if (detail != PullDetail::Everything || ++ticks_ % 5 != 0) return;  // once a second
  showRates();
  showHealth();
}

void AlarmsPage::refresh() {
  showActive();
  history_->refresh();
  showShelved();
  showRates();
  showHealth();
  const bool mayLonger = place_.session.may(Permission::TuneLines);
  const int chosen = minutes_->currentIndex();
  minutes_->clear();
  for (const int minutes : kMinutes)
    if (mayLonger || minutes <= kOperatorsMinutes) minutes_->addItem(tr("%1 min").arg(minutes), minutes);
  minutes_->setCurrentIndex(std::clamp(chosen, 0, minutes_->count() - 1));
}

void AlarmsPage::showActive() {
  const std::vector<Alarm> all = watch_.book().active();
  const bool flood = watch_.rates().flood, may = place_.session.may(Permission::AcknowledgeAlarms);
  std::size_t open = 0;
  QString now = flood ? QStringLiteral("flood ") : QString();
  for (const Alarm& alarm : all) {
    if (alarm.state != AlarmState::Acknowledged) ++open;
    now += QStringLiteral("%1/%2/%3/%4%5 ")
               .arg(alarm.id)
               .arg(static_cast<int>(alarm.state))
               .arg(alarm.details.size())
               .arg(alarm.chattering)
               .arg(alarm.stale);
  }
  QString note = tr("%n alarm(s)", nullptr, static_cast<int>(all.size())) + QStringLiteral(", ") +
                 tr("%n not acknowledged", nullptr, static_cast<int>(open));
  if (flood) note += QStringLiteral(", ") + tr("flood: grouped by rule");
  active_->setNote(all.empty() ? QString() : note);
  acknowledge_->setEnabled(open > 0 && may);
  quiet_->setVisible(all.empty());
  quiet_->setText(tr("Nothing is wrong. Alarms appear here with their cause, their consequence and what to do."));
  if (now == shownActive_ && !now.isEmpty()) return;
  shownActive_ = now;
  while (QLayoutItem* item = cards_->takeAt(0)) {
    // Not at once: it may be the one whose button has just been pressed.
    if (item->widget() != nullptr) item->widget()->hide(), item->widget()->deleteLater();
    delete item;
  }
  const auto add = [this](AlarmCard* card) {
    connect(card, &AlarmCard::acknowledged, &watch_,
            qOverload<const std::vector<std::uint64_t>&>(&AlarmWatch::acknowledge));
    cards_->addWidget(card);
  };
  if (flood)
    for (const AlarmGroup& group : watch_.book().groups())
      add(new AlarmCard(place_.theme, *watch_.book().rule(group.rule), group, may));
  else
    for (const Alarm& alarm : all) add(new AlarmCard(place_.theme, *watch_.book().rule(alarm.key.rule), alarm, may));
  cards_->addStretch(1);
  const QString before = what_->currentData().toString();
  what_->clear();
  for (const Alarm& alarm : all)
    what_->addItem(alarmTitle(*watch_.book().rule(alarm.key.rule), alarm.key.source, alarm.details),
                   shown(alarm.key.rule) + '\n' + shown(alarm.key.source));
  if (const int at = what_->findData(before); at >= 0) what_->setCurrentIndex(at);
  shelveButton_->setEnabled(!all.empty() && may);
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
  unshelve_->setEnabled(!all.empty() && place_.session.may(Permission::AcknowledgeAlarms));
}

void AlarmsPage::showRates() {
  const AlarmRates rates = watch_.rates();
  tenMinutes_->setText(QString::number(rates.tenMinutes));
  hour_->setText(QString::number(rates.hour));
  day_->setText(QString::number(rates.day));
  flood_->setText(rates.flood ? tr("Flood: more than 10 alarms in 10 minutes. Look for one cause behind them.")
                              : tr("Target: below 1 in 10 minutes; above 10 it is a flood."));
  QVector<double> ages;
  const double nowS = static_cast<double>(watch_.now().time_since_epoch().count()) / 1000;
  for (const AlarmRecord& alarm : watch_.log().history())
    ages.append(nowS - static_cast<double>(alarm.raisedUs) * 1e-6);
  chart_->show(ages);
}

void AlarmsPage::showHealth() {
  std::size_t chattering = 0, stale = 0, floods = 0;
  QString which;
  for (const Alarm& alarm : watch_.book().active()) {
    if (alarm.chattering && ++chattering == 1)
      which = alarmTitle(*watch_.book().rule(alarm.key.rule), alarm.key.source, alarm.details);
    if (alarm.stale) ++stale;
  }
  for (const AlarmEvent& step : watch_.log().steps())
    if (step.kind == AlarmEventKind::FloodBegan) ++floods;
  const double hours = std::clamp(watch_.runningS() / 3600, 1.0 / 6, 24.0);
  const double mean = static_cast<double>(watch_.rates().day) / (6 * hours);
  struct Row {
    QString what, value;
    bool fine;
  };
  const Row rows[] = {
      {tr("Mean per 10 minutes"), tr("%1, target below 1").arg(numberText(mean, 2)), mean < 1 || hours < 1},
      {tr("Floods"), QString::number(floods), floods == 0},
      {tr("Comes and goes"), chattering == 0 ? QStringLiteral("0") : tr("%1: %2").arg(chattering).arg(which),
       chattering == 0},
      {tr("On for more than a day"), QString::number(stale), stale == 0}};
  const Palette& p = place_.theme.palette();
  for (int i = 0; i < 4; ++i) {
    QPixmap sign(36, 36);
    sign.setDevicePixelRatio(2);
    sign.fill(Qt::transparent);
    QPainter painter(&sign);
    painter.setRenderHint(QPainter::Antialiasing);
    paintSymbol(painter, QRectF(0, 0, 18, 18), rows[i].fine ? StateSymbol::Good : StateSymbol::Near, p);
    painter.end();
    auto* what = new QTableWidgetItem(QIcon(sign), rows[i].what);
    auto* value = new QTableWidgetItem(rows[i].value);
    value->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    value->setToolTip(rows[i].value);
    health_->setItem(i, 0, what);
    health_->setItem(i, 1, value);
  }
  health_->setColumnWidth(0, health_->viewport()->width() * 55 / 100);
}

void AlarmsPage::shelve() {
  const QStringList key = what_->currentData().toString().split('\n');
  if (key.size() != 2) return;
  const auto done = watch_.shelve({key[0].toStdString(), key[1].toStdString()}, reason_->text().trimmed().toStdString(),
                                  std::chrono::minutes(minutes_->currentData().toInt()));
  if (done) reason_->clear();
  limit_->setText(done ? tr("An operator may shelve for %1 minutes at most.").arg(kOperatorsMinutes)
                  : reason_->text().trimmed().isEmpty() ? tr("Shelving needs a reason.")
                                                        : shown(done.error().message()));
}

}  // namespace vignole
