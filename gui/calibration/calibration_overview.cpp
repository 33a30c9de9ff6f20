#include "gui/calibration/calibration_overview.h"

#include <QBoxLayout>
#include <QDateTime>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QTableWidget>
#include <algorithm>
#include <chrono>
#include <cmath>

#include "engine/optics/calibration_age.h"
#include "gui/calibration/drift_panel.h"
#include "gui/calibration/frames_drawing.h"
#include "gui/calibration_records/calibration_desk.h"
#include "gui/calibration_records/worth_table.h"
#include "gui/theme/inscription.h"
#include "gui/theme/panel.h"
#include "gui/theme/state_icon.h"
#include "report/dimension_text.h"

namespace vignole {

namespace {

QString shown(const std::string& text) { return QString::fromStdString(text); }
QString timeText(TimeUs us) {
  return QDateTime::fromMSecsSinceEpoch(us / 1000).toString(QStringLiteral("yyyy-MM-dd HH:mm"));
}

}  // namespace

CalibrationOverview::CalibrationOverview(Workplace& place, CalibrationDesk& desk, QWidget* parent)
    : QWidget(parent), place_(place), desk_(desk) {
  inForcePanel_ = new Panel(this);
  name_ = makeLabel(22, 500, "t1", inForcePanel_, true);
  age_ = makeLabel(16, 500, "t1", inForcePanel_, true);
  facts_ = makeLabel(15, 400, "t2", inForcePanel_, true);
  for (QWidget* w : std::initializer_list<QWidget*>{name_, age_, facts_}) inForcePanel_->content()->addWidget(w);
  inForcePanel_->content()->addStretch(1);
  frames_ = new FramesDrawing(place_.theme, inForcePanel_);
  frames_->hide();  // until there is room
  inForcePanel_->content()->addWidget(frames_, 4);

  wizardPanel_ = new Panel(this);
  wizardWords_ = makeLabel(15, 400, "t2", wizardPanel_, true);
  rigWizard_ = makeButton(place.theme, QStringLiteral("calibration"), wizardPanel_, true);
  wizardPanel_->content()->addWidget(wizardWords_);
  lensWizard_ = makeButton(place.theme, QStringLiteral("camera"), wizardPanel_);
  wizardPanel_->content()->addWidget(rigWizard_);
  wizardPanel_->content()->addWidget(lensWizard_);
  encoder_ = makeButton(place.theme, QStringLiteral("rails"), wizardPanel_);
  wizardPanel_->content()->addWidget(encoder_);
  connect(encoder_, &QPushButton::clicked, this, &CalibrationOverview::encoderAsked);
  reference_ = makeButton(place.theme, QStringLiteral("approve"), wizardPanel_);
  study_ = makeButton(place.theme, QStringLiteral("charts"), wizardPanel_);
  wizardPanel_->content()->addWidget(reference_);
  wizardPanel_->content()->addWidget(study_);
  connect(reference_, &QPushButton::clicked, this, &CalibrationOverview::referenceAsked);
  connect(study_, &QPushButton::clicked, this, &CalibrationOverview::studyAsked);
  connect(lensWizard_, &QPushButton::clicked, this, &CalibrationOverview::lensWizardAsked);
  wizardPanel_->content()->addStretch(1);
  connect(rigWizard_, &QPushButton::clicked, this, &CalibrationOverview::rigWizardAsked);

  worthPanel_ = new Panel(this);
  dimensions_ = new QTableWidget(0, 5, worthPanel_);
  styleTable(*dimensions_);
  dimensions_->setSelectionMode(QAbstractItemView::NoSelection);
  dimensions_->setIconSize({16, 16});
  dimensions_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  dimensions_->verticalHeader()->setMinimumSectionSize(20);
  dimensions_->verticalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  worthPanel_->content()->addWidget(dimensions_, 1);

  historyPanel_ = new Panel(this);
  historyWords_ = makeLabel(16, 400, "t2", historyPanel_, true);
  history_ = new QTableWidget(0, 4, historyPanel_);
  styleTable(*history_);
  history_->setIconSize({16, 16});
  history_->setMinimumHeight(112);
  history_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
  history_->verticalHeader()->setDefaultSectionSize(36);
  for (const int column : {0, 3}) history_->horizontalHeader()->setSectionResizeMode(column, QHeaderView::Stretch);
  for (const int column : {1, 2})
    history_->horizontalHeader()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
  reason_ = new QLineEdit(historyPanel_);
  reason_->setFont(uiFont(16));
  revert_ = makeButton(place.theme, QStringLiteral("revert"), historyPanel_);
  resultWords_ = makeLabel(15, 500, "t1", historyPanel_, true);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(reason_, 1);
  row->addWidget(revert_);
  historyPanel_->content()->addWidget(historyWords_);
  historyPanel_->content()->addWidget(history_, 1);
  historyPanel_->content()->addLayout(row);
  historyPanel_->content()->addWidget(resultWords_);
  connect(history_, &QTableWidget::itemSelectionChanged, this, &CalibrationOverview::compareChosen);
  connect(revert_, &QPushButton::clicked, this, &CalibrationOverview::revert);

  drift_ = new DriftPanel(place.theme, place.units, this);

  auto* columns = new QHBoxLayout(this);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(12);
  const auto stacked = [columns](QWidget* upper, int upperShare, QWidget* lower, int lowerShare, int share) {
    auto* column = new QVBoxLayout;
    column->setSpacing(12);
    column->addWidget(upper, upperShare);
    column->addWidget(lower, lowerShare);
    columns->addLayout(column, share);
  };
  stacked(inForcePanel_, 4, wizardPanel_, 5, 4);
  columns->addWidget(worthPanel_, 5);
  stacked(historyPanel_, 3, drift_, 4, 7);
  connect(&desk_, &CalibrationDesk::changed, this, &CalibrationOverview::showHistory);
  connect(&place_.session, &Session::changed, this, &CalibrationOverview::showChoice);
  connect(&place_.units, &Units::changed, this, &CalibrationOverview::showWorth);
  connect(&place_.theme, &Theme::changed, this, [this] {
    showWorth();
    showHistory();
  });
  retranslate();
}

CalibrationOverview::~CalibrationOverview() = default;

void CalibrationOverview::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  frames_->setVisible(height() > 700);  // on small screens the words need the room
}

void CalibrationOverview::retranslate() {
  inForcePanel_->setTitle(tr("In force"));
  wizardPanel_->setTitle(tr("Calibrate"));
  worthPanel_->setTitle(tr("What it is worth"));
  historyPanel_->setTitle(tr("Calibrations kept"));
  historyPanel_->setNote(tr("choose one to compare it with the one in force"));
  rigWizard_->setText(tr("Range finders…"));
  rigWizard_->setAccessibleName(tr("Calibrate the range finders with the pin plate"));
  lensWizard_->setText(tr("Lens of a camera…"));
  lensWizard_->setAccessibleName(tr("Calibrate the lens of a camera with the flat target"));
  encoder_->setText(tr("Encoder…"));
  encoder_->setAccessibleName(tr("Calibrate the encoder over a known length"));
  reference_->setText(tr("Reference piece…"));
  reference_->setAccessibleName(tr("Check the calibration on a reference piece"));
  study_->setText(tr("Parameter study…"));
  study_->setAccessibleName(tr("Study which settings of the calibration matter"));
  history_->setHorizontalHeaderLabels({tr("Calibration"), tr("Method"), tr("Kept"), tr("By, because")});
  history_->setAccessibleName(tr("Calibrations kept"));
  dimensions_->setAccessibleName(tr("What the calibration in force is worth"));
  reason_->setPlaceholderText(tr("Reason"));
  reason_->setAccessibleName(tr("Reason for putting it back in force"));
  revert_->setText(tr("Put in force"));
  revert_->setAccessibleName(tr("Put the chosen calibration in force"));
  drift_->retranslate();
  showInForce();
  showHistory();
  showWorth();
}

void CalibrationOverview::refresh() {
  desk_.load();
  showInForce();
  showChoice();
}

void CalibrationOverview::showLine(const LineSnapshot& line) { drift_->show(line.drift); }

void CalibrationOverview::showInForce() {
  const RigCalibration c = place_.line.calibration();
  if (c.id.empty()) {
    name_->setText(tr("No calibration"));
    age_->setText(tr("Nothing can be measured: calibrate the range finders."));
    facts_->clear();
    return;
  }
  name_->setText(shown(c.id));
  const CalibrationAge age =
      ageOf(c, std::chrono::time_point_cast<std::chrono::seconds>(std::chrono::system_clock::now()));
  const std::string warning = warningOf(c, age);
  if (!warning.empty())
    age_->setText(tr("Overdue: %1. Calibrate the range finders.").arg(shown(warning)));
  else if (age.days && c.intervalDays > 0)
    age_->setText(tr("Due in %n day(s).", nullptr, static_cast<int>(std::lround(c.intervalDays - *age.days))));
  else
    age_->setText(tr("No interval is set."));
  facts_->setText(tr("Method: %1\nMade: %2\nPlate: %3\nCameras: %4")
                      .arg(shown(c.method),
                           c.created.empty() || c.created.starts_with("1970") ? QStringLiteral("–") : shown(c.created),
                           c.plate.empty() ? tr("none") : shown(c.plate),
                           shown(c.rangeFinders[0].serial + ", " + c.rangeFinders[1].serial + ", " +
                                 c.rangeFinders[2].serial + ", " + c.rangeFinders[3].serial)));
  if (c.id == worthOf_ || worthJob_.running()) return;
  worthOf_ = c.id;
  worthJob_.start(
      [this, c, recipe = *place_.line.pull(PullDetail::Profile).recipe](const Job&) -> BackgroundJob::Result {
        return [this, worth = dimensionWorth(recipe, c, nullptr)] {
          worth_ = worth;
          showWorth();
        };
      });
}

void CalibrationOverview::showHistory() {
  historyWords_->setText(!desk_.problem().isEmpty() ? desk_.problem()
                         : desk_.all().empty()
                             ? tr("None is kept yet. The first is kept when a rail is measured or a wizard ends.")
                             : QString());
  historyWords_->setVisible(!historyWords_->text().isEmpty());
  const bool keeps = desk_.problem().isEmpty();
  for (QWidget* w : std::initializer_list<QWidget*>{history_, reason_, revert_}) w->setVisible(keeps);
  const QSignalBlocker quiet(history_);
  const std::string inForce = place_.line.calibration().id;
  const auto& all = desk_.all();
  history_->setRowCount(static_cast<int>(all.size()));
  for (int row = 0; row < history_->rowCount(); ++row) {
    const KeptCalibration& kept = all[static_cast<std::size_t>(row)];
    const auto use = std::find_if(desk_.uses().begin(), desk_.uses().end(),
                                  [&](const CalibrationUse& u) { return u.calibration == kept.entry.key; });
    const bool now = kept.entry.id == inForce;
    const auto put = [&](int column, const QString& text) {
      auto* item = new QTableWidgetItem(text);
      item->setToolTip(text);
      history_->setItem(row, column, item);
      return item;
    };
    QString words = shown(kept.entry.id);
    if (now) words = tr("In force: %1").arg(words);
    if (!kept.problem.empty()) words += tr(" (cannot be read)");
    put(0, words)->setIcon(stateIcon(now ? StateSymbol::Measuring : StateSymbol::Idle, place_.theme.palette()));
    put(1, kept.ofThisRig ? shown(kept.entry.method) : tr("of another rig"));
    put(2, timeText(kept.entry.storedUs));
    const bool used = use != desk_.uses().end();
    const std::string& by = used ? use->user : kept.entry.storedBy;
    put(3, shown((by.empty() ? "" : by + ": ") + (used ? use->reason : kept.entry.reason)));
  }
  showInForce();
  showChoice();
}

int CalibrationOverview::chosen() const {
  const int row = history_->currentRow();
  return history_->selectedItems().isEmpty() || row >= static_cast<int>(desk_.all().size()) ? -1 : row;
}

void CalibrationOverview::chooseKept(int row) { history_->selectRow(row); }

void CalibrationOverview::compareChosen() {
  comparison_.reset();
  result_.clear();
  const int row = chosen();
  if (row >= 0 && desk_.all()[static_cast<std::size_t>(row)].problem.empty() &&
      desk_.all()[static_cast<std::size_t>(row)].ofThisRig && !compareJob_.running()) {
    compareJob_.start([this, older = desk_.all()[static_cast<std::size_t>(row)].calibration,
                       newer = place_.line.calibration(), recipe = *place_.line.pull(PullDetail::Profile).recipe,
                       row](const Job&) -> BackgroundJob::Result {
      const auto compared = compare(older, newer, recipe.section, recipe.parameters);
      return [this, compared, row] {
        if (row != chosen()) {
          compareChosen();
          return;
        }
        if (compared)
          comparison_ = *compared;
        else
          result_ = shown(compared.error().message());
        showWorth();
        showChoice();
        emit this->compared();
      };
    });
  }
  showWorth();
  showChoice();
}

void CalibrationOverview::showWorth() {
  const bool two = comparison_.has_value();
  dimensions_->setColumnCount(two ? 5 : 3);
  QStringList heads{tr("Dimension"), tr("In force"), tr("Allowed")};
  if (two) heads << tr("Difference") << tr("U of it");
  dimensions_->setHorizontalHeaderLabels(heads);
  for (int c = 1; c < dimensions_->columnCount(); ++c)
    dimensions_->horizontalHeaderItem(c)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  worthPanel_->setNote(tr("U (k = 2) in %1").arg(place_.units.name()));
  worthPanel_->setToolTip(two ? tr("Difference: what the chosen one measures more than the one in force")
                              : tr("By the calibration alone, without the noise of the profiles"));
  dimensions_->setRowCount(static_cast<int>(worth_.size()));
  for (int row = 0; row < dimensions_->rowCount(); ++row) {
    const DimensionWorth& w = worth_[static_cast<std::size_t>(row)];
    const bool bad = w.inForceMm && w.allowedMm && *w.inForceMm > *w.allowedMm;
    const auto put = [&](int column, const QString& text, bool right) {
      auto* item = new QTableWidgetItem(text);
      item->setTextAlignment((right ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
      if (bad) item->setBackground(place_.theme.palette().nearSoft);
      dimensions_->setItem(row, column, item);
      return item;
    };
    put(0, bad ? tr("%1, too much").arg(spoken(w.dimension)) : spoken(w.dimension), false)
        ->setIcon(stateIcon(!w.allowedMm ? StateSymbol::NoLimit
                            : bad        ? StateSymbol::Near
                                         : StateSymbol::Good,
                            place_.theme.palette()));
    put(1, w.inForceMm ? lengthText(w.inForceMm, place_.units) : tr("none stated"), true);
    put(2, lengthText(w.allowedMm, place_.units), true);
    if (!two) continue;
    const double difference = comparison_->differenceMm[index(w.dimension)], u = comparison_->uMm[index(w.dimension)];
    put(3,
        std::isfinite(difference) ? deviationText(place_.units.shown(difference), place_.units.decimals(3))
                                  : QStringLiteral("–"),
        true);
    put(4, std::isfinite(u) ? lengthText(2 * u, place_.units) : QStringLiteral("–"), true);
  }
}

void CalibrationOverview::showChoice() {
  const QString hindrance = desk_.hindrance();
  for (QPushButton* wizard : {rigWizard_, lensWizard_, encoder_, reference_, study_})
    wizard->setEnabled(hindrance.isEmpty());
  wizardWords_->setText(!hindrance.isEmpty() ? hindrance : tr("Nothing is applied before old and new are compared."));
  const int row = chosen();
  const KeptCalibration* kept = row < 0 ? nullptr : &desk_.all()[static_cast<std::size_t>(row)];
  const bool now = kept != nullptr && kept->entry.id == place_.line.calibration().id;
  const bool can = kept != nullptr && !now && kept->ofThisRig && kept->problem.empty() && hindrance.isEmpty();
  revert_->setEnabled(can);
  reason_->setEnabled(can);
  QString words = result_;
  if (words.isEmpty() && kept != nullptr) {
    if (!kept->problem.empty())
      words = shown(kept->problem);
    else if (!kept->ofThisRig)
      words = tr("It is of other cameras and cannot be put in force here.");
    else if (now)
      words = tr("It is in force.");
    else if (!hindrance.isEmpty())
      words = hindrance;
  }
  resultWords_->setText(words);
  resultWords_->setVisible(!words.isEmpty());
}

void CalibrationOverview::revert() {
  const int row = chosen();
  if (row < 0) return;
  revert_->setEnabled(false);
  desk_.putInForce(
      desk_.all()[static_cast<std::size_t>(row)].calibration, reason_->text(), [this](const QString& failed) {
        result_ = failed.isEmpty() ? tr("It is in force: the line measures with it from the next rail on.") : failed;
        if (failed.isEmpty()) {
          reason_->clear();
          comparison_.reset();
          showInForce();
        }
        showWorth();
        showHistory();
        emit reverted();
      });
}

}  // namespace vignole
