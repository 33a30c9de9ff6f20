#pragma once
// The encoder: millimetres a pulse from counts over a known length, and whether the wheels slip.

#include <QWidget>
#include <optional>
#include <vector>

#include "calibration/encoder/encoder_calibration.h"
#include "gui/bridge/workplace.h"

class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace vignole {

class Panel;
class PlotPicture;

class EncoderPanel : public QWidget {
  Q_OBJECT

 public:
  explicit EncoderPanel(Workplace& place, QWidget* parent = nullptr);
  void begin();
  void showLine(const LineSnapshot& line);
  void retranslate();
  [[nodiscard]] const std::optional<EncoderCalibration>& result() const { return result_; }

 signals:
  void left();

 private:
  void drive();
  void readFile();
  void calibrate();
  void showAll();

  Workplace& place_;
  std::vector<EncoderReading> readings_;
  std::optional<EncoderCalibration> result_;
  QString problem_;
  int drives_ = 0;
  bool lineRuns_ = false;
  Panel *panel_, *resultPanel_, *readingPanel_;
  QLabel *words_, *lengthWord_, *uncertaintyWord_, *slipWord_, *sentence_;
  QDoubleSpinBox *length_, *uncertainty_, *slip_;
  QPushButton *drive_, *file_, *leave_, *stopLine_;
  QTableWidget *figures_, *table_;
  PlotPicture* plot_;
};

}  // namespace vignole
