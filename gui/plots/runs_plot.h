#pragma once
// Several curves over one length, each in a colour of its own with a key. Wheel and drag zoom and pan. Plain values.

#include <QVector>
#include <QWidget>
#include <optional>

#include "gui/theme/theme.h"

class QCustomPlot;

namespace vignole {

struct RunCurve {
  QString name;
  QVector<double> x, y;
};

class RunsPlot : public QWidget {
  Q_OBJECT

 public:
  explicit RunsPlot(const Theme& theme, QWidget* parent = nullptr);
  void show(const QString& xLabel, const QString& yLabel, const QVector<RunCurve>& curves,
            const QVector<double>& levels = {});  ///< levels: horizontal dashed lines
  [[nodiscard]] const QVector<RunCurve>& curves() const { return curves_; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, 110}; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void draw();

  const Theme& theme_;
  QString xLabel_, yLabel_;
  QVector<RunCurve> curves_;
  QVector<double> levels_;
  QCustomPlot* plot_;
};

}  // namespace vignole
