#pragma once
// The check on a reference piece: certificate beside what the gauge says, dimension by dimension.

#include <QWidget>
#include <optional>

#include "gui/bridge/background_job.h"
#include "gui/bridge/workplace.h"
#include "gui/calibration_reference/reference_check.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QTableWidget;

namespace vignole {

class Panel;

class ReferencePanel : public QWidget {
  Q_OBJECT

 public:
  explicit ReferencePanel(Workplace& place, QWidget* parent = nullptr);
  ~ReferencePanel() override;
  void begin();
  void showLine(const LineSnapshot& line);
  void retranslate();
  [[nodiscard]] const std::optional<ReferenceResult>& result() const { return result_; }
  [[nodiscard]] bool running() const { return job_.running(); }

 signals:
  void left();
  void checked();  ///< an answer has come, whatever it is

 private:
  void start();
  void showAll();

  Workplace& place_;
  std::optional<ReferenceResult> result_;
  QString problem_, calibration_;
  bool lineRuns_ = false;
  Panel *panel_, *tablePanel_;
  QLabel *words_, *countWord_, *sentence_;
  QSpinBox* count_;
  QPushButton *start_, *cancel_, *leave_, *stopLine_;
  QProgressBar* progress_;
  QTableWidget* table_;
  BackgroundJob job_;
};

}  // namespace vignole
