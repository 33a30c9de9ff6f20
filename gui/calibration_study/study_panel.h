#pragma once
// The parameter study: which settings of the calibration matter, and which to take.

#include <QWidget>
#include <array>
#include <memory>
#include <optional>

#include "calibration/parameter_study/parameter_study.h"
#include "gui/bridge/background_job.h"
#include "gui/bridge/workplace.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QTableWidget;
class QTemporaryDir;

namespace vignole {

class Panel;
class PlotPicture;

class StudyPanel : public QWidget {
  Q_OBJECT

 public:
  explicit StudyPanel(Workplace& place, QWidget* parent = nullptr);
  ~StudyPanel() override;
  void begin();
  void showLine(const LineSnapshot& line);
  void retranslate();
  /// Levels of a factor, parted by commas; empty: it is not varied.
  void setLevels(const QString& factor, const QString& levels);
  [[nodiscard]] const std::optional<ParameterStudy>& study() const { return study_; }
  [[nodiscard]] bool running() const { return job_.running(); }

 signals:
  void left();
  void studied();  ///< an answer has come, whatever it is

 private:
  [[nodiscard]] std::string planText() const;
  void start();
  void saveReport();
  void showAll();

  Workplace& place_;
  std::optional<ParameterStudy> study_;
  QString problem_, doing_;
  bool lineRuns_ = false;
  Panel *panel_, *resultPanel_;
  QLabel *words_, *countWord_, *sentence_, *reason_;
  QTableWidget *factors_, *influence_;
  QSpinBox* count_;
  QPushButton *start_, *cancel_, *leave_, *stopLine_, *report_;
  QProgressBar* progress_;
  std::array<PlotPicture*, 4> plots_{};
  std::unique_ptr<QTemporaryDir> pictures_;
  BackgroundJob job_, reportJob_;
};

}  // namespace vignole
