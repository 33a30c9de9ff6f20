#include "gui/rails/rails_page.h"

#include <QComboBox>
#include <QDateTime>
#include <QEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QShortcut>
#include <QTableWidget>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/rail/catalogue.h"
#include "gui/bridge/archive_reader.h"
#include "gui/plots/strip_chart.h"
#include "gui/rails/next_rail_dialog.h"
#include "gui/rails/rail_band.h"
#include "gui/rails/rail_export.h"
#include "gui/rails/replay_canvas.h"
#include "gui/rails/what_if_dialog.h"
#include "gui/theme/inscription.h"
#include "gui/theme/panel.h"
#include "gui/theme/state_icon.h"
#include "report/dimension_text.h"
#include "report/engine_words.h"
#include "report/rail_report.h"

namespace vignole {

namespace {

constexpr std::size_t kMostFound = 500;
constexpr int kTypingMs = 250, kPlayMs = 66;

QString shown(const std::string& text) { return QString::fromStdString(text); }
QDateTime local(TimeUs time) { return QDateTime::fromMSecsSinceEpoch(time / 1000); }

QTableWidgetItem* cell(const QString& text, bool right = false) {
  auto* item = new QTableWidgetItem(text);
  item->setTextAlignment((right ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  return item;
}

struct RailException {
  Dimension dimension;
  DimensionException stretch;
};

std::vector<RailException> exceptionsOf(const RailSummary& summary) {
  std::vector<RailException> all;
  for (const DimensionSummary& d : summary.dimensions)
    for (const DimensionException& e : d.exceptions) all.push_back({d.dimension, e});
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.stretch.fromM < b.stretch.fromM; });
  return all;
}

constexpr qint64 kDayUs = 86'400'000'000;
constexpr std::array<int, 4> kPeriodDays = {1, 7, 28, 365};

}  // namespace

RailsPage::RailsPage(Workplace& place, QWidget* parent)
    : Page(parent), place_(place), reader_(std::make_unique<ArchiveReader>(place.archive ? place.archiveUrl : "")) {
  setObjectName(QStringLiteral("page"));
  setFocusPolicy(Qt::ClickFocus);
  typing_ = new QTimer(this);
  typing_->setSingleShot(true);
  typing_->setInterval(kTypingMs);
  connect(typing_, &QTimer::timeout, this, &RailsPage::search);
  playing_ = new QTimer(this);
  playing_->setInterval(kPlayMs);
  connect(playing_, &QTimer::timeout, this, [this] { step(1); });

  auto* row = new QHBoxLayout(this);
  row->addWidget(makeList(), 5);
  row->addWidget(makeReplay(), 11);
  bindKeys();
  retranslate();
  connect(&place_.theme, &Theme::changed, this, [this] {
    if (!found_.empty()) showFound(found_, found_.size());
    if (opened_) showOpened(opened_);
  });
}

RailsPage::~RailsPage() { reader_.reset(); }

QWidget* RailsPage::makeList() {
  list_ = new Panel(this);
  text_ = new QLineEdit(list_);
  text_->setFont(uiFont(16));
  text_->setClearButtonEnabled(true);
  connect(text_, &QLineEdit::textChanged, typing_, qOverload<>(&QTimer::start));
  nextRail_ = makeButton(place_.theme, QStringLiteral("add"), list_);
  nextRail_->setVisible(place_.line.announcements() != nullptr);
  connect(nextRail_, &QPushButton::clicked, this, &RailsPage::enterNextRail);
  list_->head()->addWidget(nextRail_);
  whatIf_ = makeButton(place_.theme, QString(), list_);
  whatIf_->setEnabled(false);
  connect(whatIf_, &QPushButton::clicked, this, &RailsPage::askWhatIf);
  auto* searchRow = new QHBoxLayout;
  searchRow->addWidget(text_, 1);
  searchRow->addWidget(whatIf_);
  auto* filters = new QGridLayout;
  verdict_ = new QComboBox(list_);
  dimension_ = new QComboBox(list_);
  period_ = new QComboBox(list_);
  section_ = new QComboBox(list_);
  int place = 0;
  for (QComboBox* box : {verdict_, dimension_, period_, section_}) {
    box->setFont(uiFont(16));
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(8);
    filters->addWidget(box, place / 2, place % 2);
    ++place;
    connect(box, &QComboBox::currentIndexChanged, this, &RailsPage::search);
  }
  table_ = new QTableWidget(0, 5, list_);
  styleTable(*table_);
  table_->setIconSize({20, 20});
  connect(table_, &QTableWidget::itemSelectionChanged, this, [this] {
    const int chosen = table_->currentRow();
    if (chosen >= 0 && chosen < static_cast<int>(found_.size()) && !table_->selectedItems().isEmpty())
      openRail(found_[static_cast<std::size_t>(chosen)].key);
  });
  empty_ = makeLabel(16, 400, "t2", list_, true);
  clear_ = makeButton(place_.theme, QStringLiteral("reject"), list_);
  clear_->hide();
  connect(clear_, &QPushButton::clicked, this, &RailsPage::clearFilters);
  writer_ = makeLabel(14, 400, "t2", list_, true);
  auto* buttons = new QHBoxLayout;
  report_ = makeButton(place_.theme, QStringLiteral("report"), list_);
  export_ = makeButton(place_.theme, QStringLiteral("export"), list_);
  connect(report_, &QPushButton::clicked, this, [this] { save(true); });
  connect(export_, &QPushButton::clicked, this, [this] { save(false); });
  for (QPushButton* b : {report_, export_}) {
    b->setEnabled(false);
    buttons->addWidget(b, 1);
  }
  list_->content()->addLayout(searchRow);
  list_->content()->addLayout(filters);
  list_->content()->addWidget(table_, 1);
  list_->content()->addWidget(empty_);
  list_->content()->addWidget(clear_);
  list_->content()->addWidget(writer_);
  list_->content()->addLayout(buttons);
  return list_;
}

QWidget* RailsPage::makeReplay() {
  auto* side = new QWidget(this);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  replayColumn_ = column;
  auto* banner = new QFrame(side);
  banner->setObjectName(QStringLiteral("banner"));
  auto* bannerRow = new QHBoxLayout(banner);
  bannerRow->setContentsMargins(16, 6, 6, 6);
  band_ = makeLabel(18, 500, "t1", banner);
  band_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  live_ = makeButton(place_.theme, QStringLiteral("monitor"), banner);
  connect(live_, &QPushButton::clicked, this, &RailsPage::liveAsked);
  bannerRow->addWidget(band_, 1);
  bannerRow->addWidget(live_);
  column->addWidget(banner);

  auto* middle = new QHBoxLayout;
  middle->setSpacing(8);
  drawing_ = new Panel(side);
  canvas_ = new ReplayCanvas(place_.theme, drawing_);
  drawing_->content()->addWidget(canvas_, 1);
  along_ = new Panel(side);
  for (StripChart*& strip : strips_) {
    strip = new StripChart(place_.theme, along_);
    along_->content()->addWidget(strip, 1);
    strip->hide();
  }
  middle->addWidget(drawing_, 1);
  middle->addWidget(along_, 1);
  column->addLayout(middle, 1);

  scrub_ = new Panel(side);
  auto* scrubRow = new QHBoxLayout;
  back_ = makeButton(place_.theme, QStringLiteral("stepback"), scrub_);
  playButton_ = makeButton(place_.theme, QStringLiteral("play"), scrub_);
  playButton_->setCheckable(true);
  forward_ = makeButton(place_.theme, QStringLiteral("step"), scrub_);
  connect(back_, &QPushButton::clicked, this, [this] { nextException(true); });
  connect(forward_, &QPushButton::clicked, this, [this] { nextException(false); });
  connect(playButton_, &QPushButton::toggled, this, &RailsPage::play);
  positionLabel_ = makeLabel(20, 500, "t1", scrub_);
  positionLabel_->setMinimumWidth(120);
  railBand_ = new RailBand(place_.theme, scrub_);
  connect(railBand_, &RailBand::positionAsked, this, &RailsPage::goTo);
  drawn_ = new QComboBox(scrub_);
  drawn_->setFont(uiFont(16));
  for (int i = 0; i <= static_cast<int>(kDimensionCount); ++i) drawn_->addItem(QString());
  before_ = makeButton(place_.theme, QStringLiteral("compare"), scrub_);
  before_->setCheckable(true);
  connect(drawn_, &QComboBox::currentIndexChanged, this, [this] {
    if (shown_) showProfile(StoredProfile(*shown_));
  });
  connect(before_, &QPushButton::toggled, canvas_, &ReplayCanvas::setBeforeRegistration);
  for (QPushButton* b : {back_, playButton_, forward_}) {
    b->setFixedWidth(52);
    scrubRow->addWidget(b);
  }
  scrubRow->addWidget(positionLabel_);
  scrubRow->addWidget(railBand_, 1);
  scrubRow->addWidget(drawn_);
  scrubRow->addWidget(before_);
  scrub_->content()->addLayout(scrubRow);
  column->addWidget(scrub_);

  exceptions_ = new Panel(side);
  exceptionTable_ = new QTableWidget(0, 4, exceptions_);
  styleTable(*exceptionTable_);
  exceptionTable_->setIconSize({18, 18});
  exceptionTable_->setMinimumHeight(60);
  connect(exceptionTable_, &QTableWidget::itemSelectionChanged, this, [this] {
    const int chosen = exceptionTable_->currentRow();
    if (!opened_ || chosen < 0 || exceptionTable_->selectedItems().isEmpty()) return;
    const auto all = exceptionsOf(opened_->stored.summary);
    if (static_cast<std::size_t>(chosen) >= all.size()) return;
    const RailException& e = all[static_cast<std::size_t>(chosen)];
    goTo((e.stretch.fromM + e.stretch.toM) / 2);
  });
  exceptions_->content()->addWidget(exceptionTable_);
  exceptions_->setMaximumHeight(190);
  column->addWidget(exceptions_);
  return side;
}

void RailsPage::bindKeys() {
  const auto bind = [this](const QKeySequence& key, auto action) {
    auto* shortcut = new QShortcut(key, this);
    shortcut->setContext(Qt::WidgetWithChildrenShortcut);
    connect(shortcut, &QShortcut::activated, this, action);
  };
  bind(QKeySequence(Qt::CTRL | Qt::Key_F), [this] { text_->setFocus(); });
  bind(QKeySequence(Qt::Key_Right), [this] { step(1); });
  bind(QKeySequence(Qt::Key_Left), [this] { step(-1); });
  const auto metre = [this](int sign) {
    if (shown_) goTo(shown_->record.positionMm / 1000 + sign);
  };
  bind(QKeySequence(Qt::SHIFT | Qt::Key_Right), [metre] { metre(1); });
  bind(QKeySequence(Qt::SHIFT | Qt::Key_Left), [metre] { metre(-1); });
  bind(QKeySequence(Qt::Key_Home), [this] { goTo(0); });
  bind(QKeySequence(Qt::Key_End), [this] {
    if (opened_) goTo(opened_->stored.summary.lengthM);
  });
  bind(QKeySequence(Qt::Key_N), [this] { nextException(false); });
  bind(QKeySequence(Qt::SHIFT | Qt::Key_N), [this] { nextException(true); });
  bind(QKeySequence(Qt::Key_P), [this] { playButton_->toggle(); });
  bind(QKeySequence(Qt::CTRL | Qt::Key_E), [this] { save(false); });
  bind(QKeySequence(Qt::CTRL | Qt::Key_P), [this] { save(true); });
  bind(QKeySequence(Qt::Key_Escape), [this] { emit liveAsked(); });
}

void RailsPage::retranslate() {
  list_->setTitle(tr("Rails"));
  drawn_->setItemText(0, tr("Worst"));
  for (std::size_t i = 0; i < kDimensionCount; ++i)
    drawn_->setItemText(static_cast<int>(i) + 1, spoken(kDimensions[i]));
  drawn_->setAccessibleName(tr("Dimension that is drawn"));
  before_->setAccessibleName(tr("Show the points before registration"));
  before_->setToolTip(tr("Show the points before registration"));
  text_->setPlaceholderText(tr("Rail or heat, from its beginning"));
  text_->setAccessibleName(tr("Search by rail or heat"));
  const int verdict = std::max(0, verdict_->currentIndex()), dimension = std::max(0, dimension_->currentIndex());
  {
    const QSignalBlocker quietVerdict(verdict_), quietDimension(dimension_);
    verdict_->clear();
    verdict_->addItems({tr("Any verdict"), tr("Out of tolerance"), tr("Near limit"), tr("Good"), tr("Not measured")});
    verdict_->setCurrentIndex(verdict);
    dimension_->clear();
    dimension_->addItem(tr("Any dimension"));
    for (const Dimension d : kDimensions) dimension_->addItem(tr("%1 out").arg(spoken(d)));
    dimension_->setCurrentIndex(dimension);
  }
  const int period = std::max(0, period_->currentIndex()), section = std::max(0, section_->currentIndex());
  {
    const QSignalBlocker quietPeriod(period_), quietSection(section_);
    period_->clear();
    period_->addItems({tr("Any time"), tr("Today"), tr("7 days"), tr("4 weeks"), tr("12 months")});
    period_->setCurrentIndex(period);
    section_->clear();
    section_->addItem(tr("Any section"));
    for (const std::string& name : catalogueNames()) section_->addItem(shown(name));
    section_->setCurrentIndex(section);
  }
  period_->setAccessibleName(tr("Time"));
  section_->setAccessibleName(tr("Section"));
  clear_->setText(tr("Clear"));
  clear_->setAccessibleName(tr("Clear search and filters"));
  whatIf_->setText(tr("What if…"));
  whatIf_->setAccessibleName(tr("Judge the rails found with other limits"));
  nextRail_->setText(tr("Next rail…"));
  nextRail_->setAccessibleName(tr("Enter the papers of the next rail"));
  verdict_->setAccessibleName(tr("Verdict"));
  dimension_->setAccessibleName(tr("Dimension out of tolerance"));
  table_->setHorizontalHeaderLabels({tr("Verdict"), tr("Rail"), tr("Heat"), tr("Worst"), tr("Time")});
  table_->setAccessibleName(tr("Rails found"));
  report_->setText(tr("Report…"));
  export_->setText(tr("Export…"));
  report_->setAccessibleName(tr("Report as PDF"));
  export_->setAccessibleName(tr("Export as CSV or JSON"));
  report_->setToolTip(tr("Report as PDF (Ctrl+P)"));
  export_->setToolTip(tr("Export as CSV or JSON (Ctrl+E)"));
  live_->setText(tr("Back to live"));
  live_->setAccessibleName(tr("Back to live"));
  along_->setTitle(tr("Along the rail"));
  exceptions_->setTitle(tr("Exceptions"));
  exceptionTable_->setHorizontalHeaderLabels({tr("Dimension"), tr("From – to, m"), tr("Worst, mm"), tr("Limits, mm")});
  exceptionTable_->setAccessibleName(tr("Stretches out of tolerance"));
  back_->setAccessibleName(tr("Previous exception"));
  back_->setToolTip(tr("Previous exception (Shift+N)"));
  forward_->setAccessibleName(tr("Next exception"));
  forward_->setToolTip(tr("Next exception (N)"));
  playButton_->setAccessibleName(tr("Play along the rail"));
  playButton_->setToolTip(tr("Play or pause (P)"));
  if (opened_)
    showOpened(opened_);
  else {
    drawing_->setTitle(tr("Profile"));
    band_->setText(tr("No rail is open"));
    canvas_->setMessage(
        tr("Choose a rail in the list: its profile, its dimensions along the rail and its exceptions "
           "are shown here."));
    positionLabel_->setText(QStringLiteral("–"));
  }
}

void RailsPage::changeEvent(QEvent* event) {
  Page::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

void RailsPage::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  const bool low = height() < 760;
  const int gap = low || width() < 1600 ? 8 : 16;
  layout()->setContentsMargins(gap, gap, gap, gap);
  layout()->setSpacing(gap);
  replayColumn_->setSpacing(gap);
  stripsShown_ = low ? 2 : strips_.size();
  exceptions_->setMaximumHeight(low ? 140 : 190);
  if (opened_) showStrips();
}

void RailsPage::showEvent(QShowEvent* event) {
  Page::showEvent(event);
  search();
}

void RailsPage::showLine(const LineSnapshot& line, PullDetail detail) {
  if (detail != PullDetail::Everything) return;
  showWriter();
  if (nextRailDialog_ != nullptr && nextRailDialog_->isVisible()) nextRailDialog_->refresh();
  if (line.railsPassed == railsPassed_) return;
  railsPassed_ = line.railsPassed;
  QTimer::singleShot(1500, this, &RailsPage::search);  // the writer needs a moment
}

void RailsPage::showWriter() {
  if (place_.writer == nullptr) {
    writer_->setText(place_.archive != nullptr ? tr("Nothing new is kept: nobody writes into this archive.")
                                               : tr("Nothing is kept. Live rails are shown on Monitor only."));
    return;
  }
  const RailWriterStatus status = place_.writer->status();
  QString words =
      tr("kept since the start: %1 rails; %2 profiles wait").arg(count(status.railsStored), count(status.queued));
  if (status.profilesLost > 0) words += tr("; %1 profiles lost").arg(count(status.profilesLost));
  if (status.pointsDropped > 0) words += tr("; points of %1 profiles left out").arg(count(status.pointsDropped));
  writer_->setText(status.failure.empty()
                       ? words
                       : tr("Nothing can be written: %1. What passes waits in memory.").arg(shown(status.failure)) +
                             QChar(u' ') + words);
}

void RailsPage::enterNextRail() {
  if (place_.line.announcements() == nullptr) return;
  if (nextRailDialog_ == nullptr)
    nextRailDialog_ = new NextRailDialog(place_.theme, *place_.line.announcements(), this);
  nextRailDialog_->show();
}

void RailsPage::askWhatIf() {
  if (!opened_ || !opened_->recipe) return;
  if (whatIfDialog_ == nullptr) whatIfDialog_ = new WhatIfDialog(place_, *reader_, this);
  std::vector<RailLine> rails;
  for (const RailLine& rail : found_)
    if (rail.section == opened_->recipe->section.name && rail.state == RailState::Finished) rails.push_back(rail);
  whatIfDialog_->setRails(*opened_->recipe, std::move(rails));
  whatIfDialog_->show();
}

bool RailsPage::filtered() const {
  const auto set = [](const QComboBox* box) { return box->currentIndex() > 0; };
  return !text_->text().trimmed().isEmpty() || set(verdict_) || set(dimension_) || set(period_) || set(section_);
}

void RailsPage::clearFilters() {
  {
    const QSignalBlocker a(text_), b(verdict_), c(dimension_), d(period_), e(section_);
    text_->clear();
    for (QComboBox* box : {verdict_, dimension_, period_, section_}) box->setCurrentIndex(0);
  }
  text_->setFocus();
  search();
}

RailQuery RailsPage::query() const {
  RailQuery query;
  query.limit = kMostFound;
  const std::vector<Verdict> verdicts = {Verdict::Fail, Verdict::Near, Verdict::Pass, Verdict::NotMeasured};
  if (const int i = verdict_->currentIndex(); i > 0) query.verdicts = {verdicts[static_cast<std::size_t>(i - 1)]};
  if (const int i = dimension_->currentIndex(); i > 0) {
    DimensionQuery dimension;
    dimension.dimension = static_cast<Dimension>(i - 1);
    dimension.excessAboveMm = 0;
    query.dimensions.push_back(dimension);
  }
  query.railId = text_->text().trimmed().toStdString();
  if (const int i = period_->currentIndex(); i == 1)
    query.fromUs = QDate::currentDate().startOfDay().toMSecsSinceEpoch() * 1000;
  else if (i > 1)
    query.fromUs = systemTimeUs() - kPeriodDays[static_cast<std::size_t>(i - 1)] * kDayUs;
  if (section_->currentIndex() > 0) query.section = section_->currentText().toStdString();
  return query;
}

void RailsPage::search() {
  RailQuery wanted = query();
  reader_->ask("search", [this, wanted](const Archive* archive, const std::string& problem) -> ArchiveReader::Answer {
    if (archive == nullptr)
      return [this, problem] {
        showFound({}, 0);
        empty_->setText(
            tr("Rails are not kept: %1. Start the program with an archive (--archive FILE).").arg(inWords(problem)));
      };
    const RailArchive rails(*archive);
    auto found = rails.search(wanted);
    // The same words may be those of a heat.
    if (found && found->empty() && !wanted.railId.empty()) {
      RailQuery byHeat = wanted;
      std::swap(byHeat.heat, byHeat.railId);
      found = rails.search(byHeat);
    }
    const auto all = rails.count();
    if (!found) return [this, error = found.error()] { empty_->setText(shown(error.message())); };
    return [this, found = std::move(*found), n = all ? *all : 0] { showFound(found, n); };
  });
}

void RailsPage::showFound(std::vector<RailLine> found, std::uint64_t all) {
  found_ = std::move(found);
  const Palette& p = place_.theme.palette();
  const QSignalBlocker quiet(table_);
  table_->setRowCount(static_cast<int>(found_.size()));
  int chosen = -1;
  for (int i = 0; i < static_cast<int>(found_.size()); ++i) {
    const RailLine& rail = found_[static_cast<std::size_t>(i)];
    auto* verdict = cell(rail.state == RailState::Running ? tr("running") : wordOf(rail.verdict));
    verdict->setIcon(stateIcon(rail.state == RailState::Running ? StateSymbol::Measuring : symbolOf(rail.verdict), p));
    table_->setItem(i, 0, verdict);
    table_->setItem(i, 1, cell(shown(rail.id)));
    table_->setItem(i, 2, cell(shown(rail.heat)));
    table_->setItem(
        i, 3,
        cell(!rail.worst               ? QStringLiteral("–")
             : rail.worstExcessMm <= 0 ? spoken(*rail.worst)
                                       : spoken(*rail.worst) + QChar(u' ') + deviationText(rail.worstExcessMm, 2)));
    table_->item(i, 3)->setToolTip(!rail.worst               ? QString()
                                   : rail.worstExcessMm <= 0 ? tr("nearest to a limit, inside")
                                                             : tr("furthest beyond a limit, mm"));
    const QDateTime time = local(rail.beganUs);
    const QDate today = QDate::currentDate();
    const char* format = time.date() == today                 ? "HH:mm:ss"
                         : time.date().year() == today.year() ? "MM-dd HH:mm"
                                                              : "yyyy-MM-dd";
    table_->setItem(i, 4, cell(time.toString(QLatin1String(format))));
    table_->item(i, 4)->setToolTip(time.toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")));
    if (opened_ && opened_->stored.key == rail.key) chosen = i;
  }
  // Where there is little room the heat goes: it is searched for, and stands in the report.
  const int wide = table_->viewport()->width();
  const bool narrow = wide < 460;
  table_->setColumnHidden(2, narrow);
  const std::array<int, 4> shares = narrow ? std::array{38, 22, 0, 17} : std::array{28, 19, 16, 18};
  for (int column = 0; column < 4; ++column)
    table_->setColumnWidth(column, wide * shares[static_cast<std::size_t>(column)] / 100);
  if (chosen >= 0) table_->selectRow(chosen);
  list_->setNote(tr("%1 of %2").arg(count(found_.size()), count(std::max<std::uint64_t>(all, found_.size()))));
  empty_->setVisible(found_.empty());
  clear_->setVisible(found_.empty() && filtered());
  if (found_.empty())
    empty_->setText(filtered() ? tr("No rail is like that. Clear the search or choose other filters.")
                               : tr("No rail has been measured yet. Rails appear here when they have passed."));
  // Nobody has chosen yet: the newest rail that has passed.
  if (!opened_)
    for (const RailLine& rail : found_)
      if (rail.state != RailState::Running) {
        openRail(rail.key);
        break;
      }
  emit listChanged();
}

void RailsPage::openRail(std::int64_t key) {
  reader_->ask("open", [this, key](const Archive* archive, const std::string& problem) -> ArchiveReader::Answer {
    if (archive == nullptr) return [this, problem] { canvas_->setMessage(inWords(problem)); };
    auto rail = vignole::openRail(*archive, key);
    if (!rail) return [this, error = rail.error()] { canvas_->setMessage(shown(error.message())); };
    return [this, opened = std::make_shared<const OpenedRail>(std::move(*rail))] {
      number_ = 0;
      shown_.reset();
      showOpened(opened);
      askProfile();
    };
  });
}

void RailsPage::showOpened(std::shared_ptr<const OpenedRail> rail) {
  opened_ = std::move(rail);
  const StoredRail& stored = opened_->stored;
  const RailSummary& summary = stored.summary;
  const Palette& p = place_.theme.palette();
  band_->setText(tr("Replay: not live.  Rail %1, %2 to %3, recipe %4, calibration %5")
                     .arg(shown(summary.rail.id), local(stored.beganUs).toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")),
                          local(stored.endedUs).toString(QStringLiteral("HH:mm:ss")), shown(summary.recipe),
                          shown(summary.calibrationId)));
  band_->setToolTip(band_->text());
  report_->setEnabled(true);
  export_->setEnabled(true);
  whatIf_->setEnabled(opened_->recipe.has_value());
  const auto all = exceptionsOf(summary);
  const QSignalBlocker quiet(exceptionTable_);
  exceptionTable_->clearSelection();
  exceptionTable_->setRowCount(static_cast<int>(all.size()));
  QVector<BandStretch> stretches;
  for (int i = 0; i < static_cast<int>(all.size()); ++i) {
    const RailException& e = all[static_cast<std::size_t>(i)];
    const DimensionSummary& d = summary.dimensions[index(e.dimension)];
    auto* dimension = cell(spoken(e.dimension));
    dimension->setIcon(stateIcon(StateSymbol::Out, p));
    exceptionTable_->setItem(i, 0, dimension);
    exceptionTable_->setItem(i, 1,
                             cell(QStringLiteral("%1 – %2").arg(locale().toString(e.stretch.fromM, 'f', 2),
                                                                locale().toString(e.stretch.toM, 'f', 2))));
    exceptionTable_->setItem(i, 2, cell(numberText(e.stretch.worstMm, decimalsOf(e.dimension))));
    const auto limit = [&](const std::optional<double>& l) {
      return l ? numberText(*l, decimalsOf(e.dimension)) : QStringLiteral("–");
    };
    exceptionTable_->setItem(i, 3, cell(QStringLiteral("%1 … %2").arg(limit(d.lowerMm), limit(d.upperMm))));
    stretches.append({e.stretch.fromM, e.stretch.toM, StateSymbol::Out});
  }
  exceptions_->setNote(all.empty() ? tr("none: every dimension stayed within its limits")
                                   : tr("%n stretch(es)", nullptr, static_cast<int>(all.size())));
  for (int column = 0; column < 3; ++column)
    exceptionTable_->setColumnWidth(column, exceptionTable_->viewport()->width() / 4);
  railBand_->setRail(summary.lengthM, stretches);
  // The three dimensions that are worst, or nearest to a limit.
  std::vector<std::pair<double, Dimension>> order;
  for (const Dimension d : kDimensions)
    if (const auto& excess = stored.excessMm[index(d)]) order.emplace_back(-*excess, d);
  std::sort(order.begin(), order.end());
  stripDimensions_.clear();
  for (std::size_t i = 0; i < std::min(order.size(), strips_.size()); ++i) stripDimensions_.push_back(order[i].second);
  if (!opened_->recipe) canvas_->setMessage(tr("The profile cannot be drawn: %1.").arg(shown(opened_->recipeProblem)));
  showStrips();
  if (shown_) showProfile(*shown_);
}

void RailsPage::askProfile() {
  if (!opened_) return;
  reader_->ask("profile",
               [this, rail = opened_, number = number_](const Archive* archive,
                                                        const std::string& problem) -> ArchiveReader::Answer {
                 if (archive == nullptr) return [this, problem] { canvas_->setMessage(inWords(problem)); };
                 auto profile = storedProfile(*archive, *rail, number);
                 if (!profile) return [this, error = profile.error()] { drawing_->setNote(shown(error.message())); };
                 return [this, rail, profile = std::move(*profile)] {
                   if (rail == opened_ && profile.number == number_) showProfile(profile);
                 };
               });
}

void RailsPage::showProfile(const StoredProfile& profile) {
  shown_ = profile;
  const double positionM = profile.record.positionMm / 1000;
  positionLabel_->setText(tr("%1 m").arg(locale().toString(positionM, 'f', 3)));
  railBand_->setPosition(positionM);
  drawing_->setTitle(tr("Profile at %1 m").arg(locale().toString(positionM, 'f', 3)));
  const QString number = tr("no. %1 of %2").arg(count(profile.number + 1), count(opened_->stored.summary.profiles));
  QString note = number;
  if (!profile.drawn)
    note += tr(": points were not kept of this rail, the model is shown");
  else if (profile.drawnNumber != profile.number)
    note += tr("; drawn is no. %1, the nearest whose points were kept").arg(count(profile.drawnNumber + 1));
  drawing_->setNote(note);
  std::optional<Dimension> selected;
  if (const int row = drawn_->currentIndex(); row > 0) selected = kDimensions[static_cast<std::size_t>(row - 1)];
  double worst = selected ? std::numeric_limits<double>::infinity() : 0;
  for (const Dimension d : kDimensions)
    if (const auto excess = excessMm(d, profile.record.dimensions[index(d)]); excess && *excess > worst) {
      worst = *excess;
      selected = d;
    }
  canvas_->show(opened_, profile.drawn, selected);
  showStrips();
  emit profileChanged();
}

void RailsPage::showStrips() {
  for (std::size_t i = 0; i < strips_.size(); ++i) {
    strips_[i]->setVisible(i < stripDimensions_.size() && i < stripsShown_);
    if (i >= stripDimensions_.size()) continue;
    const Dimension d = stripDimensions_[i];
    const DimensionSummary& summary = opened_->stored.summary.dimensions[index(d)];
    StripSeries series;
    series.name = inscribed(d);
    series.lengthM = opened_->stored.summary.lengthM;
    series.nominal = summary.nominalMm;
    series.lower = summary.lowerMm;
    series.upper = summary.upperMm;
    series.value = QStringLiteral("–");
    for (const TrackBin& bin : summary.track)
      if (bin.count > 0) series.points.append({bin.positionM, bin.meanMm});
    for (const DimensionException& e : summary.exceptions) series.outside.append({e.fromM, e.toM});
    if (shown_) {
      const DimensionResult& r = shown_->record.dimensions[index(d)];
      series.positionM = shown_->record.positionMm / 1000;
      series.symbol = symbolOf(r.verdict);
      series.value = r.valueMm ? numberText(*r.valueMm, decimalsOf(d)) : tr("no value");
    }
    strips_[i]->show(series);
  }
}

void RailsPage::goTo(double positionM) {
  if (!opened_ || opened_->stored.summary.profiles == 0) return;
  const RailSummary& summary = opened_->stored.summary;
  const auto last = static_cast<double>(summary.profiles - 1);
  const double share = summary.lengthM > 0 ? positionM / summary.lengthM : 0;
  number_ = static_cast<std::uint64_t>(std::clamp(std::round(share * last), 0.0, last));
  askProfile();
}

void RailsPage::step(int profiles) {
  if (!opened_ || opened_->stored.summary.profiles == 0) return;
  const auto last = static_cast<std::int64_t>(opened_->stored.summary.profiles) - 1;
  const std::int64_t next = std::clamp<std::int64_t>(static_cast<std::int64_t>(number_) + profiles, 0, last);
  if (next == static_cast<std::int64_t>(number_) && playing_->isActive()) playButton_->setChecked(false);
  number_ = static_cast<std::uint64_t>(next);
  askProfile();
}

void RailsPage::nextException(bool backwards) {
  if (!opened_) return;
  const auto all = exceptionsOf(opened_->stored.summary);
  const double here = shown_ ? shown_->record.positionMm / 1000 : 0;
  constexpr double kBeyondM = 0.02;
  int found = -1;
  for (int i = 0; i < static_cast<int>(all.size()); ++i) {
    const DimensionException& e = all[static_cast<std::size_t>(i)].stretch;
    const double at = (e.fromM + e.toM) / 2;
    if (backwards ? at < here - kBeyondM : at > here + kBeyondM) {
      found = i;
      if (!backwards) break;
    }
  }
  if (found < 0) return;
  exceptionTable_->selectRow(found);
}

void RailsPage::play(bool on) {
  if (on && opened_)
    playing_->start();
  else
    playing_->stop();
}

void RailsPage::save(bool report) {
  if (!opened_) return;
  const QString proposal =
      shown(opened_->stored.summary.rail.id) + (report ? QStringLiteral(".pdf") : QStringLiteral(".csv"));
  const QString file = QFileDialog::getSaveFileName(
      this, report ? tr("Report as PDF") : tr("Export as CSV or JSON"), proposal,
      report ? QStringLiteral("PDF (*.pdf)") : QStringLiteral("CSV (*.csv);;JSON (*.json)"));
  if (file.isEmpty()) return;
  list_->setNote(tr("writing %1 …").arg(file));
  reader_->ask(
      "save",
      [this, rail = opened_, drawn = shown_ ? shown_->drawn : nullptr, file, report](
          const Archive* archive, const std::string& problem) -> ArchiveReader::Answer {
        Expected<void> done;
        if (report) {
          RailReport pages;
          pages.summary = &rail->stored.summary;
          pages.recipe = rail->recipe ? &*rail->recipe : nullptr;
          pages.example = drawn.get();
          pages.programVersion = rail->stored.place.program;
          pages.simulation = rail->stored.place.source == "virtual";
          pages.measuredAt = std::chrono::system_clock::time_point(std::chrono::microseconds(rail->stored.endedUs));
          done = pages.recipe != nullptr
                     ? writeRailReport(pages, file.toStdString())
                     : Expected<void>(inputError("report", "the rail's recipe cannot be read: " + rail->recipeProblem));
        } else if (archive == nullptr) {
          done = worldError("archive", problem);
        } else {
          const auto profiles = RailArchive(*archive).profiles(rail->stored.key);
          done = profiles ? exportRail(rail->stored, *profiles, file.toStdString())
                          : Expected<void>(tl::unexpected(profiles.error()));
        }
        return [this, file, done] {
          list_->setNote(done ? tr("%1 is written").arg(file) : shown(done.error().message()));
        };
      });
}

}  // namespace vignole
