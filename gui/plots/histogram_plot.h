#pragma once
// How often which value: bars along the values' axis, on the same scale as the chart beside it. Takes plain values.

#include <QVector>
#include <QWidget>
#include <optional>

#include "gui/theme/theme.h"

namespace vignole {

class HistogramPlot : public QWidget {
  Q_OBJECT

 public:
  explicit HistogramPlot(const Theme& theme, QWidget* parent = nullptr);
  /// `low`, `high`: the axis. Values that are no number do not count.
  void show(const QVector<double>& values, double low, double high, std::optional<double> lower,
            std::optional<double> upper);
  /// Share of the values in the fullest bar; 0 without values.
  [[nodiscard]] double largestShare() const { return largest_; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {160, 120}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const Theme& theme_;
  QVector<double> shares_;
  double low_ = 0, high_ = 1, largest_ = 0;
  std::optional<double> lower_, upper_;
};

}  // namespace vignole
