#pragma once
// Calibration: overview, and the wizards that lead to another one.

#include "gui/bridge/workplace.h"
#include "gui/main_window/page.h"

class QStackedWidget;

namespace vignole {

class CalibrationDesk;
class CalibrationOverview;
class RigWizard;

class CalibrationPage : public Page {
  Q_OBJECT

 public:
  explicit CalibrationPage(Workplace& place, QWidget* parent = nullptr);
  ~CalibrationPage() override;
  void showLine(const LineSnapshot& line, PullDetail detail) override;

  void openRigWizard();
  void openOverview();
  [[nodiscard]] CalibrationDesk& desk() { return *desk_; }
  [[nodiscard]] CalibrationOverview& overview() { return *overview_; }
  [[nodiscard]] RigWizard& rigWizard() { return *rigWizard_; }

 protected:
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  Workplace& place_;
  CalibrationDesk* desk_;
  QStackedWidget* stack_;
  CalibrationOverview* overview_;
  RigWizard* rigWizard_;
};

}  // namespace vignole
