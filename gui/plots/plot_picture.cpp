#include "gui/plots/plot_picture.h"

#include <QPainter>
#include <utility>

#include "report/plot_painter.h"

namespace vignole {

PlotPicture::PlotPicture(const Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme) {
  connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void PlotPicture::show(Plot plot) {
  plot_ = std::move(plot);
  update();
}

void PlotPicture::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), theme_.palette().panel2);
  paintPlot(painter, QRectF(rect()).adjusted(8, 8, -4, -8), plot_, theme_.palette());
}

}  // namespace vignole
