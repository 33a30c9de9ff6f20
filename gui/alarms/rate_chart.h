#pragma once
// How many alarms came in each ten minutes of the last eight hours.

#include <QVector>
#include <QWidget>

#include "gui/theme/theme.h"

namespace vignole {

class RateChart : public QWidget {
  Q_OBJECT

 public:
  explicit RateChart(const Theme& theme, QWidget* parent = nullptr);
  /// How many seconds ago each alarm came.
  void show(const QVector<double>& agesS);
  [[nodiscard]] const QVector<int>& bars() const { return bars_; }  ///< oldest first
  [[nodiscard]] QSize sizeHint() const override { return {480, 180}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {200, 84}; }

 protected:
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  const Theme& theme_;
  QVector<int> bars_;
};

}  // namespace vignole
