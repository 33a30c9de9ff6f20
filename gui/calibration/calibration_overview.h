#pragma once
// The calibration in force and what it is worth, those before it, the wizards, and the health of the cameras.

#include <QWidget>
#include <optional>

#include "calibration/assessment/comparison.h"
#include "gui/bridge/background_job.h"
#include "gui/bridge/workplace.h"
#include "gui/calibration_records/dimension_worth.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace vignole {

class CalibrationDesk;
class DriftPanel;
class FramesDrawing;
class Panel;

class CalibrationOverview : public QWidget {
  Q_OBJECT

 public:
  CalibrationOverview(Workplace& place, CalibrationDesk& desk, QWidget* parent = nullptr);
  ~CalibrationOverview() override;
  void refresh();
  void showLine(const LineSnapshot& line);
  void retranslate();
  void chooseKept(int row);
  [[nodiscard]] const std::optional<Comparison>& comparison() const { return comparison_; }

 signals:
  void rigWizardAsked();
  void lensWizardAsked();
  void encoderAsked();
  void referenceAsked();
  void studyAsked();
  void compared();
  void reverted();  ///< an answer has come, whatever it is

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showInForce();
  void showHistory();
  void showWorth();
  void showChoice();
  void compareChosen();
  void revert();
  [[nodiscard]] int chosen() const;

  Workplace& place_;
  CalibrationDesk& desk_;
  std::vector<DimensionWorth> worth_;
  std::string worthOf_;
  std::optional<Comparison> comparison_;
  QString result_;
  Panel *inForcePanel_, *worthPanel_, *historyPanel_, *wizardPanel_;
  DriftPanel* drift_;
  FramesDrawing* frames_;
  QLabel *name_, *age_, *facts_, *wizardWords_, *historyWords_, *resultWords_;
  QPushButton *rigWizard_, *lensWizard_, *encoder_, *reference_, *study_, *revert_;
  QTableWidget *history_, *dimensions_;
  QLineEdit* reason_;
  BackgroundJob worthJob_, compareJob_;
};

}  // namespace vignole
