#include "gui/calibration_rig/rig_wizard.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QTableWidget>
#include <cmath>

#include "calibration/assessment/existing_calibration.h"
#include "gui/calibration_records/calibration_desk.h"
#include "gui/calibration_records/closed_step.h"
#include "gui/calibration_records/step_list.h"
#include "gui/calibration_records/worth_table.h"
#include "gui/calibration_rig/plate_drawing.h"
#include "gui/calibration_rig/plate_view.h"
#include "gui/plots/plot_picture.h"
#include "gui/theme/panel.h"
#include "gui/theme/state_icon.h"
#include "report/dimension_text.h"
#include "report/document_pages.h"

namespace vignole {

namespace {

constexpr double kNearMm = 4, kNearDeg = 3;                        // of where the plate is wanted
constexpr PlatePose kAtFirst{17, -11, 12, 0};                      // as it comes out of its box
constexpr std::array<int, kCameraCount> kOnScreen = {0, 1, 3, 2};  // as the cameras stand

QString shown(const std::string& text) { return QString::fromStdString(text); }

QTableWidgetItem* put(QTableWidget& table, int row, int column, const QString& text, bool right = false) {
  auto* item = new QTableWidgetItem(text);
  item->setTextAlignment((right ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  item->setToolTip(text);
  table.setItem(row, column, item);
  return item;
}

}  // namespace

RigWizard::RigWizard(Workplace& place, CalibrationDesk& desk, QWidget* parent)
    : QWidget(parent), place_(place), desk_(desk), recipe_(*place.line.pull(PullDetail::Profile).recipe) {
  whole_ = new QStackedWidget(this);
  auto* wizard = new QWidget(whole_);
  centre_ = new QStackedWidget(wizard);
  centre_->addWidget(makePrepare());
  centre_->addWidget(makeViews());
  centre_->addWidget(makeSolve());
  centre_->addWidget(makeCompare());
  centre_->addWidget(makeApply());
  auto* grid = new QGridLayout(wizard);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(12);
  grid->addWidget(makeSteps(), 0, 0, 2, 1);
  grid->addWidget(centre_, 0, 1);
  grid->addWidget(makeFoot(), 1, 1);
  grid->addWidget(makeRight(), 0, 2, 2, 1);
  grid->setColumnStretch(0, 28);
  grid->setColumnStretch(1, 82);
  grid->setColumnStretch(2, 50);
  grid->setRowStretch(0, 1);
  whole_->addWidget(wizard);
  closed_ = new ClosedStep(place_, this);
  whole_->addWidget(closed_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(whole_);
  connect(&solve_, &BackgroundJob::progressed, this, [this](double share, const QString& doing) {
    progress_->setValue(static_cast<int>(std::lround(share * 100)));
    solveWords_->setText(doing);
  });
  connect(&place_.units, &Units::changed, this, &RigWizard::showAll);
  connect(&place_.theme, &Theme::changed, this, &RigWizard::showChecks);
  connect(&place_.session, &Session::changed, this, &RigWizard::showAll);
  retranslate();
}

RigWizard::~RigWizard() = default;

QWidget* RigWizard::makeSteps() {
  stepPanel_ = new Panel(this);
  stepPanel_->setMinimumWidth(212);
  steps_ = new StepList(place_.theme, stepPanel_);
  plateTitle_ = makeLabel(16, 500, "t1", stepPanel_, true);
  plateNote_ = makeLabel(14, 400, "t2", stepPanel_, true);
  drawing_ = new PlateDrawing(place_.theme, stepPanel_);
  stepPanel_->content()->addWidget(steps_, 5);
  stepPanel_->content()->addWidget(plateTitle_);
  stepPanel_->content()->addWidget(plateNote_);
  stepPanel_->content()->addWidget(drawing_, 3);
  return stepPanel_;
}

QWidget* RigWizard::makePrepare() {
  platePanel_ = new Panel(this);
  prepareWords_ = makeLabel(16, 400, "t1", platePanel_, true);
  prepareWords_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  countWord_ = makeLabel(16, 400, "t2", platePanel_, true);
  count_ = new QSpinBox(platePanel_);
  count_->setRange(2, 8);
  count_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  count_->setValue(4);
  faultWord_ = makeLabel(16, 400, "t2", platePanel_, true);
  fault_ = new QComboBox(platePanel_);
  for (QWidget* w : std::initializer_list<QWidget*>{count_, fault_}) {
    w->setFont(uiFont(16));
    w->setMinimumHeight(44);
    w->setMaximumWidth(420);
  }
  for (QWidget* w : std::initializer_list<QWidget*>{prepareWords_, countWord_, count_, faultWord_, fault_})
    platePanel_->content()->addWidget(w);
  platePanel_->content()->addStretch(1);
  connect(count_, &QSpinBox::valueChanged, this, &RigWizard::showAll);
  return platePanel_;
}

QWidget* RigWizard::makeViews() {
  auto* page = new QWidget(this);
  auto* grid = new QGridLayout(page);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(12);
  for (std::size_t i = 0; i < kOnScreen.size(); ++i) {
    const int camera = kOnScreen[i];
    auto* view = new PlateView(place_.theme, camera, page);
    views_[static_cast<std::size_t>(camera)] = view;
    grid->addWidget(view, static_cast<int>(i / 2), static_cast<int>(i % 2));
  }
  return page;
}

QWidget* RigWizard::makeSolve() {
  solvePanel_ = new Panel(this);
  solveWords_ = makeLabel(18, 400, "t1", solvePanel_, true);
  progress_ = new QProgressBar(solvePanel_);
  progress_->setRange(0, 100);
  progress_->setTextVisible(false);
  cancel_ = makeButton(place_.theme, QStringLiteral("reject"), solvePanel_);
  solvePanel_->content()->addStretch(1);
  solvePanel_->content()->addWidget(solveWords_);
  solvePanel_->content()->addWidget(progress_);
  solvePanel_->content()->addWidget(cancel_, 0, Qt::AlignLeft);
  solvePanel_->content()->addStretch(2);
  connect(cancel_, &QPushButton::clicked, this, [this] {
    cancelled_ = true;
    solve_.cancel();
    solveWords_->setText(tr("Cancelling…"));
  });
  return solvePanel_;
}

QWidget* RigWizard::makeCompare() {
  auto* page = new QWidget(this);
  figurePanel_ = new Panel(page);
  figure_ = new PlotPicture(place_.theme, figurePanel_);
  figurePanel_->content()->addWidget(figure_, 1);
  checkPanel_ = new Panel(page);
  checks_ = makeFigureTable(1, checkPanel_);
  checks_->setFont(uiFont(15));
  checks_->setWordWrap(true);
  checks_->horizontalHeader()->hide();
  checks_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  report_ = makeButton(place_.theme, QStringLiteral("report"), checkPanel_);
  checkPanel_->head()->addWidget(report_);
  checkPanel_->content()->addWidget(checks_, 1);
  connect(report_, &QPushButton::clicked, this, &RigWizard::saveReport);
  auto* row = new QHBoxLayout(page);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(12);
  row->addWidget(figurePanel_, 1);
  row->addWidget(checkPanel_, 1);
  return page;
}

QWidget* RigWizard::makeApply() {
  applyPanel_ = new Panel(this);
  applyWords_ = makeLabel(16, 400, "t1", applyPanel_, true);
  intervalWord_ = makeLabel(16, 400, "t2", applyPanel_, true);
  interval_ = new QSpinBox(applyPanel_);
  interval_->setRange(0, 3650);
  interval_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  interval_->setValue(90);
  interval_->setFont(uiFont(16));
  interval_->setMinimumHeight(44);
  interval_->setMaximumWidth(420);
  reason_ = new QLineEdit(applyPanel_);
  reason_->setFont(uiFont(16));
  reason_->setMinimumHeight(44);
  apply_ = makeButton(place_.theme, QStringLiteral("approve"), applyPanel_, true);
  applyResult_ = makeLabel(16, 500, "t1", applyPanel_, true);
  for (QWidget* w : std::initializer_list<QWidget*>{applyWords_, intervalWord_, interval_, reason_})
    applyPanel_->content()->addWidget(w);
  applyPanel_->content()->addWidget(apply_, 0, Qt::AlignLeft);
  applyPanel_->content()->addWidget(applyResult_);
  applyPanel_->content()->addStretch(1);
  connect(apply_, &QPushButton::clicked, this, &RigWizard::apply);
  return applyPanel_;
}

QWidget* RigWizard::makeFoot() {
  auto* foot = new QFrame(this);
  foot->setObjectName(QStringLiteral("panel"));
  auto* content = new QVBoxLayout(foot);
  content->setContentsMargins(16, 10, 16, 12);
  content->setSpacing(8);
  sentence_ = makeLabel(16, 500, "t1", foot, true);
  detail_ = makeLabel(15, 400, "t2", foot, true);
  hand_ = new QWidget(foot);
  auto* hand = new QHBoxLayout(hand_);
  hand->setContentsMargins(0, 0, 0, 0);
  hand->setSpacing(8);
  handWord_ = makeLabel(14, 400, "t2", hand_);
  hand->addWidget(handWord_);
  const auto spin = [&](double range, double step) {
    auto* box = new QDoubleSpinBox(hand_);
    box->setRange(-range, range);
    box->setSingleStep(step);
    box->setDecimals(1);
    box->setFont(uiFont(15));
    box->setMinimumHeight(44);
    box->setMinimumWidth(84);
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);  // keys, wheel, typing
    box->setKeyboardTracking(false);
    connect(box, &QDoubleSpinBox::valueChanged, this, [this] { look(); });
    hand->addWidget(box, 1);
    return box;
  };
  x_ = spin(200, 1);
  y_ = spin(200, 1);
  turn_ = spin(360, 1);
  tilt_ = spin(20, 0.5);
  asShown_ = makeButton(place_.theme, QStringLiteral("step"), hand_);
  hand->addWidget(asShown_);
  connect(asShown_, &QPushButton::clicked, this, [this] { setPose(wantedPose(placement())); });
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  leave_ = makeButton(place_.theme, QStringLiteral("reject"), foot);
  back_ = makeButton(place_.theme, QStringLiteral("back"), foot);
  takeAgain_ = makeButton(place_.theme, QStringLiteral("camera"), foot);
  next_ = makeButton(place_.theme, QStringLiteral("next"), foot, true);
  row->addWidget(leave_);
  row->addStretch(1);
  for (QPushButton* b : {back_, takeAgain_, next_}) row->addWidget(b);
  connect(leave_, &QPushButton::clicked, this, [this] {
    solve_.cancel();
    look_.cancel();
    emit left();
  });
  connect(back_, &QPushButton::clicked, this, &RigWizard::back);
  connect(next_, &QPushButton::clicked, this, &RigWizard::next);
  connect(takeAgain_, &QPushButton::clicked, this, [this] {
    ++take_;
    look();
  });
  content->addWidget(sentence_);
  content->addWidget(detail_);
  content->addWidget(hand_);
  content->addLayout(row);
  return foot;
}

QWidget* RigWizard::makeRight() {
  auto* right = new QWidget(this);
  right->setMinimumWidth(440);
  worthPanel_ = new Panel(right);
  worth_ = new WorthTable(place_.theme, place_.units, worthPanel_);
  worthPanel_->content()->addWidget(worth_, 1);
  fitPanel_ = new Panel(right);
  fit_ = makeFigureTable(4, fitPanel_);
  fit_->verticalHeader()->setMinimumSectionSize(22);
  fit_->verticalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  fit_->setFont(uiFont(14));
  for (int c = 0; c < 4; ++c)
    fit_->horizontalHeader()->setSectionResizeMode(c, c == 0 ? QHeaderView::ResizeToContents : QHeaderView::Stretch);
  fitPanel_->content()->addWidget(fit_, 1);
  auto* column = new QVBoxLayout(right);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(12);
  column->addWidget(worthPanel_, 13);
  column->addWidget(fitPanel_, 6);
  return right;
}

void RigWizard::retranslate() {
  const auto name = [](QPushButton* button, const QString& text) {
    button->setText(text);
    button->setAccessibleName(text);
  };
  stepPanel_->setTitle(tr("Range finders"));
  worthPanel_->setTitle(tr("What it means"));
  fitPanel_->setTitle(tr("Fit to the pins"));
  platePanel_->setTitle(tr("Prepare"));
  solvePanel_->setTitle(tr("Solve"));
  figurePanel_->setTitle(tr("Pins found (Fig. 8d)"));
  figurePanel_->setNote(tr("circles: the pins as found; points: the lines of the first placement"));
  figure_->setAccessibleName(tr("Pins in the world"));
  checkPanel_->setTitle(tr("Checks"));
  applyPanel_->setTitle(tr("Put in force"));
  countWord_->setText(tr("How often the plate is put down: four find an error of the plate as well."));
  count_->setAccessibleName(tr("Number of placements"));
  faultWord_->setText(tr("The virtual plate, for training"));
  fault_->setAccessibleName(tr("The virtual plate, for training"));
  const int chosen = std::max(0, fault_->currentIndex());
  fault_->clear();
  fault_->addItems({tr("is as its certificate says"), tr("is the mirror image of its file"),
                    tr("is not the one of the certificate"), tr("has lost pin 4")});
  fault_->setCurrentIndex(chosen);
  handWord_->setText(tr("Virtual plate"));
  const std::pair<QDoubleSpinBox*, std::pair<QString, QString>> spins[] = {
      {x_, {tr("Plate to the right, mm"), QStringLiteral("x ")}},
      {y_, {tr("Plate up, mm"), QStringLiteral("y ")}},
      {turn_, {tr("Plate turned anticlockwise, degrees"), QStringLiteral("∠ ")}},
      {tilt_, {tr("Plate tilted out of the light, degrees"), tr("tilt ")}}};
  for (const auto& [box, words] : spins) {
    box->setAccessibleName(words.first);
    box->setToolTip(words.first);
    box->setPrefix(words.second);
    box->setSuffix(box == x_ || box == y_ ? QStringLiteral(" mm") : QStringLiteral("°"));
  }
  name(asShown_, tr("Place as shown"));
  name(leave_, tr("Leave"));
  name(back_, tr("Back"));
  name(takeAgain_, tr("Take again"));
  name(cancel_, tr("Cancel"));
  name(report_, tr("Report…"));
  name(apply_, tr("Put in force"));
  closed_->say(
      tr("The plate stands where the rail passes, and the cameras are needed. Stop the line to go on; what has been "
         "taken so far is kept."));
  intervalWord_->setText(tr("To be repeated after so many days (0: never)"));
  interval_->setAccessibleName(tr("Days after which the calibration is to be repeated"));
  reason_->setPlaceholderText(tr("Reason"));
  reason_->setAccessibleName(tr("Reason for the new calibration"));
  progress_->setAccessibleName(tr("Progress of the solution"));
  fit_->setHorizontalHeaderLabels({tr("Camera"), tr("Centre (CD)"), tr("Radius (RD)"), tr("Points (PD)")});
  fit_->setAccessibleName(tr("Table IV: fit to the pins"));
  for (int c = 1; c < 4; ++c) fit_->horizontalHeaderItem(c)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  checks_->setAccessibleName(tr("Checks of the new calibration"));
  worth_->retranslate();
  for (PlateView* view : views_) view->retranslate();
  showAll();
}

void RigWizard::begin() {
  inForce_ = place_.line.calibration();
  recipe_ = *place_.line.pull(PullDetail::Profile).recipe;
  problem_.clear();
  known_ = {};
  solution_.reset();
  sight_.reset();
  taken_.clear();
  result_.clear();
  take_ = 0;
  reason_->clear();
  applyResult_->clear();
  if (!place_.line.virtualRigSeed()) {
    problem_ =
        tr("There is no rig to look through: the wizards look through the virtual rig alone. Start the program on the "
           "virtual rig.");
  } else if (auto inputs = inputsFor(inForce_, certifiedPlate()); !inputs) {
    problem_ = shown(inputs.error().message());
  } else {
    known_ = *std::move(inputs);
    for (std::size_t c = 0; c < intrinsics_.size(); ++c)
      if (intrinsics_[c]) known_.cameras[c] = *intrinsics_[c];
  }
  {
    const PlatePose pose = kAtFirst;
    const QSignalBlocker bx(x_), by(y_), bt(turn_), bi(tilt_);
    x_->setValue(pose.xMm);
    y_->setValue(pose.yMm);
    turn_->setValue(pose.turnDeg);
    tilt_->setValue(pose.tiltDeg);
  }
  worth_->show({});
  worthJob_.start([this, recipe = recipe_, inForce = inForce_](const Job&) -> BackgroundJob::Result {
    return [this, worth = dimensionWorth(recipe, inForce, nullptr)] {
      if (!solution_) worth_->show(worth);
    };
  });
  go(0);
}

void RigWizard::setIntrinsics(int camera, const CalibratedIntrinsics& intrinsics) {
  intrinsics_[static_cast<std::size_t>(camera)] = intrinsics;
}

void RigWizard::showLine(const LineSnapshot& line) {
  const bool runs = place_.line.running() || line.state == LineState::Measuring;
  if (runs == lineRuns_) return;
  lineRuns_ = runs;
  if (runs) {
    look_.cancel();
  }
  whole_->setCurrentIndex(runs ? 1 : 0);
  if (!runs && stage() == Stage::Placement) look();
}

RigWizard::Stage RigWizard::stage() const {
  if (step_ == 0) return Stage::Prepare;
  if (step_ <= placements()) return Stage::Placement;
  return static_cast<Stage>(static_cast<int>(Stage::Solve) + step_ - placements() - 1);
}

int RigWizard::placements() const { return count_->value(); }

PlateStandSettings RigWizard::stand() const {
  PlateStandSettings settings;
  settings.known = known_;
  settings.inForce = inForce_;
  settings.rigSeed = place_.line.virtualRigSeed().value_or(0);
  settings.fault = static_cast<PlateFault>(std::max(0, fault_->currentIndex()));
  return settings;
}

PlatePose RigWizard::handPose() const { return {x_->value(), y_->value(), turn_->value(), tilt_->value()}; }

void RigWizard::setPose(const PlatePose& pose) {
  {
    const QSignalBlocker bx(x_), by(y_), bt(turn_), bi(tilt_);
    x_->setValue(pose.xMm);
    y_->setValue(pose.yMm);
    turn_->setValue(pose.turnDeg);
    tilt_->setValue(pose.tiltDeg);
  }
  look();
}

void RigWizard::go(int step) {
  step_ = step;
  centre_->setCurrentIndex(static_cast<int>(stage()));
  showAll();
  if (stage() == Stage::Placement) {
    asShown_->setFocus();
    look();
  } else if (stage() == Stage::Solve) {
    cancel_->setFocus();
    solve();
  } else if (stage() == Stage::Apply) {
    reason_->setFocus();
  } else {
    next_->setFocus();
  }
}

void RigWizard::next() {
  switch (stage()) {
    case Stage::Placement: {
      if (!sight_ || looking()) return;
      const auto at = static_cast<std::size_t>(placement());
      if (taken_.size() <= at) taken_.resize(at + 1);
      taken_[at] = sight_;
      sight_.reset();
      take_ = 0;
      go(step_ + 1);
      return;
    }
    case Stage::Apply:
      emit left();
      return;
    default:
      go(step_ + 1);
  }
}

void RigWizard::back() {
  if (step_ == 0) return;
  // From the comparison to the last placement: solving is no place to stay.
  const bool overSolve = stage() == Stage::Compare;
  sight_.reset();
  if (overSolve) {
    solution_.reset();
    go(placements());
    return;
  }
  go(step_ - 1);
}

void RigWizard::look() {
  if (stage() != Stage::Placement || lineRuns_) return;
  if (look_.running()) {
    lookAgain_ = true;
    look_.cancel();
    return;
  }
  lookAgain_ = false;
  look_.start([this, settings = stand(), pose = handPose(), at = placement(),
               take = take_](const Job& job) -> BackgroundJob::Result {
    auto sight = lookAtPlate(settings, pose, at, take, job);
    const bool cancelled = job.cancelled();
    std::shared_ptr<const PlateSight> seen;
    std::string failed;
    if (sight)
      seen = std::make_shared<const PlateSight>(*std::move(sight));
    else
      failed = sight.error().message();
    return [this, seen, failed, cancelled, at] {
      if (lookAgain_) {
        QMetaObject::invokeMethod(this, &RigWizard::look, Qt::QueuedConnection);
        return;
      }
      if (cancelled || at != placement()) return;
      sight_ = seen;
      problem_ = shown(failed);
      showAll();
      emit sightChanged();
    };
  });
  showSentence();
}

bool RigWizard::nearEnough() const {
  if (!sight_ || !sight_->seen) return false;
  const PlatePose wanted = wantedPose(placement()), &seen = *sight_->seen;
  return std::hypot(seen.xMm - wanted.xMm, seen.yMm - wanted.yMm) <= kNearMm &&
         std::abs(std::remainder(seen.turnDeg - wanted.turnDeg, 360.0)) <= kNearDeg;
}

void RigWizard::solve() {
  solution_.reset();
  cancelled_ = false;
  progress_->setValue(0);
  solveWords_->setText(tr("Four cameras together…"));
  RigInputs inputs = known_;
  for (const auto& sight : taken_) inputs.placements.push_back(sight->lines);
  inputs.placements.resize(static_cast<std::size_t>(placements()));
  RigSolveSettings settings{inForce_, recipe_, 0};
  solve_.start([this, inputs = std::move(inputs), settings](const Job& job) -> BackgroundJob::Result {
    auto solved = solveRig(inputs, settings, job);
    std::optional<RigSolution> solution;
    std::string failed;
    if (solved)
      solution = *std::move(solved);
    else
      failed = solved.error().message();
    return [this, solution = std::move(solution), failed] {
      if (stage() != Stage::Solve) return;
      if (!solution) {
        result_ = cancelled_ ? tr("Cancelled: nothing has changed.") : shown(failed);
        go(placements());
      } else {
        result_.clear();
        solution_ = solution;
        worth_->show(solution_->worth);
        figure_->show(pinsInWorld(solution_->adjustment));
        go(step_ + 1);
      }
      emit this->solved();
    };
  });
}

void RigWizard::apply() {
  if (!solution_ || !solution_->mayBeUsed() || applying_) return;
  RigCalibration calibration = solution_->adjustment.calibration;
  calibration.intervalDays = interval_->value();
  applying_ = true;
  apply_->setEnabled(false);
  desk_.putInForce(calibration, reason_->text(), [this, id = calibration.id](const QString& failed) {
    applying_ = false;
    applyResult_->setText(failed.isEmpty()
                              ? tr("%1 is in force: the line measures with it from the next rail on.").arg(shown(id))
                              : failed);
    if (failed.isEmpty()) result_ = QStringLiteral("applied");
    showAll();
    emit applied();
  });
}

void RigWizard::saveReport() {
  if (!solution_ || taken_.empty()) return;
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Report of the calibration"), shown(solution_->adjustment.calibration.id) + QStringLiteral(".pdf"),
      tr("PDF (*.pdf)"));
  if (file.isEmpty()) return;
  report_->setEnabled(false);
  const auto version = QCoreApplication::applicationVersion().toStdString();
  reportJob_.start([this, solution = *solution_, first = taken_.front(), section = recipe_.section.name, version,
                    path = file.toStdString()](const Job&) -> BackgroundJob::Result {
    const auto written = writeDocument(documentOf(solution, first->pictures, section, true), version, path);
    return [this, written, path] {
      report_->setEnabled(true);
      detail_->setText(written ? tr("Written: %1").arg(shown(path)) : shown(written.error().message()));
    };
  });
}

QString RigWizard::stepWord(int placement) const {
  const PlatePose p = wantedPose(placement);
  const bool turned = std::abs(p.turnDeg) > 90, moved = std::hypot(p.xMm, p.yMm) > 1;
  if (turned && moved) return tr("turned and moved");
  if (turned) return tr("turned 180°");
  if (moved) return tr("moved %1 mm").arg(std::lround(std::hypot(p.xMm, p.yMm)));
  return tr("as drawn, 0°");
}

void RigWizard::showAll() {
  showSteps();
  showViews();
  showFit();
  showChecks();
  showSentence();
}

void RigWizard::showSteps() {
  std::vector<StepList::Step> steps = {{tr("Prepare"), tr("plate and cameras"), {}}};
  for (int i = 0; i < placements(); ++i)
    steps.push_back({tr("Placement %1").arg(i + 1), stepWord(i), QString::number(i + 1)});
  steps.push_back({tr("Solve"), tr("four cameras together"), {}});
  steps.push_back({tr("Compare"), tr("old and new"), {}});
  steps.push_back({tr("Apply"), tr("reason and signature"), {}});
  steps_->show(std::move(steps), step_);
  stepPanel_->setNote(stage() == Stage::Placement ? tr("placement %1 of %2").arg(placement() + 1).arg(placements())
                                                  : QString());
  worthPanel_->setNote(tr("U (k = 2) in %1").arg(place_.units.name()));
  fitPanel_->setNote(tr("mean / max in %1").arg(place_.units.name()));
  const bool placing = stage() == Stage::Placement;
  plateTitle_->setText(placing ? tr("Plate, %1").arg(stepWord(placement())) : tr("Plate"));
  plateNote_->setText(tr("%1, U = 3 µm, pins towards the cameras").arg(shown(known_.plate.id)));
  drawing_->show(known_.plate, wantedPose(placing ? placement() : 0),
                 placing && sight_ && sight_->seen && !nearEnough() ? sight_->seen : std::nullopt);
  QString cameras;
  for (std::size_t c = 0; c < intrinsics_.size(); ++c)
    cameras += (intrinsics_[c] ? tr("Camera %1: lens as calibrated in this session").arg(c + 1)
                               : tr("Camera %1: lens of the calibration in force").arg(c + 1)) +
               QLatin1Char('\n');
  prepareWords_->setText(tr("The plate with 13 pins is put into the gauge where the rail passes, pins towards the "
                            "cameras, and turned and moved between the pictures. Nothing is applied before old and "
                            "new have been compared and you confirm.\n\n%1")
                             .arg(cameras));
  applyWords_->setText(
      tr("%1 takes the place of %2 from the next rail on. Both are kept and can be compared and put back.")
          .arg(solution_ ? shown(solution_->adjustment.calibration.id) : QString(), shown(inForce_.id)));
}

void RigWizard::showViews() {
  if (stage() != Stage::Placement) return;
  const PlateStandSettings settings = stand();
  const bool ghost = !nearEnough();
  for (int c = 0; c < kCameraCount; ++c)
    views_[static_cast<std::size_t>(c)]->show(sight_, ghost && !known_.plate.pins.empty()
                                                          ? pinOutlines(settings, wantedPose(placement()), c)
                                                          : std::vector<std::vector<Point2>>());
}

void RigWizard::showFit() {
  fit_->setRowCount(kCameraCount);
  for (int c = 0; c < kCameraCount; ++c) {
    put(*fit_, c, 0, QString::number(c + 1));
    for (int i = 0; i < 3; ++i) {
      QString text = QStringLiteral("–");
      if (solution_) {
        const RangeFinderFit& fit = solution_->adjustment.finders[static_cast<std::size_t>(c)];
        const SpreadMm& spread = i == 0 ? fit.cd : i == 1 ? fit.rd : fit.pd;
        text = lengthText(spread.mean, place_.units) + QStringLiteral(" / ") + lengthText(spread.max, place_.units);
      }
      put(*fit_, c, i + 1, text, true);
    }
  }
}

void RigWizard::showChecks() {
  checks_->setRowCount(0);
  if (!solution_) return;
  const Palette& p = place_.theme.palette();
  const auto& all = solution_->checks.checks;
  const auto add = [&](StateSymbol symbol, const QString& words) {
    checks_->insertRow(checks_->rowCount());
    put(*checks_, checks_->rowCount() - 1, 0, words)->setIcon(stateIcon(symbol, p));
  };
  for (const std::string& refusal : solution_->refusals) add(StateSymbol::Out, shown(refusal));
  for (const std::string& warning : solution_->adjustment.warnings) add(StateSymbol::Near, shown(warning));
  for (const Check& check : all) {
    const StateSymbol symbol = !check.done     ? StateSymbol::NoLimit
                               : check.pass()  ? StateSymbol::Good
                               : check.refuses ? StateSymbol::Out
                                               : StateSymbol::Near;
    const QString limit = QString::number(check.limit, 'g', 3) + QLatin1Char(' ') + shown(check.unit);
    const QString verdict = !check.done ? tr("could not be asked")
                            : check.pass()
                                ? tr("%1, within %2").arg(QString::number(check.value, 'g', 3), limit.trimmed())
                                : tr("%1, above %2").arg(QString::number(check.value, 'g', 3), limit.trimmed());
    add(symbol, QStringLiteral("%1: %2\n%3").arg(shown(check.name), verdict, shown(check.words)));
  }
}

QString RigWizard::moveWords() const {
  const PlatePose wanted = wantedPose(placement()), &seen = *sight_->seen;
  const double dx = wanted.xMm - seen.xMm, dy = wanted.yMm - seen.yMm,
               turn = std::remainder(wanted.turnDeg - seen.turnDeg, 360.0);
  const auto length = [this](double mm) {
    return numberText(std::abs(place_.units.shown(mm)), place_.units.decimals(0)) + QLatin1Char(' ') +
           place_.units.name();
  };
  QStringList parts;
  if (std::abs(dx) > 1) parts << (dx > 0 ? tr("%1 to the right") : tr("%1 to the left")).arg(length(dx));
  if (std::abs(dy) > 1) parts << (dy > 0 ? tr("%1 up") : tr("%1 down")).arg(length(dy));
  if (std::abs(turn) > 1)
    parts << (turn > 0 ? tr("turned by %1° anticlockwise") : tr("turned by %1° clockwise"))
                 .arg(std::lround(std::abs(turn)));
  return tr("Next: move the plate to the dashed outlines: %1.").arg(parts.join(tr(", ")));
}

void RigWizard::showSentence() {
  const Stage at = stage();
  hand_->setVisible(at == Stage::Placement && place_.line.virtualRigSeed().has_value());
  takeAgain_->setVisible(at == Stage::Placement);
  takeAgain_->setEnabled(!looking());
  back_->setVisible(at != Stage::Solve);
  back_->setEnabled(step_ > 0 && !applying_);
  leave_->setVisible(at != Stage::Solve);
  const bool applied = result_ == QStringLiteral("applied");
  QString headline, detail;
  bool mayGo = true;
  QString word = tr("Next");
  switch (at) {
    case Stage::Prepare:
      mayGo = problem_.isEmpty() && desk_.hindrance().isEmpty();
      headline = !problem_.isEmpty()            ? problem_
                 : !desk_.hindrance().isEmpty() ? desk_.hindrance()
                                                : tr("Next: put the plate into the gauge.");
      word = tr("First placement");
      break;
    case Stage::Placement: {
      word = placement() + 1 < placements() ? tr("Next placement") : tr("Solve");
      if (looking() || !sight_) {
        headline = problem_.isEmpty() ? tr("Looking at the plate…") : problem_;
        mayGo = false;
        break;
      }
      std::size_t found = 0, all = 0;
      QStringList refused;
      for (std::size_t c = 0; c < sight_->found.size(); ++c) {
        found += sight_->found[c].size();
        all += sight_->found[c].size() + sight_->missing[c].size();
        if (!sight_->lines.pictures[c].usable())
          refused << tr("Camera %1: %2").arg(c + 1).arg(shown(sight_->lines.pictures[c].refusal));
      }
      headline = tr("%1 of %2 pins found").arg(found).arg(all);
      if (!refused.isEmpty()) {
        mayGo = false;
        headline += tr(", %n picture(s) refused", nullptr, static_cast<int>(refused.size()));
        detail = refused.front();
      } else if (!nearEnough()) {
        mayGo = false;
        detail = moveWords();
      } else {
        detail = tr("All four cameras see the plate where it must lie. Next: “%1”.").arg(word);
      }
      if (!result_.isEmpty()) headline = result_ + QLatin1Char(' ') + headline;
      break;
    }
    case Stage::Solve:
      headline = tr("The poses of four cameras are found together with the pins.");
      detail = tr("Next: nothing to do; the comparison comes by itself.");
      mayGo = false;
      break;
    case Stage::Compare: {
      mayGo = solution_ && solution_->mayBeUsed();
      if (solution_ && !mayGo) {
        headline = tr("Refused: it cannot be put in force.");
        detail = shown(solution_->refusals.front());
      } else if (solution_) {
        int above = 0;
        for (const DimensionWorth& w : solution_->worth) above += w.tooLarge() ? 1 : 0;
        headline = above == 0 ? tr("May be used: every check is within its limit.")
                              : tr("May be used, but %n dimension(s) get more than is allowed.", nullptr, above);
        detail = tr("Next: compare old and new on the right. Nothing is applied before you confirm.");
      }
      break;
    }
    case Stage::Apply: {
      const QString hindrance = desk_.hindrance();
      headline = applied               ? tr("Done. Next: start the line and watch the first rail.")
                 : hindrance.isEmpty() ? tr("Next: give the reason and put it in force.")
                                       : hindrance;
      apply_->setEnabled(hindrance.isEmpty() && !applied && !applying_);
      reason_->setEnabled(hindrance.isEmpty() && !applied);
      interval_->setEnabled(hindrance.isEmpty() && !applied);
      back_->setEnabled(!applied && !applying_);
      word = tr("Close");
      mayGo = applied;
      break;
    }
  }
  next_->setVisible(at != Stage::Solve);
  next_->setText(word);
  next_->setAccessibleName(word);
  next_->setEnabled(mayGo);
  sentence_->setText(headline);
  detail_->setText(detail);
  detail_->setVisible(!detail.isEmpty());
  giveRoom(*sentence_);
  giveRoom(*detail_);
}

void RigWizard::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  QMetaObject::invokeMethod(this, &RigWizard::showSentence, Qt::QueuedConnection);  // when the labels have their widths
}

}  // namespace vignole
