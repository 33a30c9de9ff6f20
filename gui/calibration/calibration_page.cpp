#include "gui/calibration/calibration_page.h"

#include <QEvent>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "gui/calibration/calibration_overview.h"
#include "gui/calibration_records/calibration_desk.h"
#include "gui/calibration_rig/rig_wizard.h"

namespace vignole {

CalibrationPage::CalibrationPage(Workplace& place, QWidget* parent)
    : Page(parent), place_(place), desk_(new CalibrationDesk(place, this)), stack_(new QStackedWidget(this)) {
  setObjectName(QStringLiteral("page"));
  setFocusPolicy(Qt::ClickFocus);
  overview_ = new CalibrationOverview(place, *desk_, stack_);
  rigWizard_ = new RigWizard(place, *desk_, stack_);
  stack_->addWidget(overview_);
  stack_->addWidget(rigWizard_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 12, 12, 12);
  column->addWidget(stack_);
  connect(overview_, &CalibrationOverview::rigWizardAsked, this, &CalibrationPage::openRigWizard);
  connect(rigWizard_, &RigWizard::left, this, &CalibrationPage::openOverview);
}

CalibrationPage::~CalibrationPage() = default;

void CalibrationPage::openRigWizard() {
  stack_->setCurrentWidget(rigWizard_);
  rigWizard_->begin();
}

void CalibrationPage::openOverview() {
  stack_->setCurrentWidget(overview_);
  overview_->refresh();
}

void CalibrationPage::showLine(const LineSnapshot& line, PullDetail detail) {
  if (detail != PullDetail::Everything) return;
  if (stack_->currentWidget() == overview_)
    overview_->showLine(line);
  else
    rigWizard_->showLine(line);
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
}

}  // namespace vignole
