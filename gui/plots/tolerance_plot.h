#pragma once
// One dimension against its limits, over the length of a rail or over rails: values, band of others, expected value,
// both limits, a cursor. Wheel and drag zoom and pan. Takes plain values.

#include <QVector>
#include <QWidget>
#include <optional>

#include "gui/theme/theme.h"

class QCPCurve;
class QCPErrorBars;
class QCPGraph;
class QCPItemLine;
class QCPItemRect;
class QCPItemText;
class QCustomPlot;

namespace vignole {

struct ToleranceSeries {
  QString xLabel, yLabel;
  QVector<double> x, y;       ///< NaN in y: a gap
  QVector<double> low, high;  ///< of each value; empty: none
  QVector<double> bandX, bandLow, bandHigh;
  std::optional<double> expected, lower, upper;
  bool dots = false;       ///< single values, not joined to a curve
  QVector<QString> names;  ///< of the values, in place of numbers along x; empty: numbers
};

class TolerancePlot : public QWidget {
  Q_OBJECT

 public:
  explicit TolerancePlot(const Theme& theme, QWidget* parent = nullptr);
  ~TolerancePlot() override;
  void show(const ToleranceSeries& series);
  /// Whole range of x, limits and values in y.
  void fit();
  void zoom(double factor);  ///< along x, about the cursor or the middle
  /// Index of the nearest value; the cursor moves there.
  void setCursor(std::optional<int> value);
  [[nodiscard]] std::optional<int> cursor() const { return cursor_; }
  [[nodiscard]] const ToleranceSeries& series() const { return series_; }
  [[nodiscard]] double yMin() const;
  [[nodiscard]] double yMax() const;
  /// Of what is seen; false: cannot be written. Ending .pdf or .png.
  [[nodiscard]] bool save(const QString& file);
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, 120}; }

 signals:
  void cursorChanged();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void restyle();
  void placeItems();

  const Theme& theme_;
  ToleranceSeries series_;
  std::optional<int> cursor_;
  QCustomPlot* plot_;
  QCPGraph *values_, *bandLow_, *bandHigh_;
  QCPErrorBars* spans_;
  QCPItemLine *expected_, *lower_, *upper_, *cursorLine_;
  QCPItemRect *below_, *above_;
  QCPItemText *lowerText_, *upperText_, *expectedText_;
};

}  // namespace vignole
