#pragma once
// A plot of a report, as it is printed, on the screen: the paper's figures look the same in both.

#include <QWidget>

#include "gui/theme/theme.h"
#include "report/document.h"

namespace vignole {

class PlotPicture : public QWidget {
  Q_OBJECT

 public:
  explicit PlotPicture(const Theme& theme, QWidget* parent = nullptr);
  void show(Plot plot);
  [[nodiscard]] const Plot& plot() const { return plot_; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {200, 96}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const Theme& theme_;
  Plot plot_;
};

}  // namespace vignole
