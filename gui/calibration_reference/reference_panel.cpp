#include "gui/calibration_reference/reference_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <cmath>

#include "gui/calibration_records/worth_table.h"
#include "gui/theme/inscription.h"
#include "gui/theme/panel.h"
#include "gui/theme/state_icon.h"
#include "report/dimension_text.h"

namespace vignole {

ReferencePanel::ReferencePanel(Workplace& place, QWidget* parent) : QWidget(parent), place_(place) {
  panel_ = new Panel(this);
  panel_->setMinimumWidth(300);
  words_ = makeLabel(16, 400, "t1", panel_, true);
  countWord_ = makeLabel(16, 400, "t2", panel_, true);
  count_ = new QSpinBox(panel_);
  count_->setRange(10, 500);
  count_->setValue(60);
  count_->setFont(uiFont(16));
  count_->setMinimumHeight(44);
  count_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  start_ = makeButton(place.theme, QStringLiteral("play"), panel_, true);
  cancel_ = makeButton(place.theme, QStringLiteral("reject"), panel_);
  stopLine_ = makeButton(place.theme, QStringLiteral("pause"), panel_, true);
  leave_ = makeButton(place.theme, QStringLiteral("back"), panel_);
  progress_ = new QProgressBar(panel_);
  progress_->setRange(0, 100);
  progress_->setTextVisible(false);
  for (QWidget* w : std::initializer_list<QWidget*>{words_, countWord_, count_, start_, stopLine_, progress_, cancel_})
    panel_->content()->addWidget(w);
  panel_->content()->addStretch(1);
  panel_->content()->addWidget(leave_);
  tablePanel_ = new Panel(this);
  sentence_ = makeLabel(18, 500, "t1", tablePanel_, true);
  table_ = new QTableWidget(0, 6, tablePanel_);
  styleTable(*table_);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->setIconSize({16, 16});
  table_->verticalHeader()->setMinimumSectionSize(24);
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  tablePanel_->content()->addWidget(sentence_);
  tablePanel_->content()->addWidget(table_, 1);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(12);
  row->addWidget(panel_, 2);
  row->addWidget(tablePanel_, 7);
  connect(start_, &QPushButton::clicked, this, &ReferencePanel::start);
  connect(cancel_, &QPushButton::clicked, &job_, &BackgroundJob::cancel);
  connect(stopLine_, &QPushButton::clicked, this, [this] { place_.line.stop(); });
  connect(leave_, &QPushButton::clicked, this, [this] {
    job_.cancel();
    emit left();
  });
  connect(&job_, &BackgroundJob::progressed, this,
          [this](double share, const QString&) { progress_->setValue(static_cast<int>(std::lround(100 * share))); });
  connect(&place_.units, &Units::changed, this, &ReferencePanel::showAll);
  connect(&place_.theme, &Theme::changed, this, &ReferencePanel::showAll);
  retranslate();
}

ReferencePanel::~ReferencePanel() = default;

void ReferencePanel::retranslate() {
  const auto name = [](QPushButton* button, const QString& text) {
    button->setText(text);
    button->setAccessibleName(text);
  };
  panel_->setTitle(tr("Reference piece"));
  tablePanel_->setTitle(tr("Certificate and gauge"));
  countWord_->setText(tr("Profiles that are averaged"));
  count_->setAccessibleName(tr("Profiles that are averaged"));
  progress_->setAccessibleName(tr("Progress of the check"));
  name(start_, tr("Measure the piece"));
  name(cancel_, tr("Cancel"));
  name(leave_, tr("Leave"));
  name(stopLine_, tr("Stop the line"));
  table_->setAccessibleName(tr("Certificate and gauge"));
  showAll();
}

void ReferencePanel::begin() {
  result_.reset();
  problem_.clear();
  calibration_ = QString::fromStdString(place_.line.calibration().id);
  showAll();
}

void ReferencePanel::showLine(const LineSnapshot& line) {
  const bool runs = place_.line.running() || line.state == LineState::Measuring;
  if (runs == lineRuns_) return;
  lineRuns_ = runs;
  if (runs) job_.cancel();
  showAll();
}

void ReferencePanel::start() {
  result_.reset();
  problem_.clear();
  progress_->setValue(0);
  ReferenceSettings settings;
  settings.recipe = *place_.line.pull(PullDetail::Profile).recipe;
  settings.calibration = place_.line.calibration();
  settings.rigSeed = place_.line.virtualRigSeed().value_or(0);
  settings.profiles = count_->value();
  calibration_ = QString::fromStdString(settings.calibration.id);
  job_.start([this, settings](const Job& job) -> BackgroundJob::Result {
    auto result = checkVirtualReference(settings, job);
    const bool cancelled = job.cancelled();
    return [this, result = std::move(result), cancelled] {
      if (result)
        result_ = *result;
      else
        problem_ = cancelled ? tr("Cancelled: nothing has changed.") : QString::fromStdString(result.error().message());
      QMetaObject::invokeMethod(
          this,
          [this] {
            showAll();
            emit checked();
          },
          Qt::QueuedConnection);
    };
  });
  showAll();
}

void ReferencePanel::showAll() {
  const bool rig = place_.line.virtualRigSeed().has_value(), works = job_.running();
  panel_->setNote(calibration_);
  words_->setText(
      !rig ? tr("There is no rig to look through: the wizards look through the virtual rig alone.")
      : lineRuns_
          ? tr("Closed while the line measures: the piece stands where the rail passes. Stop the line to go on.")
          : tr("A section with a certificate is put into the gauge and measured with the calibration in "
               "force. On the virtual rig it is a virtual piece, whose truth is its certificate "
               "(U = 2 µm)."));
  start_->setVisible(!lineRuns_);
  start_->setEnabled(rig && !works);
  count_->setEnabled(!works);
  stopLine_->setVisible(lineRuns_);
  cancel_->setVisible(works);
  progress_->setVisible(works);
  const Palette& p = place_.theme.palette();
  if (!problem_.isEmpty())
    sentence_->setText(problem_);
  else if (works)
    sentence_->setText(tr("Measuring…"));
  else if (!result_)
    sentence_->setText(tr("Next: measure the piece."));
  else if (result_->agrees())
    sentence_->setText(tr("The gauge agrees with the certificate in every dimension, over %n profile(s).", nullptr,
                          result_->profiles));
  else
    sentence_->setText(
        tr("The gauge does not agree with the certificate. Next: clean the piece and measure again; if "
           "it stays so, calibrate the range finders."));
  const QString unit = place_.units.name();
  table_->setHorizontalHeaderLabels({tr("Dimension"), tr("Certificate %1").arg(unit), tr("Measured %1").arg(unit),
                                     tr("Deviation"), tr("U (k = 2)"), tr("Deviation over U")});
  for (int c = 1; c < 6; ++c) table_->horizontalHeaderItem(c)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  table_->setRowCount(result_ ? static_cast<int>(result_->rows.size()) : 0);
  for (int row = 0; row < table_->rowCount(); ++row) {
    const ReferenceRow& r = result_->rows[static_cast<std::size_t>(row)];
    const auto put = [&](int column, const QString& text, bool right) {
      auto* item = new QTableWidgetItem(text);
      item->setTextAlignment((right ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
      if (!r.agrees()) item->setBackground(p.outSoft);
      table_->setItem(row, column, item);
      return item;
    };
    const int decimals = decimalsOf(r.dimension);
    put(0, r.agrees() ? spoken(r.dimension) : tr("%1, differs").arg(spoken(r.dimension)), false)
        ->setIcon(stateIcon(!r.measuredMm ? StateSymbol::NotMeasured
                            : r.agrees()  ? StateSymbol::Good
                                          : StateSymbol::Out,
                            p));
    put(1, lengthText(r.certifiedMm, place_.units, decimals), true);
    put(2,
        r.measuredMm ? lengthText(r.measuredMm, place_.units, decimals)
                     : tr("not measured: %1").arg(QString::fromStdString(r.reason)),
        true);
    if (!r.measuredMm) continue;
    put(3, deviationText(place_.units.shown(*r.measuredMm - r.certifiedMm), place_.units.decimals(decimals)), true);
    put(4, lengthText(2 * std::hypot(r.uMeasuredMm, r.uCertifiedMm), place_.units, decimals), true);
    put(5, numberText(*r.normalisedError(), 2), true);
  }
}

}  // namespace vignole
