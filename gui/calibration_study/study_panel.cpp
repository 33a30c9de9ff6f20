#include "gui/calibration_study/study_panel.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QTemporaryDir>
#include <cmath>
#include <variant>

#include "calibration/assessment/existing_calibration.h"
#include "gui/calibration_rig/plate_stand.h"
#include "gui/calibration_study/study_material.h"
#include "gui/plots/plot_picture.h"
#include "gui/theme/panel.h"
#include "report/document_pages.h"
#include "report/study_document.h"

namespace vignole {

namespace {

QString shown(const std::string& text) { return QString::fromStdString(text); }

/// The paper's factors; what somebody changes first stands first.
struct StudyFactorRow {
  const char* name;
  const char* levels;
};
constexpr std::array<StudyFactorRow, 4> kFactors = {
    {{"exposure_ms", "10, 15"}, {"sigma_px", "1.5, 2, 3"}, {"max_ellipses", "13, 9"}, {"fit", ""}}};

}  // namespace

StudyPanel::StudyPanel(Workplace& place, QWidget* parent) : QWidget(parent), place_(place) {
  panel_ = new Panel(this);
  panel_->setMinimumWidth(330);
  words_ = makeLabel(15, 400, "t2", panel_, true);
  factors_ = new QTableWidget(static_cast<int>(kFactors.size()), 2, panel_);
  styleTable(*factors_);
  factors_->setEditTriggers(QAbstractItemView::AllEditTriggers);
  factors_->setSelectionMode(QAbstractItemView::NoSelection);
  factors_->verticalHeader()->setDefaultSectionSize(44);
  factors_->setFixedHeight(4 * 44 + 36);
  for (int row = 0; row < factors_->rowCount(); ++row) {
    auto* name = new QTableWidgetItem;
    name->setData(Qt::UserRole, QLatin1String(kFactors[static_cast<std::size_t>(row)].name));
    name->setFlags(Qt::ItemIsEnabled);
    factors_->setItem(row, 0, name);
    factors_->setItem(row, 1, new QTableWidgetItem(QLatin1String(kFactors[static_cast<std::size_t>(row)].levels)));
  }
  factors_->setColumnWidth(0, 140);
  countWord_ = makeLabel(15, 400, "t2", panel_, true);
  count_ = new QSpinBox(panel_);
  count_->setRange(1, 4);
  count_->setValue(2);
  count_->setFont(uiFont(16));
  count_->setMinimumHeight(44);
  count_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  start_ = makeButton(place.theme, QStringLiteral("play"), panel_, true);
  stopLine_ = makeButton(place.theme, QStringLiteral("pause"), panel_, true);
  cancel_ = makeButton(place.theme, QStringLiteral("reject"), panel_);
  leave_ = makeButton(place.theme, QStringLiteral("back"), panel_);
  progress_ = new QProgressBar(panel_);
  progress_->setRange(0, 100);
  progress_->setTextVisible(false);
  for (QWidget* w :
       std::initializer_list<QWidget*>{words_, factors_, countWord_, count_, start_, stopLine_, progress_, cancel_})
    panel_->content()->addWidget(w);
  panel_->content()->addStretch(1);
  panel_->content()->addWidget(leave_);

  resultPanel_ = new Panel(this);
  report_ = makeButton(place.theme, QStringLiteral("report"), resultPanel_);
  resultPanel_->head()->addWidget(report_);
  sentence_ = makeLabel(18, 500, "t1", resultPanel_, true);
  reason_ = makeLabel(15, 400, "t2", resultPanel_, true);
  resultPanel_->content()->addWidget(sentence_);
  resultPanel_->content()->addWidget(reason_);
  auto* plots = new QGridLayout;
  plots->setSpacing(8);
  for (std::size_t i = 0; i < plots_.size(); ++i) {
    plots_[i] = new PlotPicture(place.theme, resultPanel_);
    plots->addWidget(plots_[i], static_cast<int>(i / 2), static_cast<int>(i % 2));
  }
  resultPanel_->content()->addLayout(plots, 3);
  influence_ = new QTableWidget(0, 1, resultPanel_);
  styleTable(*influence_);
  influence_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  influence_->setSelectionMode(QAbstractItemView::NoSelection);
  influence_->verticalHeader()->setDefaultSectionSize(28);
  resultPanel_->content()->addWidget(influence_, 2);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(12);
  row->addWidget(panel_, 2);
  row->addWidget(resultPanel_, 7);
  connect(start_, &QPushButton::clicked, this, &StudyPanel::start);
  connect(cancel_, &QPushButton::clicked, &job_, &BackgroundJob::cancel);
  connect(stopLine_, &QPushButton::clicked, this, [this] { place_.line.stop(); });
  connect(report_, &QPushButton::clicked, this, &StudyPanel::saveReport);
  connect(leave_, &QPushButton::clicked, this, [this] {
    job_.cancel();
    emit left();
  });
  connect(&job_, &BackgroundJob::progressed, this, [this](double share, const QString& doing) {
    progress_->setValue(static_cast<int>(std::lround(100 * share)));
    sentence_->setText(doing);
  });
  retranslate();
}

StudyPanel::~StudyPanel() = default;

void StudyPanel::retranslate() {
  const auto name = [](QPushButton* button, const QString& text) {
    button->setText(text);
    button->setAccessibleName(text);
  };
  panel_->setTitle(tr("Parameter study"));
  resultPanel_->setTitle(tr("Main effects"));
  factors_->setHorizontalHeaderLabels({tr("Setting"), tr("Levels")});
  factors_->setAccessibleName(tr("Settings and their levels"));
  const QStringList words = {tr("Exposure, ms"), tr("Smoothing σ, px"), tr("Ellipses a pin"), tr("Fit")};
  for (int row = 0; row < factors_->rowCount(); ++row) factors_->item(row, 0)->setText(words[row]);
  influence_->setAccessibleName(tr("Influence of each setting"));
  countWord_->setText(tr("Placements of the plate"));
  count_->setAccessibleName(tr("Placements of the plate for the study"));
  progress_->setAccessibleName(tr("Progress of the study"));
  name(start_, tr("Start the study"));
  name(cancel_, tr("Cancel"));
  name(leave_, tr("Leave"));
  name(stopLine_, tr("Stop the line"));
  name(report_, tr("Report…"));
  showAll();
}

void StudyPanel::begin() {
  study_.reset();
  problem_.clear();
  showAll();
}

void StudyPanel::showLine(const LineSnapshot& line) {
  const bool runs = place_.line.running() || line.state == LineState::Measuring;
  if (runs == lineRuns_) return;
  lineRuns_ = runs;
  if (runs) job_.cancel();
  showAll();
}

void StudyPanel::setLevels(const QString& factor, const QString& levels) {
  for (int row = 0; row < factors_->rowCount(); ++row)
    if (factors_->item(row, 0)->data(Qt::UserRole) == factor) factors_->item(row, 1)->setText(levels);
}

std::string StudyPanel::planText() const {
  QString text = QStringLiteral(
      "format = 1\n[fixed]\nmethod = \"paper\"\nassociation = \"robust\"\n[design]\nmax_runs = 200\n"
      "[analysis]\nresponse = \"cd_mm\"\ninteractions = true\n");
  for (int row = 0; row < factors_->rowCount(); ++row) {
    QStringList levels;
    for (const QString& part : factors_->item(row, 1)->text().split(QLatin1Char(','), Qt::SkipEmptyParts)) {
      const QString level = part.trimmed();
      bool number = false;
      (void)level.toDouble(&number);
      levels << (number ? level : QLatin1Char('"') + level + QLatin1Char('"'));
    }
    if (levels.size() > 1)
      text += QStringLiteral("[[factor]]\nname = \"%1\"\nlevels = [%2]\n")
                  .arg(factors_->item(row, 0)->data(Qt::UserRole).toString(), levels.join(QStringLiteral(", ")));
  }
  return text.toStdString();
}

void StudyPanel::start() {
  study_.reset();
  problem_.clear();
  const RigCalibration calibration = place_.line.calibration();
  const Recipe recipe = *place_.line.pull(PullDetail::Profile).recipe;
  auto plan = parseStudyPlan(planText(), tr("settings and levels").toStdString());
  auto known = inputsFor(calibration, certifiedPlate());
  pictures_ = std::make_unique<QTemporaryDir>();
  if (!plan)
    problem_ = shown(plan.error().message());
  else if (!known)
    problem_ = shown(known.error().message());
  else if (!pictures_->isValid())
    problem_ = pictures_->errorString();
  if (!problem_.isEmpty()) {
    showAll();
    emit studied();
    return;
  }
  VirtualStudySettings settings;
  settings.plan = *std::move(plan);
  settings.known = *std::move(known);
  settings.rigSeed = place_.line.virtualRigSeed().value_or(0);
  settings.placements = count_->value();
  settings.section = recipe.section;
  settings.parameters = recipe.parameters;
  settings.rig = calibration;
  settings.folder = pictures_->path().toStdString();
  progress_->setValue(0);
  job_.start([this, settings](const Job& job) -> BackgroundJob::Result {
    auto study = runVirtualStudy(settings, job);
    const bool cancelled = job.cancelled();
    return [this, study = std::move(study), cancelled] {
      if (study)
        study_ = *study;
      else
        problem_ = cancelled ? tr("Cancelled: nothing has changed.") : shown(study.error().message());
      QMetaObject::invokeMethod(
          this,
          [this] {
            pictures_.reset();
            showAll();
            emit studied();
          },
          Qt::QueuedConnection);
    };
  });
  showAll();
}

void StudyPanel::saveReport() {
  if (!study_) return;
  const QString file =
      QFileDialog::getSaveFileName(this, tr("Report of the study"), QStringLiteral("study.pdf"), tr("PDF (*.pdf)"));
  if (file.isEmpty()) return;
  const auto version = QCoreApplication::applicationVersion().toStdString();
  reportJob_.start([this, study = *study_, version, path = file.toStdString()](const Job&) -> BackgroundJob::Result {
    Document document = studyDocument(study, std::to_string(study.runs.size()) + " calibrations");
    document.simulation = true;
    const auto written = writeDocument(document, version, path);
    return [this, written, path] {
      reason_->setText(written ? tr("Written: %1").arg(shown(path)) : shown(written.error().message()));
    };
  });
}

void StudyPanel::showAll() {
  const bool rig = place_.line.virtualRigSeed().has_value(), works = job_.running();
  words_->setText(
      !rig        ? tr("There is no rig to look through: the wizards look through the virtual rig alone.")
      : lineRuns_ ? tr("Closed while the line measures: the plate stands where the rail passes. Stop the line to go "
                       "on.")
                  : tr("Every combination of the levels is a calibration by the paper's method on pictures of the "
                       "plate. Levels are parted by commas; one level or none: the setting is not varied."));
  start_->setVisible(!lineRuns_);
  start_->setEnabled(rig && !works);
  factors_->setEnabled(!works);
  count_->setEnabled(!works);
  stopLine_->setVisible(lineRuns_);
  cancel_->setVisible(works);
  progress_->setVisible(works);
  report_->setEnabled(study_.has_value());
  influence_->setRowCount(0);
  influence_->setVisible(study_.has_value());
  std::size_t plot = 0;
  reason_->clear();
  if (!study_) {
    sentence_->setText(!problem_.isEmpty() ? problem_ : works ? tr("Working…") : tr("Next: choose levels and start."));
  } else {
    bool table = false;
    const Document document = studyDocument(*study_, {});
    for (const Block& block : document.blocks) {
      if (const auto* verdict = std::get_if<VerdictLine>(&block)) {
        sentence_->setText(shown(verdict->headline));
        reason_->setText(shown(verdict->reason));
      } else if (const auto* plots = std::get_if<PlotBlock>(&block)) {
        for (const Plot& p : plots->plots)
          if (plot < plots_.size()) plots_[plot++]->show(p);
      } else if (const auto* rows = std::get_if<TableBlock>(&block); rows != nullptr && !table) {
        table = true;
        QStringList heads;
        for (const std::string& head : rows->heads) heads << shown(head.starts_with('<') ? head.substr(1) : head);
        influence_->setColumnCount(static_cast<int>(heads.size()));
        influence_->setHorizontalHeaderLabels(heads);
        influence_->setRowCount(static_cast<int>(rows->rows.size()));
        for (int r = 0; r < influence_->rowCount(); ++r)
          for (int c = 0; c < influence_->columnCount(); ++c) {
            const auto& cells = rows->rows[static_cast<std::size_t>(r)];
            if (static_cast<std::size_t>(c) < cells.size())
              influence_->setItem(r, c, new QTableWidgetItem(shown(cells[static_cast<std::size_t>(c)])));
          }
      }
    }
  }
  for (std::size_t i = 0; i < plots_.size(); ++i) plots_[i]->setVisible(i < plot);
}

}  // namespace vignole
