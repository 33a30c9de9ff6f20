#include "gui/calibration_lens/lens_wizard.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QDateTime>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStackedWidget>
#include <QTableWidget>
#include <algorithm>
#include <cmath>

#include "calibration/lens_files/lens_files.h"
#include "gui/calibration_lens/target_view.h"
#include "gui/calibration_records/calibration_desk.h"
#include "gui/calibration_records/closed_step.h"
#include "gui/calibration_records/step_list.h"
#include "gui/calibration_records/worth_table.h"
#include "gui/plots/plot_picture.h"
#include "gui/theme/panel.h"
#include "gui/theme/state_icon.h"
#include "report/dimension_text.h"
#include "report/intrinsics_report.h"

namespace vignole {

namespace {

constexpr int kFewestForAdvice = 4;
constexpr HeldTarget kAtFirst{40, 30, 560, 0, 0, 3};  // as somebody holds it up

QString shown(const std::string& text) { return QString::fromStdString(text); }

}  // namespace

LensWizard::LensWizard(Workplace& place, CalibrationDesk& desk, QWidget* parent)
    : QWidget(parent), place_(place), desk_(desk), recipe_(*place.line.pull(PullDetail::Profile).recipe) {
  whole_ = new QStackedWidget(this);
  auto* wizard = new QWidget(whole_);
  stepPanel_ = new Panel(wizard);
  stepPanel_->setMinimumWidth(230);
  steps_ = new StepList(place.theme, stepPanel_);
  coveragePanel_ = new Panel(wizard);
  coverage_ = new CoverageMap(place.theme, coveragePanel_);
  coveragePanel_->content()->addWidget(coverage_, 1);
  stepPanel_->content()->addWidget(steps_, 1);

  centre_ = new QStackedWidget(wizard);
  preparePanel_ = new Panel(centre_);
  prepareWords_ = makeLabel(16, 400, "t1", preparePanel_, true);
  cameraWord_ = makeLabel(16, 400, "t2", preparePanel_, true);
  camera_ = new QComboBox(preparePanel_);
  countWord_ = makeLabel(16, 400, "t2", preparePanel_, true);
  count_ = new QSpinBox(preparePanel_);
  count_->setRange(5, 40);
  count_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  count_->setValue(12);
  for (QWidget* w : std::initializer_list<QWidget*>{camera_, count_}) {
    w->setFont(uiFont(16));
    w->setMinimumHeight(44);
    w->setMaximumWidth(420);
  }
  for (QWidget* w : std::initializer_list<QWidget*>{prepareWords_, cameraWord_, camera_, countWord_, count_})
    preparePanel_->content()->addWidget(w);
  preparePanel_->content()->addStretch(1);
  connect(count_, &QSpinBox::valueChanged, this, &LensWizard::showAll);
  centre_->addWidget(preparePanel_);
  centre_->addWidget(makePictures());

  solvePanel_ = new Panel(centre_);
  solveWords_ = makeLabel(18, 400, "t1", solvePanel_, true);
  progress_ = new QProgressBar(solvePanel_);
  progress_->setRange(0, 100);
  progress_->setTextVisible(false);
  cancel_ = makeButton(place.theme, QStringLiteral("reject"), solvePanel_);
  solvePanel_->content()->addStretch(1);
  solvePanel_->content()->addWidget(solveWords_);
  solvePanel_->content()->addWidget(progress_);
  solvePanel_->content()->addWidget(cancel_, 0, Qt::AlignLeft);
  solvePanel_->content()->addStretch(2);
  centre_->addWidget(solvePanel_);
  centre_->addWidget(makeResult());
  connect(cancel_, &QPushButton::clicked, this, [this] {
    cancelled_ = true;
    solve_.cancel();
    solveWords_->setText(tr("Cancelling…"));
  });

  auto* columns = new QHBoxLayout(wizard);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(12);
  auto* aside = new QVBoxLayout;
  aside->setSpacing(12);
  aside->addWidget(stepPanel_, 3);
  aside->addWidget(coveragePanel_, 2);
  auto* work = new QVBoxLayout;
  work->setSpacing(12);
  work->addWidget(centre_, 1);
  work->addWidget(makeFoot());
  columns->addLayout(aside, 30);
  columns->addLayout(work, 130);
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
  connect(&place_.session, &Session::changed, this, &LensWizard::showAll);
  connect(&place_.theme, &Theme::changed, this, &LensWizard::showResult);
  retranslate();
}

LensWizard::~LensWizard() = default;

QWidget* LensWizard::makePictures() {
  auto* page = new QWidget(this);
  picturePanel_ = new Panel(page);
  picture_ = new TargetPicture(place_.theme, picturePanel_);
  picturePanel_->content()->addWidget(picture_, 1);
  viewPanel_ = new Panel(page);
  viewWords_ = makeLabel(14, 400, "t2", viewPanel_, true);
  views_ = makeFigureTable(4, viewPanel_);
  views_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  viewPanel_->content()->addWidget(viewWords_);
  viewPanel_->content()->addWidget(views_, 1);
  auto* row = new QHBoxLayout(page);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(12);
  row->addWidget(picturePanel_, 5);
  row->addWidget(viewPanel_, 3);
  return page;
}

QWidget* LensWizard::makeResult() {
  auto* page = new QWidget(this);
  tablePanel_ = new Panel(page);
  verdict_ = makeLabel(16, 500, "t1", tablePanel_, true);
  table_ = makeFigureTable(5, tablePanel_);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  tablePanel_->content()->addWidget(verdict_);
  tablePanel_->content()->addWidget(table_, 1);
  mapPanel_ = new Panel(page);
  seen_ = new PlotPicture(place_.theme, mapPanel_);
  residuals_ = new PlotPicture(place_.theme, mapPanel_);
  auto* maps = new QHBoxLayout;
  maps->setSpacing(12);
  maps->addWidget(seen_, 1);
  maps->addWidget(residuals_, 1);
  mapPanel_->content()->addLayout(maps, 1);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(12);
  table_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
  column->addWidget(tablePanel_, 3);
  column->addWidget(mapPanel_, 5);
  return page;
}

QWidget* LensWizard::makeFoot() {
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
  hand->setSpacing(6);
  for (std::size_t i = 0; i < spins_.size(); ++i) {
    auto* box = new QDoubleSpinBox(hand_);
    const bool length = i < 3;
    box->setRange(i == 2 ? 150 : -400, i == 2 ? 1200 : 400);
    box->setSingleStep(length ? 5 : 2);
    box->setDecimals(length ? 0 : 1);
    box->setFont(uiFont(15));
    box->setMinimumHeight(44);
    box->setMinimumWidth(84);
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);  // keys, wheel, typing
    box->setKeyboardTracking(false);
    connect(box, &QDoubleSpinBox::valueChanged, this, &LensWizard::look);
    hand->addWidget(box, 1);
    spins_[i] = box;
  }
  asShown_ = makeButton(place_.theme, QStringLiteral("step"), hand_);
  hand->addWidget(asShown_);
  connect(asShown_, &QPushButton::clicked, this, [this] { setPose(next_.pose); });
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  leave_ = makeButton(place_.theme, QStringLiteral("back"), foot);
  take_ = makeButton(place_.theme, QStringLiteral("camera"), foot);
  save_ = makeButton(place_.theme, QStringLiteral("export"), foot);
  use_ = makeButton(place_.theme, QStringLiteral("approve"), foot, true);
  nextButton_ = makeButton(place_.theme, QStringLiteral("next"), foot, true);
  row->addWidget(leave_);
  row->addStretch(1);
  for (QPushButton* b : {take_, save_, use_, nextButton_}) row->addWidget(b);
  connect(leave_, &QPushButton::clicked, this, [this] {
    look_.cancel();
    advice_.cancel();
    solve_.cancel();
    emit left();
  });
  connect(take_, &QPushButton::clicked, this, &LensWizard::take);
  connect(save_, &QPushButton::clicked, this, &LensWizard::save);
  connect(use_, &QPushButton::clicked, this, &LensWizard::use);
  connect(nextButton_, &QPushButton::clicked, this, [this] {
    if (stage_ == Stage::Prepare)
      go(Stage::Pictures);
    else if (stage_ == Stage::Pictures)
      go(Stage::Solve);
  });
  content->addWidget(sentence_);
  content->addWidget(detail_);
  content->addWidget(hand_);
  content->addLayout(row);
  return foot;
}

void LensWizard::retranslate() {
  const auto name = [](QPushButton* button, const QString& text) {
    button->setText(text);
    button->setAccessibleName(text);
  };
  stepPanel_->setTitle(tr("Lens"));
  preparePanel_->setTitle(tr("Prepare"));
  coveragePanel_->setTitle(tr("Coverage"));
  coverage_->setAccessibleName(tr("Parts of the picture that have been seen"));
  picture_->setAccessibleName(tr("Picture of the target"));
  viewPanel_->setTitle(tr("Pictures taken"));
  views_->setHorizontalHeaderLabels({tr("No."), tr("Points"), tr("Oblique"), tr("Blur")});
  views_->setAccessibleName(tr("Pictures taken"));
  solvePanel_->setTitle(tr("Solve"));
  tablePanel_->setTitle(tr("Lens models (Table III)"));
  table_->setHorizontalHeaderLabels(
      {tr("Distortion model"), tr("Mean error px"), tr("RMS px"), tr("Not seen before px"), tr("Focal length mm")});
  for (int c = 1; c < 5; ++c) table_->horizontalHeaderItem(c)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  table_->setAccessibleName(tr("Lens models that were tried"));
  mapPanel_->setTitle(tr("Coverage and residuals"));
  seen_->setAccessibleName(tr("Points of all pictures"));
  residuals_->setAccessibleName(tr("Mean residual by place"));
  prepareWords_->setText(
      tr("The flat target with circles is held before one camera, in the pose that is drawn, picture by picture. The "
         "lens model is the simplest that predicts pictures it has not seen.\nTarget: %1, points within ±%2 µm.")
          .arg(shown(words(stand_.target)))
          .arg(std::lround(stand_.target.uMm * std::sqrt(3.0) * 1000)));
  cameraWord_->setText(tr("Camera"));
  camera_->setAccessibleName(tr("Camera whose lens is calibrated"));
  const int chosen = std::max(0, camera_->currentIndex());
  camera_->clear();
  for (int c = 0; c < kCameraCount; ++c) camera_->addItem(tr("Camera %1").arg(c + 1));
  camera_->setCurrentIndex(chosen);
  countWord_->setText(tr("Pictures: twelve cover a lens."));
  count_->setAccessibleName(tr("Number of pictures"));
  const std::array<std::pair<QString, QString>, 6> spins = {
      {{tr("Target to the right, mm"), QStringLiteral("x ")},
       {tr("Target down, mm"), QStringLiteral("y ")},
       {tr("Distance of the target, mm"), QStringLiteral("z ")},
       {tr("Tilt up and down, degrees"), QStringLiteral("↕ ")},
       {tr("Tilt to the sides, degrees"), QStringLiteral("↔ ")},
       {tr("Turn of the target, degrees"), QStringLiteral("∠ ")}}};
  for (std::size_t i = 0; i < spins_.size(); ++i) {
    spins_[i]->setAccessibleName(spins[i].first);
    spins_[i]->setToolTip(spins[i].first);
    spins_[i]->setPrefix(spins[i].second);
    spins_[i]->setSuffix(i < 3 ? QStringLiteral(" mm") : QStringLiteral("°"));
  }
  name(asShown_, tr("Hold as shown"));
  name(leave_, tr("Leave"));
  name(take_, tr("Take picture"));
  name(cancel_, tr("Cancel"));
  name(use_, tr("Use with the plate"));
  name(save_, tr("Save…"));
  closed_->say(
      tr("The camera is needed for the pictures of the target. Stop the line to go on; what has been "
         "taken so far is kept."));
  progress_->setAccessibleName(tr("Progress of the solution"));
  showAll();
  showResult();
}

int LensWizard::camera() const { return std::max(0, camera_->currentIndex()); }

void LensWizard::begin() {
  taken_.clear();
  pictures_.clear();
  sight_.reset();
  result_.reset();
  words_.clear();
  problem_.clear();
  shots_ = 0;
  handedOn_ = false;
  recipe_ = *place_.line.pull(PullDetail::Profile).recipe;
  if (auto target = parseTarget(kUsualTarget)) {
    stand_.target = *target;
    stand_.target.uMm = 0.01 / std::sqrt(3.0);
  }
  if (!place_.line.virtualRigSeed())
    problem_ =
        tr("There is no rig to look through: the wizards look through the virtual rig alone. Start the program on the "
           "virtual rig.");
  retranslate();
  go(Stage::Prepare);
}

void LensWizard::showLine(const LineSnapshot& line) {
  const bool runs = place_.line.running() || line.state == LineState::Measuring;
  if (runs == lineRuns_) return;
  lineRuns_ = runs;
  whole_->setCurrentIndex(runs ? 1 : 0);
  if (!runs && stage_ == Stage::Pictures) look();
}

void LensWizard::go(Stage stage) {
  stage_ = stage;
  centre_->setCurrentIndex(static_cast<int>(stage));
  if (stage == Stage::Pictures && taken_.empty()) {
    stand_.number = camera();
    stand_.camera = virtualCamera(place_.line.virtualRigSeed().value_or(0), camera());
    rough_ = place_.line.calibration().rangeFinders[static_cast<std::size_t>(camera())].intrinsics;
    next_ = startingView(stand_.target, rough_, 0);
    setPose(kAtFirst);
  }
  showAll();
  if (stage == Stage::Pictures) {
    asShown_->setFocus();
    look();
  } else if (stage == Stage::Solve) {
    cancel_->setFocus();
    solve();
  } else if (stage == Stage::Result) {
    use_->setFocus();
  }
}

HeldTarget LensWizard::handPose() const {
  return {spins_[0]->value(), spins_[1]->value(), spins_[2]->value(),
          spins_[3]->value(), spins_[4]->value(), spins_[5]->value()};
}

void LensWizard::setPose(const HeldTarget& pose) {
  const std::array<double, 6> values = {pose.xMm, pose.yMm, pose.zMm, pose.tiltXDeg, pose.tiltYDeg, pose.turnDeg};
  for (std::size_t i = 0; i < spins_.size(); ++i) {
    const QSignalBlocker quiet(spins_[i]);
    spins_[i]->setValue(values[i]);
  }
  look();
}

void LensWizard::look() {
  if (stage_ != Stage::Pictures || lineRuns_) return;
  if (look_.running()) {
    lookAgain_ = true;
    return;
  }
  lookAgain_ = false;
  look_.start([this, settings = stand_, pose = handPose(), take = shots_,
               taken = taken_](const Job& job) -> BackgroundJob::Result {
    auto sight = lookAtTarget(settings, pose, take, taken);
    const bool cancelled = job.cancelled();
    std::shared_ptr<const LensSight> seen;
    std::string failed;
    if (sight)
      seen = std::make_shared<const LensSight>(*std::move(sight));
    else
      failed = sight.error().message();
    return [this, seen, failed, cancelled] {
      if (lookAgain_) {
        QMetaObject::invokeMethod(this, &LensWizard::look, Qt::QueuedConnection);
        return;
      }
      if (cancelled) return;
      sight_ = seen;
      problem_ = shown(failed);
      showAll();
      emit sightChanged();
    };
  });
  showSentence();
}

void LensWizard::take() {
  if (!sight_ || looking() || !sight_->usable()) return;
  taken_.push_back(sight_->view);
  pictures_.push_back(sight_);
  ++shots_;
  sight_.reset();
  asShown_->setFocus();
  next_ = startingView(stand_.target, rough_, static_cast<int>(taken_.size()));
  if (static_cast<int>(taken_.size()) >= kFewestForAdvice && static_cast<int>(taken_.size()) < count_->value())
    advise();
  showAll();
  look();
}

void LensWizard::advise() {
  if (advice_.running()) return;
  advice_.start([this, taken = taken_, target = stand_.target, section = recipe_.section,
                 parameters = recipe_.parameters](const Job& job) -> BackgroundJob::Result {
    auto next = mostTelling(taken, target, section, parameters, job);
    if (!next || job.cancelled()) return {};
    return [this, next = *next, count = taken.size()] {
      if (count != taken_.size()) return;
      next_ = next;
      showAll();
    };
  });
  connect(&advice_, &BackgroundJob::finished, this, &LensWizard::showAll, Qt::UniqueConnection);
}

void LensWizard::solve() {
  result_.reset();
  cancelled_ = false;
  progress_->setValue(0);
  advice_.cancel();
  IntrinsicsSettings settings;
  settings.serial = stand_.camera.serial;
  solve_.start([this, settings, taken = taken_, target = stand_.target](const Job& job) -> BackgroundJob::Result {
    auto solution = calibrateIntrinsics(taken, target, settings, job);
    return [this, solution = std::move(solution)] {
      if (stage_ != Stage::Solve) return;
      if (!solution) {
        words_ = cancelled_ ? tr("Cancelled: nothing has changed.") : shown(solution.error().message());
        go(Stage::Pictures);
      } else {
        result_ = *solution;
        result_->camera.created =
            QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyy-MM-ddTHH:mm:ssZ")).toStdString();
        words_.clear();
        go(Stage::Result);
        showResult();
      }
      emit solved();
    };
  });
}

void LensWizard::use() {
  if (!result_ || !result_->accepted()) return;
  handedOn_ = true;
  emit lensReady(stand_.number, result_->camera);
  showAll();
}

void LensWizard::save() {
  if (!result_ || !result_->accepted()) return;
  const QString file =
      QFileDialog::getSaveFileName(this, tr("Lens of the camera"), tr("camera%1.toml").arg(stand_.number + 1),
                                   tr("Vignole (*.toml);;OpenCV (*.yaml);;HALCON (*.dat);;mrcal (*.cameramodel)"));
  if (file.isEmpty()) return;
  const auto written = exportLens(result_->camera, file.toStdString());
  words_ = written ? tr("Written: %1").arg(file) : shown(written.error().message());
  showSentence();
}

void LensWizard::showAll() {
  std::vector<StepList::Step> steps = {
      {tr("Prepare"), tr("camera and target"), QStringLiteral("1")},
      {tr("Pictures"), tr("%1 of %2").arg(taken_.size()).arg(count_->value()), QStringLiteral("2")},
      {tr("Solve"), tr("model chosen by the data"), QStringLiteral("3")},
      {tr("Result"), tr("Table III, residuals"), QStringLiteral("4")}};
  steps_->show(std::move(steps), static_cast<int>(stage_));
  const int width = rough_.widthPx, height = rough_.heightPx;
  coverage_->show(taken_, stage_ == Stage::Pictures ? next_.outlinePx : std::vector<Point2>(), width, height);
  coveragePanel_->setNote(tr("%1 % of the picture").arg(std::lround(100 * coverage_->share())));
  picturePanel_->setTitle(tr("Camera %1").arg(stand_.number + 1));
  picture_->show(sight_, next_.outlinePx);
  viewWords_->setText(taken_.empty() ? tr("None yet.") : QString());
  viewWords_->setVisible(taken_.empty());
  views_->setRowCount(static_cast<int>(taken_.size()));
  for (int row = 0; row < views_->rowCount(); ++row) {
    const TargetView& v = taken_[static_cast<std::size_t>(row)];
    const QString cells[] = {QString::number(row + 1), QString::number(v.points.size()),
                             numberText(v.obliqueDeg, 0) + QStringLiteral("°"),
                             numberText(v.blurPx, 1) + QStringLiteral(" px")};
    for (int column = 0; column < 4; ++column) views_->setItem(row, column, new QTableWidgetItem(cells[column]));
  }
  showSentence();
}

void LensWizard::showResult() {
  if (!result_) return;
  const IntrinsicsCalibration& c = *result_;
  const Palette& p = place_.theme.palette();
  if (!c.accepted())
    verdict_->setText(shown(c.refusals.front()));
  else if (!c.warnings.empty())
    verdict_->setText(tr("May be used, but: %1").arg(shown(c.warnings.front())));
  else
    verdict_->setText(tr("May be used: mean error %1 px with the model %2, chosen by pictures it had not seen.")
                          .arg(numberText(c.camera.meanPx, 3), shown(vignole::name(c.variant))));
  std::vector<VariantResult> variants = c.variants;
  std::stable_partition(variants.begin(), variants.end(),
                        [&](const VariantResult& v) { return v.variant == c.variant; });
  table_->setRowCount(static_cast<int>(variants.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const VariantResult& v = variants[static_cast<std::size_t>(row)];
    const bool chosen = v.variant == c.variant;
    const auto put = [&](int column, const QString& text, bool right) {
      auto* item = new QTableWidgetItem(text);
      item->setTextAlignment((right ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
      if (chosen) item->setFont(uiFont(16, 700));
      table_->setItem(row, column, item);
      return item;
    };
    put(0, chosen ? tr("%1, chosen").arg(shown(vignole::name(v.variant))) : shown(vignole::name(v.variant)), false)
        ->setIcon(stateIcon(chosen ? StateSymbol::Good : StateSymbol::NoLimit, p));
    put(1, numberText(v.meanPx, 3), true);
    put(2, numberText(v.rmsPx, 3), true);
    put(3, numberText(v.heldOutRmsPx, 3), true);
    put(4, numberText(v.intrinsics.focalMm, 3), true);
  }
  auto maps = lensMaps(c);
  seen_->show(std::move(maps.plots[0]));
  residuals_->show(std::move(maps.plots[1]));
  mapPanel_->setNote(shown(maps.note));
}

void LensWizard::showSentence() {
  const QString hindrance = desk_.hindrance();
  QString headline, detail, word = tr("Next");
  bool may = false;
  hand_->setVisible(stage_ == Stage::Pictures);
  take_->setVisible(stage_ == Stage::Pictures);
  nextButton_->setVisible(stage_ == Stage::Prepare || stage_ == Stage::Pictures);
  use_->setVisible(stage_ == Stage::Result);
  save_->setVisible(stage_ == Stage::Result);
  leave_->setVisible(stage_ != Stage::Solve);
  switch (stage_) {
    case Stage::Prepare:
      headline = !problem_.isEmpty() ? problem_ : !hindrance.isEmpty() ? hindrance : tr("Next: choose the camera.");
      may = problem_.isEmpty() && hindrance.isEmpty();
      word = tr("First picture");
      break;
    case Stage::Pictures: {
      word = tr("Solve");
      const int left = count_->value() - static_cast<int>(taken_.size());
      may = left <= 0;
      take_->setEnabled(sight_ && !looking() && sight_->usable());
      if (looking() || !sight_)
        headline = problem_.isEmpty() ? tr("Looking at the target…") : problem_;
      else if (!sight_->view.usable())
        headline = tr("This picture would be refused: %1").arg(shown(sight_->view.refusal));
      else if (sight_->sameAs > 0)
        headline = tr("This picture would be refused, because it shows the pose of picture %1; move the target to the "
                      "dashed outline.")
                       .arg(sight_->sameAs);
      else
        headline = tr("%n point(s) found.", nullptr, static_cast<int>(sight_->view.points.size()));
      if (!words_.isEmpty()) headline = words_ + QLatin1Char(' ') + headline;
      if (left <= 0)
        detail = tr("Next: solve, or take more.");
      else if (advice_.running())
        detail = tr("Working out which pose tells most…");
      else
        detail = next_.words.empty()
                     ? tr("Next: hold the target to the dashed outline and take the picture; %n to go.", nullptr, left)
                     : tr("Next: %1; %n to go.", nullptr, left).arg(shown(next_.words));
      break;
    }
    case Stage::Solve:
      headline = tr("Lens models are adjusted and tried on pictures they have not seen.");
      detail = tr("Next: nothing to do; the result comes by itself.");
      break;
    case Stage::Result: {
      const bool good = result_ && result_->accepted();
      use_->setEnabled(good && !handedOn_);
      save_->setEnabled(good);
      headline = !good       ? tr("Refused: it cannot be used.")
                 : handedOn_ ? tr("The wizard of the range finders uses this lens. Next: calibrate the range finders.")
                             : tr("Next: use it with the plate, or save it.");
      if (result_ && !good) detail = shown(result_->refusals.front());
      if (!words_.isEmpty()) detail = words_;
      break;
    }
  }
  nextButton_->setText(word);
  nextButton_->setAccessibleName(word);
  nextButton_->setEnabled(may);
  sentence_->setText(headline);
  detail_->setText(detail);
  detail_->setVisible(!detail.isEmpty());
  giveRoom(*sentence_);
  giveRoom(*detail_);
}

void LensWizard::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  QMetaObject::invokeMethod(this, &LensWizard::showSentence,
                            Qt::QueuedConnection);  // when the labels have their widths
}

}  // namespace vignole
