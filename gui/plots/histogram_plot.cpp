#include "gui/plots/histogram_plot.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace vignole {

namespace {
constexpr int kBars = 60;
constexpr double kRight = 70;
}  // namespace

HistogramPlot::HistogramPlot(const Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme) {
  connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void HistogramPlot::show(const QVector<double>& values, double low, double high, std::optional<double> lower,
                         std::optional<double> upper) {
  low_ = low;
  high_ = std::max(high, low + 1e-9);
  lower_ = lower;
  upper_ = upper;
  shares_.fill(0, kBars);
  double count = 0;
  for (const double v : values) {
    if (!std::isfinite(v)) continue;
    count += 1;
    const int bar = static_cast<int>(std::floor((v - low_) / (high_ - low_) * kBars));
    if (bar >= 0 && bar < kBars) shares_[bar] += 1;
  }
  largest_ = 0;
  for (double& share : shares_) {
    if (count > 0) share /= count;
    largest_ = std::max(largest_, share);
  }
  update();
}

void HistogramPlot::paintEvent(QPaintEvent* /*event*/) {
  const Palette& p = theme_.palette();
  QPainter painter(this);
  const QRectF area(0, 8, width() - kRight, height() - 16);
  painter.fillRect(area, p.panel2);
  const auto yOf = [&](double value) { return area.bottom() - (value - low_) / (high_ - low_) * area.height(); };
  if (upper_)
    painter.fillRect(QRectF(area.left(), area.top(), area.width(), std::max(0.0, yOf(*upper_) - area.top())), p.chan);
  if (lower_)
    painter.fillRect(QRectF(area.left(), yOf(*lower_), area.width(), std::max(0.0, area.bottom() - yOf(*lower_))),
                     p.chan);
  const double bar = area.height() / kBars;
  for (int i = 0; i < shares_.size(); ++i)
    if (shares_[i] > 0)
      painter.fillRect(QRectF(area.left(), area.bottom() - (i + 1) * bar + 0.5,
                              area.width() * 0.94 * shares_[i] / largest_, std::max(1.0, bar - 1)),
                       p.t3);
  painter.setFont(uiFont(14, 500));
  for (const auto& limit : {lower_, upper_})
    if (limit && *limit > low_ && *limit < high_) {
      const double y = yOf(*limit);
      painter.setPen(QPen(p.t1, 2));
      painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
      painter.drawText(QPointF(area.right() + 6, y + 5), locale().toString(*limit, 'f', 3));
    }
  painter.setPen(QPen(p.line, 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(area);
}

}  // namespace vignole
