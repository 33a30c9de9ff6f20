#pragma once
// Several curves over one length, each in a colour of its own with a key. Wheel and drag zoom and pan. Plain values.

#include <QVector>
#include <QWidget>

#include "gui/theme/theme.h"

class QCustomPlot;

namespace vignole {

struct RunCurve {
  QString name;
  QVector<double> x, y;                                  ///< NaN in y: a gap
  enum class Look { Run, Mean, Dots } look = Look::Run;  ///< Mean: broad, in the accent
};

/// A horizontal line across the plot with its name at the left end.
struct RunLevel {
  double y = 0;
  QString name;
  bool limit = false;  ///< of the tolerance: solid; else dashed
};

class RunsPlot : public QWidget {
  Q_OBJECT

 public:
  explicit RunsPlot(const Theme& theme, QWidget* parent = nullptr);
  void show(const QString& xLabel, const QString& yLabel, const QVector<RunCurve>& curves,
            const QVector<RunLevel>& levels = {});
  [[nodiscard]] const QVector<RunLevel>& levels() const { return levels_; }
  /// Without curves: what is missing and what to do.
  void setMessage(const QString& message);
  [[nodiscard]] const QVector<RunCurve>& curves() const { return curves_; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, 110}; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void draw();
  void addLevels();

  const Theme& theme_;
  QString xLabel_, yLabel_;
  QVector<RunCurve> curves_;
  QVector<RunLevel> levels_;
  QString message_;
  QCustomPlot* plot_;
};

}  // namespace vignole
