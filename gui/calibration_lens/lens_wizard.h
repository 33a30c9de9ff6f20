#pragma once
// The wizard of one camera's lens: pictures of a flat target, the lens model chosen by the data, handed on to the
// wizard of the range finders.

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "gui/bridge/background_job.h"
#include "gui/bridge/workplace.h"
#include "gui/calibration_lens/lens_stand.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QStackedWidget;
class QTableWidget;

namespace vignole {

class CalibrationDesk;
class CoverageMap;
class ClosedStep;
class Panel;
class PlotPicture;
class StepList;
class TargetPicture;

class LensWizard : public QWidget {
  Q_OBJECT

 public:
  LensWizard(Workplace& place, CalibrationDesk& desk, QWidget* parent = nullptr);
  ~LensWizard() override;

  void begin();
  void showLine(const LineSnapshot& line);
  void retranslate();

  enum class Stage { Prepare, Pictures, Solve, Result };
  [[nodiscard]] Stage stage() const { return stage_; }
  [[nodiscard]] bool looking() const { return look_.running() || lookAgain_; }
  [[nodiscard]] const std::shared_ptr<const LensSight>& sight() const { return sight_; }
  [[nodiscard]] const std::vector<TargetView>& taken() const { return taken_; }
  [[nodiscard]] const std::optional<IntrinsicsCalibration>& result() const { return result_; }
  [[nodiscard]] const NextView& nextView() const { return next_; }
  [[nodiscard]] bool advising() const { return advice_.running(); }

 signals:
  void left();
  void sightChanged();
  void solved();
  void lensReady(int camera, const CalibratedIntrinsics& lens);  ///< accepted, to be used with the plate

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void go(Stage stage);
  void look();
  void take();
  void advise();
  void solve();
  void use();
  void save();
  void setPose(const HeldTarget& pose);
  [[nodiscard]] HeldTarget handPose() const;
  [[nodiscard]] int camera() const;
  void showAll();
  void showSentence();
  void showResult();
  QWidget* makePictures();
  QWidget* makeResult();
  QWidget* makeFoot();

  Workplace& place_;
  CalibrationDesk& desk_;
  Stage stage_ = Stage::Prepare;
  LensStandSettings stand_;
  Intrinsics rough_;  ///< of the calibration in force
  Recipe recipe_;
  std::shared_ptr<const LensSight> sight_;
  std::vector<TargetView> taken_;
  std::vector<std::shared_ptr<const LensSight>> pictures_;
  NextView next_;
  std::optional<IntrinsicsCalibration> result_;
  QString words_, problem_;
  int shots_ = 0;
  bool lookAgain_ = false, lineRuns_ = false, cancelled_ = false, handedOn_ = false;

  QStackedWidget *whole_, *centre_;
  Panel *stepPanel_, *preparePanel_, *solvePanel_, *coveragePanel_, *viewPanel_, *picturePanel_, *mapPanel_,
      *tablePanel_;
  StepList* steps_;
  QLabel *prepareWords_, *cameraWord_, *countWord_, *sentence_, *detail_, *solveWords_, *verdict_, *viewWords_;
  QComboBox* camera_;
  QSpinBox* count_;
  TargetPicture* picture_;
  CoverageMap* coverage_;
  QTableWidget *views_, *table_;
  QWidget* hand_;
  std::array<QDoubleSpinBox*, 6> spins_{};
  PlotPicture *residuals_, *seen_;
  QProgressBar* progress_;
  QPushButton *asShown_, *leave_, *take_, *nextButton_, *cancel_, *use_, *save_;
  BackgroundJob look_, advice_, solve_;
  ClosedStep* closed_;
};

}  // namespace vignole
