#include "gui/calibration/calibration_page.h"

#include <QEvent>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "gui/calibration/calibration_overview.h"
#include "gui/calibration_encoder/encoder_panel.h"
#include "gui/calibration_lens/lens_wizard.h"
#include "gui/calibration_records/calibration_desk.h"
#include "gui/calibration_reference/reference_panel.h"
#include "gui/calibration_rig/rig_wizard.h"
#include "gui/calibration_study/study_panel.h"

namespace vignole {

CalibrationPage::CalibrationPage(Workplace& place, QWidget* parent)
    : Page(parent), place_(place), desk_(new CalibrationDesk(place, this)), stack_(new QStackedWidget(this)) {
  setObjectName(QStringLiteral("page"));
  setFocusPolicy(Qt::ClickFocus);
  overview_ = new CalibrationOverview(place, *desk_, stack_);
  rigWizard_ = new RigWizard(place, *desk_, stack_);
  lensWizard_ = new LensWizard(place, *desk_, stack_);
  encoder_ = new EncoderPanel(place, stack_);
  reference_ = new ReferencePanel(place, stack_);
  study_ = new StudyPanel(place, stack_);
  stack_->addWidget(overview_);
  stack_->addWidget(rigWizard_);
  stack_->addWidget(lensWizard_);
  stack_->addWidget(encoder_);
  stack_->addWidget(reference_);
  stack_->addWidget(study_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 12, 12, 12);
  column->addWidget(stack_);
  connect(overview_, &CalibrationOverview::rigWizardAsked, this, &CalibrationPage::openRigWizard);
  connect(overview_, &CalibrationOverview::lensWizardAsked, this, &CalibrationPage::openLensWizard);
  connect(overview_, &CalibrationOverview::referenceAsked, this, &CalibrationPage::openReference);
  connect(overview_, &CalibrationOverview::studyAsked, this, &CalibrationPage::openStudy);
  connect(overview_, &CalibrationOverview::encoderAsked, this, &CalibrationPage::openEncoder);
  connect(encoder_, &EncoderPanel::left, this, &CalibrationPage::openOverview);
  connect(reference_, &ReferencePanel::left, this, &CalibrationPage::openOverview);
  connect(study_, &StudyPanel::left, this, &CalibrationPage::openOverview);
  connect(lensWizard_, &LensWizard::left, this, &CalibrationPage::openOverview);
  connect(lensWizard_, &LensWizard::lensReady, rigWizard_, &RigWizard::setIntrinsics);
  connect(rigWizard_, &RigWizard::left, this, &CalibrationPage::openOverview);
}

CalibrationPage::~CalibrationPage() = default;

void CalibrationPage::openRigWizard() {
  stack_->setCurrentWidget(rigWizard_);
  rigWizard_->begin();
}

void CalibrationPage::openLensWizard() {
  stack_->setCurrentWidget(lensWizard_);
  lensWizard_->begin();
}

void CalibrationPage::openEncoder() {
  stack_->setCurrentWidget(encoder_);
  encoder_->begin();
}

void CalibrationPage::openReference() {
  stack_->setCurrentWidget(reference_);
  reference_->begin();
}

void CalibrationPage::openStudy() {
  stack_->setCurrentWidget(study_);
  study_->begin();
}

void CalibrationPage::openOverview() {
  stack_->setCurrentWidget(overview_);
  overview_->refresh();
}

void CalibrationPage::showLine(const LineSnapshot& line, PullDetail detail) {
  if (detail != PullDetail::Everything) return;
  if (stack_->currentWidget() == overview_) overview_->showLine(line);
  // The wizards that need the rig close while the line measures, seen or not.
  rigWizard_->showLine(line);
  lensWizard_->showLine(line);
  encoder_->showLine(line);
  reference_->showLine(line);
  study_->showLine(line);
}

void CalibrationPage::showEvent(QShowEvent* event) {
  Page::showEvent(event);
  if (stack_->currentWidget() == overview_) overview_->refresh();
}

void CalibrationPage::changeEvent(QEvent* event) {
  Page::changeEvent(event);
  if (event->type() != QEvent::LanguageChange) return;
  overview_->retranslate();
  rigWizard_->retranslate();
  lensWizard_->retranslate();
  encoder_->retranslate();
  reference_->retranslate();
  study_->retranslate();
}

}  // namespace vignole
