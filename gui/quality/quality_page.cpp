#include "gui/quality/quality_page.h"

#include <QComboBox>
#include <QDateTime>
#include <QEvent>
#include <QFileDialog>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSaveFile>
#include <QTableWidget>
#include <limits>

#include "gui/bridge/archive_reader.h"
#include "gui/plots/runs_plot.h"
#include "gui/theme/inscription.h"
#include "gui/theme/panel.h"
#include "report/dimension_text.h"

namespace vignole {

namespace {

constexpr std::size_t kMostRails = 200;

QString shown(const std::string& text) { return QString::fromStdString(text); }

RepeatabilityRun runOf(const std::string& name, const std::vector<ProfileRecord>& profiles, Dimension dimension) {
  RepeatabilityRun run{name, {}, {}};
  for (const ProfileRecord& profile : profiles) {
    run.positionM.push_back(profile.positionMm / 1000);
    run.valueMm.push_back(
        profile.dimensions[index(dimension)].valueMm.value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  return run;
}

}  // namespace

QualityPage::QualityPage(Workplace& place, QWidget* parent)
    : Page(parent), place_(place), reader_(std::make_unique<ArchiveReader>(place.archive ? place.archiveUrl : "")) {
  setObjectName(QStringLiteral("page"));
  setFocusPolicy(Qt::ClickFocus);
  runPanel_ = new Panel(this);
  runs_ = new QTableWidget(0, 3, runPanel_);
  styleTable(*runs_);
  runs_->setSelectionMode(QAbstractItemView::NoSelection);
  dimensions_ = new QComboBox(runPanel_);
  window_ = new QComboBox(runPanel_);
  for (QComboBox* box : {dimensions_, window_}) box->setFont(uiFont(16));
  study_ = makeButton(place.theme, QStringLiteral("quality"), runPanel_, true);
  export_ = makeButton(place.theme, QStringLiteral("export"), runPanel_);
  words_ = makeLabel(15, 400, "t2", runPanel_, true);
  runPanel_->content()->addWidget(runs_, 1);
  for (QWidget* w : std::initializer_list<QWidget*>{dimensions_, window_, study_, export_, words_})
    runPanel_->content()->addWidget(w);
  connect(study_, &QPushButton::clicked, this, &QualityPage::study);
  connect(export_, &QPushButton::clicked, this, &QualityPage::saveReport);
  connect(dimensions_, &QComboBox::activated, this,
          [this](int row) { choose(kDimensions[static_cast<std::size_t>(row)]); });
  connect(window_, &QComboBox::activated, this, [this] {
    if (result_) study();
  });

  valuePanel_ = new Panel(this);
  values_ = new RunsPlot(place.theme, valuePanel_);
  valuePanel_->content()->addWidget(values_, 1);
  rangePanel_ = new Panel(this);
  ranges_ = new RunsPlot(place.theme, rangePanel_);
  rangePanel_->content()->addWidget(ranges_, 1);
  tablePanel_ = new Panel(this);
  table_ = new QTableWidget(0, 3, tablePanel_);
  styleTable(*table_);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->verticalHeader()->setDefaultSectionSize(30);
  tablePanel_->content()->addWidget(table_, 1);
  figurePanel_ = new Panel(this);
  figures_ = new QTableWidget(0, 2, figurePanel_);
  styleTable(*figures_);
  figures_->setSelectionMode(QAbstractItemView::NoSelection);
  figures_->horizontalHeader()->hide();
  figures_->verticalHeader()->setDefaultSectionSize(30);
  conditions_ = makeLabel(14, 400, "t2", figurePanel_, true);
  figurePanel_->content()->addWidget(figures_, 1);
  figurePanel_->content()->addWidget(conditions_);

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(16, 16, 16, 16);
  grid->setSpacing(16);
  grid->addWidget(runPanel_, 0, 0, 2, 1);
  grid->addWidget(valuePanel_, 0, 1);
  grid->addWidget(rangePanel_, 1, 1);
  grid->addWidget(tablePanel_, 0, 2);
  grid->addWidget(figurePanel_, 1, 2);
  grid->setColumnStretch(0, 4);
  grid->setColumnStretch(1, 8);
  grid->setColumnStretch(2, 5);
  grid->setRowStretch(0, 3);
  grid->setRowStretch(1, 3);
  connect(&place_.units, &Units::changed, this, &QualityPage::showResult);
  retranslate();
}

QualityPage::~QualityPage() { reader_.reset(); }

void QualityPage::retranslate() {
  runPanel_->setTitle(tr("Repeatability"));
  runPanel_->setNote(tr("runs of the same rail"));
  runs_->setHorizontalHeaderLabels({tr("Run"), tr("Length, m"), tr("Measured")});
  runs_->setAccessibleName(tr("Rails that may be laid over each other"));
  dimensions_->clear();
  for (const Dimension d : kDimensions) dimensions_->addItem(spoken(d));
  dimensions_->setCurrentIndex(static_cast<int>(index(dimension_)));
  dimensions_->setAccessibleName(tr("Dimension"));
  const int chosen = std::max(0, window_->currentIndex());
  window_->clear();
  window_->addItem(tr("Single profiles"), 0.0);
  window_->addItem(tr("Means over 0.1 m"), 0.1);
  window_->addItem(tr("Means over 1 m"), 1.0);
  window_->setCurrentIndex(chosen);
  window_->setAccessibleName(tr("What is compared"));
  study_->setText(tr("Compare the chosen runs"));
  study_->setAccessibleName(tr("Compare the chosen runs"));
  export_->setText(tr("Export…"));
  export_->setAccessibleName(tr("Export values and ranges as CSV"));
  valuePanel_->setTitle(tr("Values over the length"));
  valuePanel_->setNote(tr("as Fig. 9a"));
  rangePanel_->setTitle(tr("Range of the runs"));
  rangePanel_->setNote(tr("as Fig. 9b"));
  values_->setAccessibleName(tr("Values of every run over the length"));
  ranges_->setAccessibleName(tr("Range of the runs over the length"));
  tablePanel_->setTitle(tr("Mean range"));
  tablePanel_->setNote(tr("per 10 m, as Table VI"));
  table_->setHorizontalHeaderLabels({tr("From – to, m"), tr("Positions"), tr("Mean range")});
  table_->setAccessibleName(tr("Mean range, section by section"));
  figurePanel_->setTitle(tr("Figures"));
  figures_->setAccessibleName(tr("Figures of the study"));
  showResult();
}

void QualityPage::changeEvent(QEvent* event) {
  Page::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

void QualityPage::showEvent(QShowEvent* event) {
  Page::showEvent(event);
  load();
}

void QualityPage::showLine(const LineSnapshot& /*line*/, PullDetail /*detail*/) {}

void QualityPage::load() {
  reader_->ask("rails", [this](const Archive* archive, const std::string& problem) -> ArchiveReader::Answer {
    if (archive == nullptr)
      return [this, problem] {
        problem_ = tr("Runs come from the archive, and there is none: %1. Start the program with --archive FILE.")
                       .arg(shown(problem));
        showResult();
        emit railsChanged();
      };
    RailQuery query;
    query.limit = kMostRails;
    query.state = RailState::Finished;
    auto found = RailArchive(*archive).search(query);
    if (!found) return [this, words = found.error().message()] { words_->setText(shown(words)); };
    return [this, found = std::move(*found)] {
      std::vector<std::int64_t> chosen;
      for (int i = 0; i < runs_->rowCount(); ++i)
        if (runs_->item(i, 0)->checkState() == Qt::Checked) chosen.push_back(rails_[static_cast<std::size_t>(i)].key);
      rails_ = found;
      runs_->setRowCount(static_cast<int>(rails_.size()));
      for (int i = 0; i < static_cast<int>(rails_.size()); ++i) {
        const RailLine& rail = rails_[static_cast<std::size_t>(i)];
        auto* name = new QTableWidgetItem(shown(rail.id));
        name->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsSelectable);
        name->setCheckState(std::find(chosen.begin(), chosen.end(), rail.key) != chosen.end() ? Qt::Checked
                                                                                              : Qt::Unchecked);
        runs_->setItem(i, 0, name);
        runs_->setItem(i, 1, new QTableWidgetItem(locale().toString(rail.lengthM, 'f', 1)));
        runs_->setItem(
            i, 2,
            new QTableWidgetItem(
                QDateTime::fromMSecsSinceEpoch(rail.beganUs / 1000).toString(QStringLiteral("yyyy-MM-dd HH:mm"))));
      }
      runs_->setColumnWidth(0, runs_->viewport()->width() * 36 / 100);
      runs_->setColumnWidth(1, runs_->viewport()->width() * 24 / 100);
      showResult();
      emit railsChanged();
    };
  });
}

void QualityPage::setRun(int row, bool chosen) {
  if (row >= 0 && row < runs_->rowCount()) runs_->item(row, 0)->setCheckState(chosen ? Qt::Checked : Qt::Unchecked);
}

void QualityPage::choose(Dimension dimension) {
  dimension_ = dimension;
  dimensions_->setCurrentIndex(static_cast<int>(index(dimension)));
  if (result_) study();
}

void QualityPage::study() {
  std::vector<RailLine> chosen;
  for (int i = 0; i < runs_->rowCount(); ++i)
    if (runs_->item(i, 0)->checkState() == Qt::Checked) chosen.push_back(rails_[static_cast<std::size_t>(i)]);
  if (chosen.size() < 2) {
    problem_ = tr("At least 2 runs of the same rail are needed, %1 chosen; the paper took 5.").arg(chosen.size());
    result_.reset();
    showResult();
    emit resultChanged();
    return;
  }
  words_->setText(tr("reading …"));
  reader_->ask("study",
               [this, chosen, dimension = dimension_, windowM = window_->currentData().toDouble()](
                   const Archive* archive, const std::string& problem) -> ArchiveReader::Answer {
                 const auto refused = [this](const std::string& words) -> ArchiveReader::Answer {
                   return [this, words] {
                     problem_ = shown(words);
                     result_.reset();
                     showResult();
                     emit resultChanged();
                   };
                 };
                 if (archive == nullptr) return refused(problem);
                 std::vector<RepeatabilityRun> runs;
                 for (auto rail = chosen.rbegin(); rail != chosen.rend(); ++rail) {
                   const auto profiles = RailArchive(*archive).profiles(rail->key);
                   if (!profiles) return refused(profiles.error().message());
                   runs.push_back(runOf(rail->id, *profiles, dimension));
                 }
                 RepeatabilitySettings settings;
                 settings.windowM = windowM;
                 auto result = repeatabilityStudy(runs, settings);
                 if (!result) return refused(result.error().message());
                 return [this, result = std::move(*result)] {
                   problem_.clear();
                   result_ = result;
                   showResult();
                   emit resultChanged();
                 };
               });
}

void QualityPage::showResult() {
  export_->setEnabled(result_.has_value());
  words_->setText(!problem_.isEmpty() ? problem_
                  : rails_.empty()
                      ? tr("No rail has been kept yet. Runs of the same rail are compared here.")
                      : tr("Tick the runs that were made of the same rail, choose a dimension and compare."));
  if (!result_) {
    values_->show({}, {}, {});
    ranges_->show({}, {}, {});
    table_->setRowCount(0);
    figures_->setRowCount(0);
    conditions_->clear();
    return;
  }
  const RepeatabilityResult& r = *result_;
  const Units& units = place_.units;
  const int decimals = units.decimals(decimalsOf(dimension_)) + 1;
  const auto length = [&](double mm) { return locale().toString(units.shown(mm), 'f', decimals); };
  QVector<RunCurve> curves;
  const QVector<double> x(r.positionM.begin(), r.positionM.end());
  for (std::size_t i = 0; i < r.runs.size(); ++i) {
    RunCurve curve{shown(r.runs[i]), x, {}};
    for (const double v : r.valueMm[i]) curve.y.append(units.shown(v));
    curves.append(curve);
  }
  const QString axis = QStringLiteral("%1, %2").arg(spoken(dimension_), units.name());
  values_->show(tr("length, m"), axis, curves);
  RunCurve range{tr("range"), x, {}};
  for (const double v : r.rangeMm) range.y.append(units.shown(v));
  ranges_->show(tr("length, m"), tr("range, %1").arg(units.name()), {range}, {units.shown(r.meanRangeMm)});
  table_->setRowCount(static_cast<int>(r.sections.size()));
  for (int i = 0; i < static_cast<int>(r.sections.size()); ++i) {
    const RepeatabilitySection& s = r.sections[static_cast<std::size_t>(i)];
    const QString cells[] = {QStringLiteral("%1 – %2").arg(s.fromM).arg(s.toM), count(s.positions),
                             length(s.meanRangeMm)};
    for (int column = 0; column < 3; ++column) table_->setItem(i, column, new QTableWidgetItem(cells[column]));
  }
  table_->setColumnWidth(0, table_->viewport()->width() / 3);
  table_->setColumnWidth(1, table_->viewport()->width() / 3);
  std::vector<std::pair<QString, QString>> rows = {
      {tr("Runs, positions"), QStringLiteral("%1, %2").arg(r.runs.size()).arg(count(r.positionM.size()))},
      {tr("Repeatability s_r").replace('_', ' '), length(r.srMm)},
      {tr("its 95 % interval"), QStringLiteral("%1 … %2").arg(length(r.srIntervalMm.low), length(r.srIntervalMm.high))},
      {tr("Limit r = 2.8 s_r").replace('_', ' '), length(r.rMm)},
      {tr("Mean range"), length(r.meanRangeMm)},
      {tr("Largest range"), length(r.maxRangeMm)},
      {tr("s from the range"), length(r.srFromRangeMm)},
      {tr("Autocorrelation"), locale().toString(r.autocorrelation, 'f', 2)}};
  const auto test = [&](const QString& name, const std::optional<OutlierTest>& t) {
    if (t)
      rows.emplace_back(name,
                        tr("%1, critical %2 (1 %)")
                            .arg(locale().toString(t->statistic, 'f', 3), locale().toString(t->critical1, 'f', 3)));
  };
  test(tr("Grubbs, means of the runs"), r.grubbsRuns);
  test(tr("Cochran, scatter of the runs"), r.cochranRuns);
  figures_->setRowCount(static_cast<int>(rows.size()));
  for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
    figures_->setItem(i, 0, new QTableWidgetItem(rows[static_cast<std::size_t>(i)].first));
    auto* value = new QTableWidgetItem(rows[static_cast<std::size_t>(i)].second);
    value->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    figures_->setItem(i, 1, value);
  }
  figures_->setColumnWidth(0, figures_->viewport()->width() * 48 / 100);
  QStringList formulas;
  for (const std::string& f : r.notes.formulas) formulas << shown(f);
  conditions_->setText(formulas.join(QStringLiteral("; ")));
  conditions_->setToolTip(formulas.join('\n'));
  figurePanel_->setNote(units.name() +
                        (r.dropped > 0 ? tr(", %1 positions left out: a run lacks them").arg(r.dropped) : QString()));
}

void QualityPage::saveReport() {
  if (!result_) return;
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Export as CSV"), QStringLiteral("repeatability-%1.csv").arg(shown(std::string(name(dimension_)))));
  if (file.isEmpty()) return;
  const RepeatabilityResult& r = *result_;
  QString text = QStringLiteral("position_m");
  for (const std::string& run : r.runs)
    text += ',' + QString('"') + shown(run).replace('"', QStringLiteral("\"\"")) + '"';
  text += QStringLiteral(",range_mm\n");
  for (std::size_t i = 0; i < r.positionM.size(); ++i) {
    text += QString::number(r.positionM[i], 'f', 4);
    for (const auto& run : r.valueMm) text += ',' + QString::number(run[i], 'f', 6);
    text += ',' + QString::number(r.rangeMm[i], 'f', 6) + '\n';
  }
  QSaveFile out(file);
  const bool done = out.open(QIODevice::WriteOnly) && out.write(text.toUtf8()) >= 0 && out.commit();
  words_->setText(done ? tr("%1 is written").arg(file) : tr("%1 cannot be written").arg(file));
}

}  // namespace vignole
