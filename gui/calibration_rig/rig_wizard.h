#pragma once
// The wizard of the range finders: the plate is put down, found, put down again; solved, compared, put in force.

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "gui/bridge/background_job.h"
#include "gui/bridge/workplace.h"
#include "gui/calibration_rig/plate_stand.h"
#include "gui/calibration_rig/rig_solution.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QStackedWidget;
class QTableWidget;

namespace vignole {

class CalibrationDesk;
class ClosedStep;
class Panel;
class PlateDrawing;
class PlateView;
class PlotPicture;
class StepList;
class WorthTable;

class RigWizard : public QWidget {
  Q_OBJECT

 public:
  RigWizard(Workplace& place, CalibrationDesk& desk, QWidget* parent = nullptr);
  ~RigWizard() override;

  /// Anew, from the calibration that the line has.
  void begin();
  /// Of one camera, to be used in place of those in force; kept until the program ends.
  void setIntrinsics(int camera, const CalibratedIntrinsics& intrinsics);
  /// While the line measures the plate cannot stand in the gauge: the wizard says so and waits.
  void showLine(const LineSnapshot& line);
  void retranslate();

  enum class Stage { Prepare, Placement, Solve, Compare, Apply };
  [[nodiscard]] Stage stage() const;
  [[nodiscard]] int placement() const { return step_ - 1; }  ///< 0, 1 ... while Stage::Placement
  [[nodiscard]] const std::shared_ptr<const PlateSight>& sight() const { return sight_; }
  [[nodiscard]] const std::optional<RigSolution>& solution() const { return solution_; }
  [[nodiscard]] bool looking() const { return look_.running() || lookAgain_; }
  [[nodiscard]] bool closedByLine() const { return lineRuns_; }

 signals:
  void left();
  void sightChanged();
  void solved();   ///< an answer has come, whatever it is
  void applied();  ///< an answer has come, whatever it is

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* makeSteps();
  QWidget* makePrepare();
  QWidget* makeViews();
  QWidget* makeSolve();
  QWidget* makeCompare();
  QWidget* makeApply();
  QWidget* makeFoot();
  QWidget* makeRight();
  void go(int step);
  void next();
  void back();
  void look();
  void solve();
  void apply();
  void saveReport();
  void setPose(const PlatePose& pose);
  [[nodiscard]] PlatePose handPose() const;
  [[nodiscard]] int placements() const;
  [[nodiscard]] bool nearEnough() const;
  [[nodiscard]] PlateStandSettings stand() const;
  [[nodiscard]] QString stepWord(int placement) const;
  void showAll();
  void showSteps();
  void showSentence();
  void showViews();
  void showFit();
  void showChecks();
  [[nodiscard]] QString moveWords() const;

  Workplace& place_;
  CalibrationDesk& desk_;
  int step_ = 0, take_ = 0;
  bool lineRuns_ = false, lookAgain_ = false, cancelled_ = false, applying_ = false;
  std::array<std::optional<CalibratedIntrinsics>, kCameraCount> intrinsics_;
  RigCalibration inForce_;
  Recipe recipe_;
  RigInputs known_;
  QString problem_;  ///< why nothing can be calibrated
  std::shared_ptr<const PlateSight> sight_;
  std::vector<std::shared_ptr<const PlateSight>> taken_;
  std::optional<RigSolution> solution_;
  QString result_;  ///< of the last step

  QStackedWidget *whole_, *centre_;
  Panel *stepPanel_, *worthPanel_, *fitPanel_, *platePanel_, *figurePanel_, *checkPanel_, *solvePanel_, *applyPanel_;
  StepList* steps_;
  QLabel *plateTitle_, *plateNote_, *prepareWords_, *countWord_, *faultWord_, *sentence_, *detail_, *solveWords_,
      *applyWords_, *applyResult_, *intervalWord_, *handWord_;
  PlateDrawing* drawing_;
  std::array<PlateView*, kCameraCount> views_{};
  QSpinBox *count_, *interval_;
  QComboBox* fault_;
  QDoubleSpinBox *x_, *y_, *turn_, *tilt_;
  QWidget* hand_;
  QPushButton *asShown_, *takeAgain_, *back_, *next_, *cancel_, *report_, *apply_, *leave_;
  QProgressBar* progress_;
  PlotPicture* figure_;
  QTableWidget *fit_, *checks_;
  WorthTable* worth_;
  QLineEdit* reason_;
  BackgroundJob look_, solve_, worthJob_, reportJob_;  // last: they end first
  ClosedStep* closed_;
};

}  // namespace vignole
