#pragma once
// Calibration: overview, and the wizards that lead to another one.

#include "gui/bridge/workplace.h"
#include "gui/main_window/page.h"

class QStackedWidget;

namespace vignole {

class CalibrationDesk;
class CalibrationOverview;
class EncoderPanel;
class LensWizard;
class ReferencePanel;
class RigWizard;
class StudyPanel;

class CalibrationPage : public Page {
  Q_OBJECT

 public:
  explicit CalibrationPage(Workplace& place, QWidget* parent = nullptr);
  ~CalibrationPage() override;
  void showLine(const LineSnapshot& line, PullDetail detail) override;

  void openRigWizard();
  void openLensWizard();
  void openEncoder();
  void openReference();
  void openStudy();
  void openOverview();
  [[nodiscard]] CalibrationDesk& desk() { return *desk_; }
  [[nodiscard]] CalibrationOverview& overview() { return *overview_; }
  [[nodiscard]] RigWizard& rigWizard() { return *rigWizard_; }
  [[nodiscard]] LensWizard& lensWizard() { return *lensWizard_; }
  [[nodiscard]] EncoderPanel& encoder() { return *encoder_; }
  [[nodiscard]] ReferencePanel& reference() { return *reference_; }
  [[nodiscard]] StudyPanel& study() { return *study_; }

 protected:
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  Workplace& place_;
  CalibrationDesk* desk_;
  QStackedWidget* stack_;
  CalibrationOverview* overview_;
  RigWizard* rigWizard_;
  LensWizard* lensWizard_;
  EncoderPanel* encoder_;
  ReferencePanel* reference_;
  StudyPanel* study_;
};

}  // namespace vignole
