#pragma once
// One dimension over the length of a rail, live: values, expected value, both limits, where the rail is now. Takes
// plain values, no engine.

#include <QPointF>
#include <QVector>
#include <QWidget>
#include <optional>

#include "gui/theme/theme.h"
#include "report/state_symbol.h"

class QCPGraph;
class QCPItemLine;
class QCPItemRect;
class QCPItemText;
class QCustomPlot;

namespace vignole {

struct StripSeries {
  QString name;                            ///< "RAS_l"
  QString value;                           ///< as shown beside the plot
  std::optional<StateSymbol> symbol;       ///< none: no profile yet
  QVector<QPointF> points;                 ///< position in m, value
  QVector<QPair<double, double>> outside;  ///< stretches out of tolerance, m
  double lengthM = 0;                      ///< of the rail; 0: not known
  double positionM = 0;                    ///< where the rail is now
  double nominal = 0;
  std::optional<double> lower, upper;
  double least = 0.02;  ///< of the range beyond the values
  int decimals = 3;     ///< of a limit as deviation
  bool held = false;
  QString note;  ///< beside the cursor: why it stands still
};

class StripChart : public QWidget {
  Q_OBJECT

 public:
  explicit StripChart(const Theme& theme, QWidget* parent = nullptr);
  ~StripChart() override;
  void show(const StripSeries& series);
  [[nodiscard]] const StripSeries& series() const { return series_; }
  [[nodiscard]] QSize sizeHint() const override { return {816, 88}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {360, 76}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void restyle();
  void refresh();
  void refreshAxes();
  void refreshLimits();

  const Theme& theme_;
  StripSeries series_;
  QCustomPlot* plot_;
  QCPGraph *values_, *outside_;
  QCPItemLine *expected_, *lower_, *upper_, *cursor_;
  QCPItemRect *belowLower_, *aboveUpper_;
  QCPItemText *limitText_, *note_;
};

}  // namespace vignole
