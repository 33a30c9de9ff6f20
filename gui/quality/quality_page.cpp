#include "gui/quality/quality_page.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDateTime>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QSaveFile>
#include <QShortcut>
#include <QTableWidget>
#include <cmath>
#include <limits>

#include "gui/bridge/archive_reader.h"
#include "gui/plots/runs_plot.h"
#include "gui/quality/rig_experiment.h"
#include "gui/theme/inscription.h"
#include "gui/theme/panel.h"
#include "report/dimension_text.h"
#include "report/document_pages.h"
#include "report/engine_words.h"
#include "report/state_symbol.h"

namespace vignole {

namespace {

constexpr std::size_t kMostRails = 200;
constexpr int kExperimentRuns = 5;  // as the paper
constexpr int kNameWidth = 76, kFigureWidth = 66, kLeastRow = 21, kMostRow = 38;

QString shown(const std::string& text) { return QString::fromStdString(text); }

QTableWidgetItem* cell(const QString& text, bool right) {
  auto* item = new QTableWidgetItem(text);
  item->setTextAlignment((right ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  return item;
}

QPixmap symbolOf(Standing standing, const Palette& palette) {
  QPixmap pixmap(56, 56);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  const StateSymbol symbol = standing == Standing::Good  ? StateSymbol::Good
                             : standing == Standing::Bad ? StateSymbol::Out
                                                         : StateSymbol::NoLimit;
  paintSymbol(painter, QRectF(4, 4, 48, 48), symbol, palette);
  painter.end();
  pixmap.setDevicePixelRatio(2);
  return pixmap;
}

}  // namespace

QualityPage::QualityPage(Workplace& place, QWidget* parent)
    : Page(parent),
      place_(place),
      reader_(std::make_unique<ArchiveReader>(place.archive ? place.archiveUrl : "")),
      experiment_(std::make_unique<RigExperiment>()) {
  setObjectName(QStringLiteral("page"));
  setFocusPolicy(Qt::ClickFocus);
  upperPanel_ = new Panel(this);
  upper_ = new RunsPlot(place.theme, upperPanel_);
  upperPanel_->content()->addWidget(upper_, 1);
  lowerPanel_ = new Panel(this);
  lower_ = new RunsPlot(place.theme, lowerPanel_);
  lowerPanel_->content()->addWidget(lower_, 1);
  tablePanel_ = new Panel(this);
  table_ = new QTableWidget(static_cast<int>(kDimensionCount), 0, tablePanel_);
  styleTable(*table_);
  table_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table_->horizontalHeader()->setStyleSheet(QStringLiteral("QHeaderView { padding: 0px; }"));  // heads above numbers
  table_->verticalHeader()->setMinimumSectionSize(kLeastRow);
  table_->setMinimumHeight(kLeastRow * static_cast<int>(kDimensionCount) + 34);
  tablePanel_->content()->addWidget(table_, 1);
  tablePanel_->setMinimumHeight(table_->minimumHeight() + 60);
  connect(table_, &QTableWidget::itemSelectionChanged, this, [this] {
    const int row = table_->currentRow();
    if (row >= 0) choose(kDimensions[static_cast<std::size_t>(row)]);
  });

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(16, 16, 16, 16);
  grid->setSpacing(16);
  grid->addWidget(makeRuns(), 0, 0, 2, 1);
  grid->addWidget(upperPanel_, 0, 1);
  grid->addWidget(lowerPanel_, 1, 1);
  auto* right = new QVBoxLayout;
  right->setSpacing(12);
  right->addWidget(tablePanel_, 3);
  right->addWidget(makeResult(), 2);
  grid->addLayout(right, 0, 2, 2, 1);
  grid->setColumnStretch(0, 4);
  grid->setColumnStretch(1, 8);
  grid->setColumnStretch(2, 7);
  grid->setRowStretch(0, 3);
  grid->setRowStretch(1, 2);
  connect(&place.units, &Units::changed, this, &QualityPage::showStudy);
  connect(&place.theme, &Theme::changed, this, &QualityPage::showStudy);
  connect(experiment_.get(), &RigExperiment::progressed, progress_, &QProgressBar::setValue);
  connect(experiment_.get(), &RigExperiment::finished, this, [this] {
    const RigExperimentResult& made = experiment_->result();
    rigRuns_ = made.runs;
    rigTruth_ = made.truth;
    rigTruth_.source = tr("truth of the virtual rig").toStdString();
    showRuns();
    showSource();
    if (made.problem.empty())
      study();
    else
      refuse(made.problem == "cancelled"
                 ? tr("The inspections were cancelled; %n were whole.", nullptr, static_cast<int>(rigRuns_.size()))
                 : shown(made.problem));
  });
  bindKeys();
  retranslate();
}

QualityPage::~QualityPage() {
  reader_.reset();
  experiment_.reset();
}

QWidget* QualityPage::makeRuns() {
  runPanel_ = new Panel(this);
  repeatabilityButton_ = new QPushButton(runPanel_);
  accuracyButton_ = new QPushButton(runPanel_);
  auto* kinds = new QHBoxLayout;
  kinds->setSpacing(0);
  for (QPushButton* button : {repeatabilityButton_, accuracyButton_}) {
    button->setObjectName(QStringLiteral("segment"));
    button->setFont(uiFont(16, 500));
    button->setCheckable(true);
    kinds->addWidget(button, 1);
  }
  connect(repeatabilityButton_, &QPushButton::clicked, this, [this] { showKind(RunsStudyKind::Repeatability); });
  connect(accuracyButton_, &QPushButton::clicked, this, [this] { showKind(RunsStudyKind::Accuracy); });
  sources_ = new QComboBox(runPanel_);
  length_ = new QComboBox(runPanel_);
  window_ = new QComboBox(runPanel_);
  for (QComboBox* box : {sources_, length_, window_}) {
    box->setFont(uiFont(16));
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  }
  connect(sources_, &QComboBox::activated, this, [this](int row) { setSource(static_cast<Source>(row)); });
  connect(window_, &QComboBox::activated, this, [this] {
    if (study_) study();
  });
  runs_ = new QTableWidget(0, 3, runPanel_);
  styleTable(*runs_);
  runs_->setSelectionMode(QAbstractItemView::NoSelection);
  runs_->setMinimumHeight(100);
  open_ = makeButton(place_.theme, QStringLiteral("import"), runPanel_);
  experimentButton_ = makeButton(place_.theme, QStringLiteral("play"), runPanel_);
  progress_ = new QProgressBar(runPanel_);
  progress_->setTextVisible(false);
  progress_->setFixedHeight(8);
  progress_->setRange(0, 100);
  reference_ = makeButton(place_.theme, QStringLiteral("import"), runPanel_);
  compare_ = makeButton(place_.theme, QStringLiteral("quality"), runPanel_, true);
  report_ = makeButton(place_.theme, QStringLiteral("report"), runPanel_);
  export_ = makeButton(place_.theme, QStringLiteral("export"), runPanel_);
  words_ = makeLabel(15, 400, "t2", runPanel_, true);
  auto* files = new QHBoxLayout;
  files->addWidget(report_, 1);
  files->addWidget(export_, 1);
  runPanel_->content()->addLayout(kinds);
  runPanel_->content()->addWidget(sources_);
  runPanel_->content()->addWidget(runs_, 1);
  for (QWidget* w :
       std::initializer_list<QWidget*>{open_, length_, experimentButton_, progress_, reference_, window_, compare_})
    runPanel_->content()->addWidget(w);
  runPanel_->content()->addLayout(files);
  runPanel_->content()->addWidget(words_);
  connect(open_, &QPushButton::clicked, this, [this] {
    openRuns(QFileDialog::getOpenFileName(this, tr("Runs of one rail"), {}, QStringLiteral("CSV (*.csv)")));
  });
  connect(reference_, &QPushButton::clicked, this, [this] {
    openReference(QFileDialog::getOpenFileName(this, tr("Reference values"), {}, QStringLiteral("CSV (*.csv)")));
  });
  connect(experimentButton_, &QPushButton::clicked, this, &QualityPage::runExperiment);
  connect(compare_, &QPushButton::clicked, this, &QualityPage::study);
  const auto proposal = [this](const char* ending) {
    return QStringLiteral("%1-%2.%3")
        .arg(kind_ == RunsStudyKind::Repeatability ? "repeatability" : "accuracy", shown(std::string(name(dimension_))),
             ending);
  };
  connect(report_, &QPushButton::clicked, this, [this, proposal] {
    saveReport(QFileDialog::getSaveFileName(this, tr("Report as PDF"), proposal("pdf"), QStringLiteral("PDF (*.pdf)")));
  });
  connect(export_, &QPushButton::clicked, this, [this, proposal] {
    saveValues(QFileDialog::getSaveFileName(this, tr("Export as CSV"), proposal("csv"), QStringLiteral("CSV (*.csv)")));
  });
  return runPanel_;
}

QWidget* QualityPage::makeResult() {
  figurePanel_ = new Panel(this);
  symbol_ = new QLabel(figurePanel_);
  verdict_ = makeLabel(26, 500, "t1", figurePanel_);
  reason_ = makeLabel(15, 400, "t2", figurePanel_, true);
  auto* line = new QHBoxLayout;
  line->setSpacing(12);
  line->addWidget(symbol_);
  line->addWidget(verdict_);
  line->addWidget(reason_, 1);
  figures_ = new QTableWidget(0, 2, figurePanel_);
  styleTable(*figures_);
  figures_->setSelectionMode(QAbstractItemView::NoSelection);
  figures_->setFont(uiFont(15));
  figures_->setWordWrap(true);
  figures_->horizontalHeader()->hide();
  figures_->verticalHeader()->setMinimumSectionSize(28);
  figures_->setMinimumHeight(56);
  // It takes what is left: beside wrapped text a layout would hold its wish for its need.
  figures_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
  figurePanel_->content()->addLayout(line);
  figurePanel_->content()->addWidget(figures_, 1);
  return figurePanel_;
}

void QualityPage::bindKeys() {
  const auto bind = [this](const QKeySequence& key, QPushButton* button) {
    auto* shortcut = new QShortcut(key, this);
    shortcut->setContext(Qt::WidgetWithChildrenShortcut);
    connect(shortcut, &QShortcut::activated, button, &QPushButton::click);
  };
  bind(QKeySequence(Qt::CTRL | Qt::Key_P), report_);
  bind(QKeySequence(Qt::CTRL | Qt::Key_E), export_);
}

void QualityPage::retranslate() {
  const auto refill = [](QComboBox* box, const std::vector<std::pair<QString, double>>& items) {
    const int chosen = std::max(0, box->currentIndex());
    box->clear();
    for (const auto& [text, value] : items) box->addItem(text, value);
    box->setCurrentIndex(chosen);
  };
  runPanel_->setTitle(tr("Study"));
  runPanel_->setNote(tr("runs of the same rail"));
  repeatabilityButton_->setText(tr("Repeatability"));
  repeatabilityButton_->setAccessibleName(tr("Repeatability"));
  accuracyButton_->setText(tr("Accuracy"));
  accuracyButton_->setAccessibleName(tr("Accuracy"));
  refill(sources_, {{tr("Rails of the archive"), 0}, {tr("Runs from a file"), 0}, {tr("Virtual rig"), 0}});
  sources_->setAccessibleName(tr("Where the runs come from"));
  refill(length_, {{tr("3 m of rail"), 3000}, {tr("12 m of rail"), 12000}, {tr("60 m of rail, as the paper"), 60000}});
  length_->setAccessibleName(tr("Length of the virtual rail"));
  refill(window_, {{tr("Single profiles"), 0.0},
                   {tr("Means over 0.1 m"), 0.1},
                   {tr("Means over 0.5 m"), 0.5},
                   {tr("Means over 1 m"), 1.0}});
  window_->setAccessibleName(tr("What is compared"));
  runs_->setHorizontalHeaderLabels({tr("Run"), tr("Length, m"), tr("Measured")});
  runs_->setAccessibleName(tr("Runs that may be laid over each other"));
  open_->setText(tr("Open runs…"));
  open_->setAccessibleName(tr("Open runs from a CSV file"));
  reference_->setText(tr("Open reference…"));
  reference_->setAccessibleName(tr("Open reference values from a CSV file"));
  compare_->setText(tr("Compare the chosen runs"));
  compare_->setAccessibleName(tr("Compare the chosen runs"));
  report_->setText(tr("Report…"));
  report_->setAccessibleName(tr("Report as PDF"));
  report_->setToolTip(tr("Report as PDF (Ctrl+P)"));
  export_->setText(tr("Export…"));
  export_->setAccessibleName(tr("Export values as CSV"));
  export_->setToolTip(tr("Export values as CSV (Ctrl+E)"));
  progress_->setAccessibleName(tr("Progress of the inspections"));
  upper_->setAccessibleName(tr("Values of every run over the length"));
  lower_->setAccessibleName(tr("What the runs differ by over the length"));
  table_->setAccessibleName(tr("Every dimension; the chosen one is drawn"));
  figurePanel_->setTitle(tr("Result"));
  figures_->setAccessibleName(tr("Figures of the chosen dimension, formulas and constants"));
  showRuns();
  showSource();
  showStudy();
}

void QualityPage::changeEvent(QEvent* event) {
  Page::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

void QualityPage::showEvent(QShowEvent* event) {
  Page::showEvent(event);
  load();
}

void QualityPage::resizeEvent(QResizeEvent* event) {
  Page::resizeEvent(event);
  // The layout has its say first.
  QMetaObject::invokeMethod(
      this,
      [this] {
        showRuns();
        showTable();
        showFigures();
      },
      Qt::QueuedConnection);
}

void QualityPage::showLine(const LineSnapshot& /*line*/, PullDetail detail) {
  if (detail == PullDetail::Everything && source_ == Source::VirtualRig && !experiment_->running()) showSource();
}

const RepeatabilityResult* QualityPage::result() const {
  if (!study_) return nullptr;
  const auto& is = study_->dimensions[index(dimension_)].repeatability;
  return is ? &*is : nullptr;
}

const AccuracyResult* QualityPage::accuracy() const {
  if (!study_) return nullptr;
  const auto& is = study_->dimensions[index(dimension_)].accuracy;
  return is ? &*is : nullptr;
}

QString QualityPage::words() const { return words_->text(); }

void QualityPage::load() {
  reader_->ask("rails", [this](const Archive* archive, const std::string& problem) -> ArchiveReader::Answer {
    if (archive == nullptr)
      return [this, problem] {
        if (source_ == Source::Archive && problem_.isEmpty())
          problem_ = tr("Stored runs come from the archive, and there is none (%1): start the program with --archive "
                        "FILE, or choose a file or the virtual rig above.")
                         .arg(inWords(place_.archiveProblem.empty() ? problem : place_.archiveProblem));
        showStudy();
        emit railsChanged();
      };
    RailQuery query;
    query.limit = kMostRails;
    query.state = RailState::Finished;
    auto found = RailArchive(*archive).search(query);
    if (!found) return [this, words = found.error().message()] { words_->setText(shown(words)); };
    return [this, found = std::move(*found)] {
      rails_ = found;
      if (source_ == Source::Archive) showRuns();
      showStudy();
      emit railsChanged();
    };
  });
}

void QualityPage::showRuns() {
  // What was ticked stays ticked as long as it is there.
  QStringList ticked;
  for (int i = 0; i < runs_->rowCount(); ++i)
    if (runs_->item(i, 0)->checkState() == Qt::Checked) ticked << runs_->item(i, 0)->data(Qt::UserRole).toString();
  const auto add = [&](int row, const QString& name, const QString& key, double lengthM, const QString& when,
                       bool tick) {
    auto* item = new QTableWidgetItem(name);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsSelectable);
    item->setData(Qt::UserRole, key);
    item->setCheckState(tick || ticked.contains(key) ? Qt::Checked : Qt::Unchecked);
    item->setToolTip(name + QStringLiteral(", ") + when);
    runs_->setItem(row, 0, item);
    runs_->setItem(row, 1, new QTableWidgetItem(locale().toString(lengthM, 'f', 1)));
    runs_->setItem(row, 2, new QTableWidgetItem(when));
  };
  if (source_ == Source::Archive) {
    runs_->setRowCount(static_cast<int>(rails_.size()));
    for (int i = 0; i < static_cast<int>(rails_.size()); ++i) {
      const RailLine& rail = rails_[static_cast<std::size_t>(i)];
      add(i, shown(rail.id), QStringLiteral("rail %1").arg(rail.key), rail.lengthM,
          QDateTime::fromMSecsSinceEpoch(rail.beganUs / 1000).toString(QStringLiteral("yyyy-MM-dd HH:mm")), false);
    }
  } else {
    const Runs& runs = source_ == Source::File ? fileRuns_ : rigRuns_;
    const QString from = source_ == Source::File ? fileName_ : tr("virtual rig");
    runs_->setRowCount(static_cast<int>(runs.size()));
    for (int i = 0; i < static_cast<int>(runs.size()); ++i) {
      const MeasuredRun& run = runs[static_cast<std::size_t>(i)];
      add(i, tr("run %1").arg(shown(run.name)), from + shown(run.name),
          run.positionM.empty() ? 0 : run.positionM.back(), from, true);
    }
  }
  const int width = runs_->viewport()->width();
  const bool narrow = width < 300;  // the name says which run it is; when it was goes into its tip
  runs_->setColumnHidden(2, narrow);
  runs_->setColumnWidth(0, width * (narrow ? 62 : 36) / 100);
  runs_->setColumnWidth(1, width * (narrow ? 38 : 24) / 100);
}

void QualityPage::showSource() {
  open_->setVisible(source_ == Source::File);
  const bool rig = source_ == Source::VirtualRig;
  const bool busy = experiment_->running();
  length_->setVisible(rig && !busy);
  experimentButton_->setVisible(rig);
  progress_->setVisible(rig && busy);
  experimentButton_->setText(busy ? tr("Cancel") : tr("Inspect the rail five times"));
  experimentButton_->setAccessibleName(busy ? tr("Cancel the inspections")
                                            : tr("Inspect the same virtual rail five times"));
  // Both would want all processors, and the live line must not lose a trigger to a study.
  const bool held = rig && !busy && place_.line.running();
  experimentButton_->setEnabled(!held);
  experimentButton_->setToolTip(held ? tr("Stop the line first (Ctrl+R)") : QString());
  reference_->setVisible(kind_ == RunsStudyKind::Accuracy);
  repeatabilityButton_->setChecked(kind_ == RunsStudyKind::Repeatability);
  accuracyButton_->setChecked(kind_ == RunsStudyKind::Accuracy);
  if (!study_ && problem_.isEmpty()) showStudy();
}

void QualityPage::setSource(Source source) {
  source_ = source;
  sources_->setCurrentIndex(static_cast<int>(source));
  study_.reset();
  problem_.clear();
  showRuns();
  showSource();
  showStudy();
}

void QualityPage::setRun(int row, bool chosen) {
  if (row >= 0 && row < runs_->rowCount()) runs_->item(row, 0)->setCheckState(chosen ? Qt::Checked : Qt::Unchecked);
}

void QualityPage::openRuns(const QString& file) {
  if (file.isEmpty()) return;
  reader_->ask("runs", [this, file](const Archive*, const std::string&) -> ArchiveReader::Answer {
    auto runs = readRuns(file.toStdString());
    return [this, file, runs = std::move(runs)] {
      if (!runs) {
        refuse(shown(runs.error().message()));
        return;
      }
      fileRuns_ = *runs;
      fileName_ = QFileInfo(file).fileName();
      setSource(Source::File);
      emit railsChanged();
    };
  });
}

void QualityPage::openReference(const QString& file) {
  if (file.isEmpty()) return;
  reader_->ask("reference", [this, file](const Archive*, const std::string&) -> ArchiveReader::Answer {
    auto reference = readReference(file.toStdString());
    return [this, reference = std::move(reference)] {
      if (!reference) {
        refuse(shown(reference.error().message()));
        return;
      }
      fileReference_ = *reference;
      study();
    };
  });
}

void QualityPage::runExperiment() {
  if (experiment_->running()) {
    experiment_->cancel();
    return;
  }
  if (place_.line.running()) {
    refuse(tr("Stop the line first (Ctrl+R): both need all processors, and no trigger may be lost to a study."));
    return;
  }
  const Recipe& recipe = *place_.line.pull(PullDetail::Profile).recipe;
  VirtualRigSettings rig;
  rig.section = recipe.section;
  rig.parameters = recipe.parameters;
  progress_->setValue(0);
  problem_.clear();
  study_.reset();
  experiment_->start(std::move(rig), recipe, length_->currentData().toDouble(), kExperimentRuns);
  showSource();
  showStudy();
}

void QualityPage::showKind(RunsStudyKind kind) {
  kind_ = kind;
  showSource();
  showStudy();
}

void QualityPage::choose(Dimension dimension) {
  if (dimension == dimension_) return;
  dimension_ = dimension;
  showStudy();
}

void QualityPage::refuse(const QString& problem) {
  problem_ = problem;
  study_.reset();
  showStudy();
  emit resultChanged();
}

void QualityPage::study() {
  std::vector<RailLine> stored;
  Runs read;
  for (int i = 0; i < runs_->rowCount(); ++i) {
    if (runs_->item(i, 0)->checkState() != Qt::Checked) continue;
    if (source_ == Source::Archive)
      stored.push_back(rails_[static_cast<std::size_t>(i)]);
    else
      read.push_back((source_ == Source::File ? fileRuns_ : rigRuns_)[static_cast<std::size_t>(i)]);
  }
  const std::size_t chosen = stored.size() + read.size();
  const bool accuracy = kind_ == RunsStudyKind::Accuracy;
  const bool referenced = !fileReference_.empty() || (source_ == Source::VirtualRig && !rigTruth_.empty());
  if (accuracy && !referenced) {
    refuse(
        tr("Accuracy needs a reference: open a CSV with the columns dimension, position_m, value and, if known, u."));
    return;
  }
  if (chosen < (accuracy ? 1U : 2U)) {
    refuse(accuracy ? tr("At least 1 run is needed, none is chosen.")
                    : tr("At least 2 runs of the same rail are needed, %1 chosen: choose %2 more. The paper took 5.")
                          .arg(chosen)
                          .arg(2 - chosen));
    return;
  }
  words_->setText(tr("reading …"));
  if (source_ == Source::Archive)
    studyStored(stored);
  else
    studyRead(read);
}

void QualityPage::studyStored(const std::vector<RailLine>& chosen) {
  RunsStudySettings settings;
  settings.windowM = window_->currentData().toDouble();
  reader_->ask(
      "study",
      [this, chosen, settings, reference = fileReference_, fallback = *place_.line.pull(PullDetail::Profile).recipe](
          const Archive* archive, const std::string& problem) -> ArchiveReader::Answer {
        const auto refused = [this](const std::string& words) -> ArchiveReader::Answer {
          return [this, words] { refuse(shown(words)); };
        };
        if (archive == nullptr) return refused(problem);
        const RailArchive rails(*archive);
        Runs runs;
        Recipe recipe = fallback;
        for (auto rail = chosen.rbegin(); rail != chosen.rend(); ++rail) {
          if (rail->section != chosen.front().section)
            return refused("rail " + rail->id + ": is a " + rail->section + ", rail " + chosen.front().id + " a " +
                           chosen.front().section + "; choose runs of one rail");
          const auto profiles = rails.profiles(rail->key);
          if (!profiles) return refused(profiles.error().message());
          runs.push_back(runOf(rail->id, *profiles));
        }
        // The limits are those that the rail was judged by.
        if (const auto stored = rails.open(chosen.front().key, 1))
          if (const auto text = rails.recipeText(*stored); text && !text->empty())
            if (auto kept = parseRecipe(*text, "recipe of rail " + chosen.front().id)) recipe = *kept;
        auto study = studyRuns(runs, reference, recipe.limits, settings);
        return [this, study = std::move(study), recipe = std::move(recipe)] { answer(study, recipe); };
      });
}

void QualityPage::studyRead(const Runs& chosen) {
  RunsStudySettings settings;
  settings.windowM = window_->currentData().toDouble();
  const RunReference reference = source_ == Source::VirtualRig && fileReference_.empty() ? rigTruth_ : fileReference_;
  reader_->ask("study",
               [this, chosen, reference, settings, recipe = *place_.line.pull(PullDetail::Profile).recipe](
                   const Archive*, const std::string&) -> ArchiveReader::Answer {
                 auto study = studyRuns(chosen, reference, recipe.limits, settings);
                 return [this, study = std::move(study), recipe] { answer(study, recipe); };
               });
}

void QualityPage::answer(const Expected<RunsStudy>& study, const Recipe& recipe) {
  if (!study) {
    refuse(shown(study.error().message()));
    return;
  }
  problem_.clear();
  study_ = std::make_shared<const RunsStudy>(*study);
  recipe_ = std::make_shared<const Recipe>(recipe);
  showStudy();
  emit resultChanged();
}

QString QualityPage::lengthText(double mm, bool withSign) const {
  const int decimals = place_.units.decimals(decimalsOf(dimension_)) + 1;
  const double value = place_.units.shown(mm);
  return withSign ? deviationText(value, decimals) : numberText(value, decimals);
}

QString QualityPage::conditions() const {
  switch (source_) {
    case Source::Archive:
      return tr("stored rails, same rail and gauge");
    case Source::File:
      return tr("file %1").arg(fileName_);
    case Source::VirtualRig:
      return tr("virtual rig, exact calibration, other wander, vibration, scale, speckle and noise in every run");
  }
  return {};
}

void QualityPage::showStudy() {
  report_->setEnabled(study_ != nullptr);
  export_->setEnabled(study_ != nullptr);
  const bool busy = experiment_->running();
  const bool empty = source_ == Source::Archive ? rails_.empty()
                     : source_ == Source::File  ? fileRuns_.empty()
                                                : rigRuns_.empty();
  words_->setText(busy                  ? tr("The same rail is inspected five times …")
                  : !problem_.isEmpty() ? problem_
                  : study_              ? tr("Conditions: %1.").arg(conditions())
                  : !empty              ? tr("Tick the runs that were made of the same rail and compare.")
                  : source_ == Source::Archive
                      ? tr("No rail has been kept yet. Runs of the same rail are compared here.")
                  : source_ == Source::File
                      ? tr("A CSV with the columns run, position_m and dimensions, as inspect --csv writes it.")
                  : place_.line.running() ? tr("Stop the line first (Ctrl+R): both need all processors.")
                                          : tr("The paper's experiment: one rail, five inspections, the truth known."));
  const QString message = tr("No runs are compared yet");
  if (kind_ == RunsStudyKind::Repeatability)
    showRepeatability();
  else
    showAccuracy();
  for (RunsPlot* plot : {upper_, lower_})
    if (plot->curves().isEmpty()) plot->setMessage(message);
  showTable();
  showFigures();
}

void QualityPage::showRepeatability() {
  upperPanel_->setTitle(tr("%1 over the length").arg(spoken(dimension_)));
  upperPanel_->setNote(tr("as Fig. 9a"));
  lowerPanel_->setTitle(tr("Range of the runs"));
  lowerPanel_->setNote(tr("largest minus smallest at each position, as Fig. 9b"));
  const RepeatabilityResult* r = result();
  if (r == nullptr) {
    upper_->show({}, {}, {});
    lower_->show({}, {}, {});
    return;
  }
  const Units& units = place_.units;
  QVector<RunCurve> curves;
  const QVector<double> x(r->positionM.begin(), r->positionM.end());
  for (std::size_t i = 0; i < r->runs.size(); ++i) {
    RunCurve curve{shown(r->runs[i]), x, {}, RunCurve::Look::Run};
    for (const double v : r->valueMm[i]) curve.y.append(units.shown(v));
    curves.append(curve);
  }
  QVector<RunLevel> levels;
  const auto nominals = nominalDimensions(recipe_->section, recipe_->parameters);
  const auto nominal = nominals ? (*nominals)[index(dimension_)] : std::nullopt;
  if (nominal) {
    const ToleranceLimits& limits = recipe_->limits[index(dimension_)];
    const auto text = [&](const QString& word, double mm) {
      return word + ' ' + numberText(units.shown(mm), units.decimals(decimalsOf(dimension_)));
    };
    levels.append({units.shown(*nominal), text(tr("expected"), *nominal), false});
    if (limits.lowerMm)
      levels.append(
          {units.shown(*nominal + *limits.lowerMm), text(tr("lower limit"), *nominal + *limits.lowerMm), true});
    if (limits.upperMm)
      levels.append(
          {units.shown(*nominal + *limits.upperMm), text(tr("upper limit"), *nominal + *limits.upperMm), true});
  }
  upper_->show(tr("length, m"), QStringLiteral("%1, %2").arg(spoken(dimension_), units.name()), curves, levels);
  RunCurve range{tr("range"), x, {}, RunCurve::Look::Run};
  for (const double v : r->rangeMm) range.y.append(units.shown(v));
  RunCurve means{tr("mean of %1 m").arg(study_->sectionM), {}, {}, RunCurve::Look::Mean};
  const double last = r->positionM.empty() ? 0 : r->positionM.back();
  for (const RepeatabilitySection& s : r->sections) {
    const double to = std::min(s.toM, last);
    means.x << s.fromM << to << to;
    means.y << units.shown(s.meanRangeMm) << units.shown(s.meanRangeMm) << std::numeric_limits<double>::quiet_NaN();
  }
  lower_->show(tr("length, m"), tr("range, %1").arg(units.name()), {range, means});
}

void QualityPage::showAccuracy() {
  upperPanel_->setTitle(tr("Error of %1 over the length").arg(spoken(dimension_)));
  upperPanel_->setNote(study_ ? tr("value minus reference, mean of the runs; %1").arg(shown(study_->reference))
                              : tr("value minus reference"));
  lowerPanel_->setTitle(tr("Largest error at each position"));
  lowerPanel_->setNote(tr("of any run"));
  const AccuracyResult* r = accuracy();
  if (r == nullptr) {
    upper_->show({}, {}, {});
    lower_->show({}, {}, {});
    return;
  }
  const Units& units = place_.units;
  const bool sparse = r->positionM.size() < 100;
  const RunCurve::Look look = sparse ? RunCurve::Look::Dots : RunCurve::Look::Run;
  RunCurve bias{tr("mean"), {}, {}, look}, largest{tr("largest"), {}, {}, look};
  for (std::size_t i = 0; i < r->positionM.size(); ++i) {
    bias.x.append(r->positionM[i]);
    bias.y.append(units.shown(r->perPosition[i].bias));
    largest.x.append(r->positionM[i]);
    largest.y.append(units.shown(r->perPosition[i].max));
  }
  QVector<RunLevel> levels = {{0, tr("no error"), false}};
  if (r->agreement) {
    levels.append({units.shown(r->agreement->limits.low), tr("limit of agreement"), true});
    levels.append({units.shown(r->agreement->limits.high), tr("limit of agreement"), true});
  }
  const QString axis = tr("error, %1").arg(units.name());
  upper_->show(tr("length, m"), axis, {bias}, levels);
  lower_->show(tr("length, m"), axis, {largest}, {{0, QString(), false}});
}

void QualityPage::showTable() {
  const QSignalBlocker quiet(table_);
  const bool repeatability = kind_ == RunsStudyKind::Repeatability;
  const Units& units = place_.units;
  QStringList heads = {tr("Dim.")};
  const int width = table_->viewport()->width();
  std::size_t sections = 0, fitting = 0;
  const RepeatabilityResult* longest = nullptr;
  if (repeatability) {
    if (study_)
      for (const DimensionStudy& d : study_->dimensions)
        if (d.repeatability && d.repeatability->sections.size() > sections) {
          longest = &*d.repeatability;
          sections = longest->sections.size();
        }
    fitting = std::min(sections, static_cast<std::size_t>(std::max(0, (width - kNameWidth) / kFigureWidth - 4)));
    for (std::size_t s = 0; s < fitting; ++s)
      heads << tr("%1 m").arg(std::min(longest->sections[s].toM, std::ceil(longest->positionM.back())));
    heads << tr("mean") << QStringLiteral("s r") << QStringLiteral("r") << tr("% T");
    tablePanel_->setTitle(tr("Mean range per %1 m").arg(study_ ? study_->sectionM : 10));
    tablePanel_->setNote(!study_              ? tr("as Table VI")
                         : fitting < sections ? tr("%1, as Table VI; the stretches are in the report").arg(units.name())
                                              : tr("%1, as Table VI").arg(units.name()));
  } else {
    heads << QStringLiteral("n") << tr("bias") << QStringLiteral("RMS") << tr("largest") << tr("%");
    tablePanel_->setTitle(tr("Errors"));
    tablePanel_->setNote(study_ ? tr("%1, as Table V").arg(units.name()) : tr("as Table V"));
  }
  table_->setColumnCount(static_cast<int>(heads.size()));
  table_->setHorizontalHeaderLabels(heads);
  for (int c = 1; c < heads.size(); ++c)
    table_->horizontalHeaderItem(c)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  for (int row = 0; row < static_cast<int>(kDimensionCount); ++row) {
    const Dimension d = kDimensions[static_cast<std::size_t>(row)];
    const int decimals = units.decimals(decimalsOf(d));
    const auto mm = [&](double v) { return numberText(units.shown(v), decimals); };
    const auto off = [&](double v) { return deviationText(units.shown(v), decimals); };
    QStringList cells = {spoken(d)};
    QString why;
    if (study_) {
      const DimensionStudy& is = study_->dimensions[index(d)];
      if (repeatability && is.repeatability) {
        for (std::size_t s = 0; s < fitting; ++s)
          cells << (s < is.repeatability->sections.size() ? mm(is.repeatability->sections[s].meanRangeMm)
                                                          : QStringLiteral("–"));
        cells << mm(is.repeatability->meanRangeMm) << mm(is.repeatability->srMm) << mm(is.repeatability->rMm)
              << (is.sharePercent ? numberText(*is.sharePercent, 1) : QStringLiteral("–"));
      } else if (!repeatability && is.accuracy) {
        const AccuracyFigures& f = is.accuracy->whole;
        cells << count(f.n) << off(f.bias) << mm(f.rms) << off(f.max)
              << (f.maxPercent && percentMeans(d) ? deviationText(*f.maxPercent, 2) : QStringLiteral("–"));
      }
      why = shown(repeatability ? is.whyNotRepeatability : is.whyNotAccuracy);
    }
    while (cells.size() < heads.size()) cells << QStringLiteral("–");
    for (int c = 0; c < cells.size(); ++c) {
      table_->setItem(row, c, cell(cells[c], c > 0));
      table_->item(row, c)->setToolTip(why);
    }
  }
  table_->setFont(uiFont(width < 520 ? 15 : 16));
  table_->setColumnWidth(0, kNameWidth);
  const int each = (width - kNameWidth) / std::max(1, static_cast<int>(heads.size()) - 1);
  for (int c = 1; c < heads.size(); ++c) table_->setColumnWidth(c, each);
  const int height = std::clamp(table_->viewport()->height() / static_cast<int>(kDimensionCount), kLeastRow, kMostRow);
  table_->verticalHeader()->setDefaultSectionSize(height);
  table_->selectRow(static_cast<int>(index(dimension_)));
}

void QualityPage::showFigures() {
  const bool shownOne = study_ != nullptr;
  const StudyVerdict verdict = shownOne ? verdictOf(*study_, kind_) : StudyVerdict{};
  for (QWidget* w : std::initializer_list<QWidget*>{symbol_, verdict_}) w->setVisible(shownOne);
  symbol_->setPixmap(symbolOf(verdict.standing, place_.theme.palette()));
  verdict_->setText(verdict.word);
  reason_->setText(shownOne ? verdict.reason
                            : tr("Verdict, figures, formulas and constants stand here when runs are compared."));
  figurePanel_->setNote(shownOne ? tr("figures of %1").arg(spoken(dimension_)) : QString());
  std::vector<std::pair<QString, QString>> rows;
  if (kind_ == RunsStudyKind::Repeatability && result() != nullptr) rows = figuresOf(*result(), dimension_);
  if (kind_ == RunsStudyKind::Accuracy && accuracy() != nullptr) rows = figuresOf(*accuracy(), dimension_);
  figures_->clearSpans();
  figures_->setRowCount(static_cast<int>(rows.size()));
  const int width = figures_->viewport()->width();
  figures_->setColumnWidth(0, width * 45 / 100);
  for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
    const auto& [label, value] = rows[static_cast<std::size_t>(i)];
    figures_->setItem(i, 0, cell(label, false));
    figures_->setItem(i, 1, cell(value, true));
    figures_->item(i, 1)->setToolTip(value);
    if (value.isEmpty()) figures_->setSpan(i, 0, 1, 2);
  }
  figures_->resizeRowsToContents();
}

void QualityPage::saveReport(const QString& pdfFile) {
  if (!study_ || pdfFile.isEmpty()) return;
  words_->setText(tr("writing …"));
  const Document document =
      studyReport(*study_, kind_, dimension_, *recipe_, conditions(), source_ == Source::VirtualRig);
  reader_->ask("report",
               [this, document, pdfFile, version = QCoreApplication::applicationVersion().toStdString()](
                   const Archive*, const std::string&) -> ArchiveReader::Answer {
                 const auto done = writeDocument(document, version, pdfFile.toStdString());
                 return [this, done, pdfFile] {
                   words_->setText(done ? tr("%1 is written.").arg(pdfFile) : shown(done.error().message()));
                   emit saved();
                 };
               });
}

void QualityPage::saveValues(const QString& csvFile) {
  if (!study_ || csvFile.isEmpty()) return;
  QString text;
  if (const RepeatabilityResult* r = result(); kind_ == RunsStudyKind::Repeatability && r != nullptr) {
    text = QStringLiteral("position_m");
    for (const std::string& run : r->runs)
      text += ',' + QString('"') + shown(run).replace('"', QStringLiteral("\"\"")) + '"';
    text += QStringLiteral(",range_mm\n");
    for (std::size_t i = 0; i < r->positionM.size(); ++i) {
      text += QString::number(r->positionM[i], 'f', 4);
      for (const auto& run : r->valueMm) text += ',' + QString::number(run[i], 'f', 6);
      text += ',' + QString::number(r->rangeMm[i], 'f', 6) + '\n';
    }
  } else if (const AccuracyResult* a = accuracy(); kind_ == RunsStudyKind::Accuracy && a != nullptr) {
    text = QStringLiteral("position_m,n,bias_mm,rms_mm,max_mm\n");
    for (std::size_t i = 0; i < a->positionM.size(); ++i) {
      const AccuracyFigures& f = a->perPosition[i];
      text += QString::number(a->positionM[i], 'f', 4) + ',' + QString::number(f.n) + ',' +
              QString::number(f.bias, 'f', 6) + ',' + QString::number(f.rms, 'f', 6) + ',' +
              QString::number(f.max, 'f', 6) + '\n';
    }
  }
  QSaveFile out(csvFile);
  const bool done = out.open(QIODevice::WriteOnly) && out.write(text.toUtf8()) >= 0 && out.commit();
  words_->setText(done ? tr("%1 is written.").arg(csvFile) : tr("%1 cannot be written.").arg(csvFile));
  emit saved();
}

}  // namespace vignole
