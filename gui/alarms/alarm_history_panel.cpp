#include "gui/alarms/alarm_history_panel.h"

#include <QAbstractButton>
#include <QButtonGroup>
#include <QDateTime>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSaveFile>
#include <QTableWidget>
#include <QVBoxLayout>

#include "gui/alarms/alarm_card.h"
#include "gui/alarms/alarm_words.h"
#include "gui/theme/inscription.h"
#include "gui/theme/theme.h"
#include "report/engine_words.h"

namespace vignole {

namespace {

constexpr int kRows = 200;

QString shown(const std::string& text) { return QString::fromStdString(text); }
QDateTime local(TimeUs timeUs) { return QDateTime::fromMSecsSinceEpoch(timeUs / 1000); }
QString csvField(QString text) { return '"' + text.replace('"', QStringLiteral("\"\"")) + '"'; }

/// Today's time alone, else with its day.
QString clockText(const QDateTime& time) {
  const bool today = time.date() == QDate::currentDate();
  return time.toString(today ? QStringLiteral("HH:mm:ss") : QStringLiteral("yyyy-MM-dd HH:mm"));
}

std::vector<std::string> detailsOf(const AlarmRecord& alarm) {
  std::vector<std::string> details;
  for (const QString& part : shown(alarm.details).split(QStringLiteral("; "), Qt::SkipEmptyParts))
    details.push_back(part.toStdString());
  return details;
}

QString titleOf(const AlarmRecord& alarm, const AlarmBook& book) {
  const AlarmRule* rule = book.rule(alarm.rule);
  return rule != nullptr ? alarmTitle(*rule, alarm.source, detailsOf(alarm))
                         : shown(alarm.cause) + QStringLiteral(" ") + shown(alarm.source);
}

QTableWidgetItem* cell(const QString& text) {
  auto* item = new QTableWidgetItem(text);
  item->setToolTip(text);
  return item;
}

}  // namespace

AlarmHistoryPanel::AlarmHistoryPanel(const Theme& theme, AlarmWatch& watch, QWidget* parent)
    : Panel(parent), theme_(theme), watch_(watch), which_(new QButtonGroup(this)) {
  auto* segments = new QHBoxLayout;
  segments->setSpacing(0);
  for (int i = 0; i < 2; ++i) {
    auto* button = new QPushButton(this);
    button->setObjectName(QStringLiteral("segment"));
    button->setCheckable(true);
    button->setFont(uiFont(16, 500));
    button->setMinimumWidth(112);
    which_->addButton(button, i);
    segments->addWidget(button);
  }
  which_->button(0)->setChecked(true);
  head()->addLayout(segments);
  head()->addSpacing(8);
  export_ = makeButton(theme, QStringLiteral("export"), this);
  head()->addWidget(export_);
  alarms_ = new QTableWidget(0, 6, this);
  events_ = new QTableWidget(0, 3, this);
  for (QTableWidget* table : {alarms_, events_}) {
    styleTable(*table);
    content()->addWidget(table, 1);
  }
  alarms_->setIconSize({20, 20});
  events_->hide();
  connect(which_, &QButtonGroup::idClicked, this, [this](int id) {
    alarms_->setVisible(id == 0);
    events_->setVisible(id == 1);
    refresh();
  });
  connect(export_, &QPushButton::clicked, this, &AlarmHistoryPanel::askAndExport);
}

void AlarmHistoryPanel::retranslate() {
  setTitle(tr("What happened"));
  which_->button(0)->setText(tr("Alarms"));
  which_->button(0)->setAccessibleName(tr("Show the alarms that came and went"));
  which_->button(1)->setText(tr("Events"));
  which_->button(1)->setAccessibleName(tr("Show events"));
  export_->setText(tr("Export…"));
  export_->setAccessibleName(tr("Export as CSV"));
  alarms_->setHorizontalHeaderLabels({tr("Came"), tr("Went"), tr("Lasted"), tr("Alarm"), tr("Details"), tr("By")});
  alarms_->setAccessibleName(tr("Alarms that came and went, newest first"));
  events_->setHorizontalHeaderLabels({tr("Time"), tr("Event"), tr("By")});
  events_->setAccessibleName(tr("Events, newest first"));
  refresh();
}

void AlarmHistoryPanel::refresh() {
  if (which_->checkedId() == 0)
    showAlarms();
  else
    showEvents();
  shareWidth();
}

void AlarmHistoryPanel::showAlarms() {
  const std::vector<AlarmRecord> all = watch_.log().history();
  const int rows = std::min(kRows, static_cast<int>(all.size()));
  const int ofThisStart = static_cast<int>(watch_.log().ofThisStart());
  alarms_->setRowCount(rows);
  for (int i = 0; i < rows; ++i) {
    const AlarmRecord& a = all[static_cast<std::size_t>(i)];
    auto* came = cell(clockText(local(a.raisedUs)));
    came->setIcon(priorityPixmap(static_cast<AlarmPriority>(std::clamp(a.priority, 1, 3)), theme_.palette(), 20));
    alarms_->setItem(i, 0, came);
    alarms_->setItem(i, 1,
                     cell(a.clearedUs       ? clockText(local(*a.clearedUs))
                          : i < ofThisStart ? tr("still on")
                                            : tr("program ended")));
    alarms_->setItem(i, 2, cell(a.clearedUs ? age(static_cast<double>(*a.clearedUs - a.raisedUs) * 1e-6) : QString()));
    alarms_->setItem(i, 3, cell(titleOf(a, watch_.book())));
    QStringList details;
    for (const std::string& detail : detailsOf(a)) details << inWords(detail);
    if (!a.shelvingReason.empty()) details << tr("shelved: %1").arg(shown(a.shelvingReason));
    alarms_->setItem(i, 4, cell(details.join(QStringLiteral("; "))));
    alarms_->setItem(i, 5, cell(a.acknowledgedUs ? personWord(a.acknowledgedBy) : tr("nobody yet")));
  }
  setNote(all.empty() ? tr("no alarm so far") : tr("%n alarm(s)", nullptr, static_cast<int>(all.size())));
  export_->setEnabled(!all.empty());
}

void AlarmHistoryPanel::showEvents() {
  const auto& all = watch_.log().events();
  const int rows = std::min(kRows, static_cast<int>(all.size()));
  events_->setRowCount(rows);
  for (int i = 0; i < rows; ++i) {
    const EventRecord& e = all[static_cast<std::size_t>(i)];
    events_->setItem(i, 0, cell(clockText(local(e.timeUs))));
    events_->setItem(i, 1, cell(inWords(e.text)));
    events_->setItem(i, 2, cell(personWord(e.user)));
  }
  setNote(all.empty() ? tr("no event so far") : tr("%n event(s)", nullptr, static_cast<int>(all.size())));
  export_->setEnabled(!all.empty());
}

void AlarmHistoryPanel::shareWidth() {
  const int wide = alarms_->isVisibleTo(this) ? alarms_->viewport()->width() : events_->viewport()->width();
  const int ofAlarms[] = {15, 11, 11, 32, 20}, ofEvents[] = {18, 62};
  for (int column = 0; column < 5; ++column) alarms_->setColumnWidth(column, wide * ofAlarms[column] / 100);
  for (int column = 0; column < 2; ++column) events_->setColumnWidth(column, wide * ofEvents[column] / 100);
}

void AlarmHistoryPanel::resizeEvent(QResizeEvent* event) {
  Panel::resizeEvent(event);
  shareWidth();
}

Expected<void> AlarmHistoryPanel::exportTo(const QString& name) const {
  // Times in UTC and rules in English: this is for programs.
  const auto time = [](std::optional<TimeUs> us) {
    return us ? QDateTime::fromMSecsSinceEpoch(*us / 1000).toUTC().toString(Qt::ISODateWithMs) : QString();
  };
  QString text;
  if (which_->checkedId() == 0) {
    text = QStringLiteral(
        "came,went,acknowledged,acknowledged_by,rule,source,priority,rail,details,shelved_by,shelving_reason\n");
    for (const AlarmRecord& a : watch_.log().history())
      text += QStringList{time(a.raisedUs),
                          time(a.clearedUs),
                          time(a.acknowledgedUs),
                          csvField(shown(a.acknowledgedBy)),
                          shown(a.rule),
                          csvField(shown(a.source)),
                          QString::number(a.priority),
                          csvField(shown(a.rail)),
                          csvField(shown(a.details)),
                          csvField(shown(a.shelvedBy)),
                          csvField(shown(a.shelvingReason))}
                  .join(',') +
              '\n';
  } else {
    text = QStringLiteral("time,source,event,by\n");
    for (const EventRecord& e : watch_.log().events())
      text +=
          QStringList{time(e.timeUs), csvField(shown(e.source)), csvField(shown(e.text)), csvField(shown(e.user))}.join(
              ',') +
          '\n';
  }
  QSaveFile file(name);
  if (!file.open(QIODevice::WriteOnly) || file.write(text.toUtf8()) < 0 || !file.commit())
    return worldError(name.toStdString(), file.errorString().toStdString());
  return {};
}

void AlarmHistoryPanel::askAndExport() {
  const QString name = QFileDialog::getSaveFileName(this, tr("Export as CSV"), QStringLiteral("alarms.csv"),
                                                    QStringLiteral("CSV (*.csv)"));
  if (name.isEmpty()) return;
  const auto done = exportTo(name);
  setNote(done ? tr("%1 is written").arg(name) : tr("%1 cannot be written: %2").arg(name, shown(done.error().what)));
}

}  // namespace vignole
