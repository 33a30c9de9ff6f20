#include "gui/plots/runs_plot.h"

#include <array>
#include <qcustomplot.h>

namespace vignole {

RunsPlot::RunsPlot(const Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme), plot_(new QCustomPlot(this)) {
  plot_->setMinimumSize(48, 48);
  plot_->setFocusPolicy(Qt::NoFocus);
  plot_->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
  connect(plot_, &QCustomPlot::mouseDoubleClick, this, &RunsPlot::draw);
  connect(&theme_, &Theme::changed, this, &RunsPlot::draw);
  draw();
}

void RunsPlot::show(const QString& xLabel, const QString& yLabel, const QVector<RunCurve>& curves,
                    const QVector<double>& levels) {
  xLabel_ = xLabel;
  yLabel_ = yLabel;
  curves_ = curves;
  levels_ = levels;
  draw();
}

void RunsPlot::draw() {
  const Palette& p = theme_.palette();
  plot_->clearItems();
  plot_->clearGraphs();
  plot_->setBackground(p.panel);
  plot_->axisRect()->setBackground(p.panel2);
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) {
    axis->setBasePen(QPen(p.line));
    axis->setTickPen(QPen(p.line));
    axis->setSubTicks(false);
    axis->setTickLabelFont(uiFont(14));
    axis->setTickLabelColor(p.t3);
    axis->setLabelFont(uiFont(14));
    axis->setLabelColor(p.t3);
    axis->grid()->setPen(QPen(p.line2, 1));
    axis->grid()->setZeroLinePen(Qt::NoPen);
  }
  plot_->xAxis->setLabel(xLabel_);
  plot_->yAxis->setLabel(yLabel_);
  const std::array<Qt::PenStyle, 3> styles = {Qt::SolidLine, Qt::DashLine, Qt::DotLine};
  for (qsizetype i = 0; i < curves_.size(); ++i) {
    QCPGraph* graph = plot_->addGraph();
    graph->setName(curves_[i].name);
    graph->setPen(curves_.size() == 1 ? QPen(p.t1, 1)
                                      : QPen(p.camera[static_cast<std::size_t>(i % 4)], 1.2,
                                             styles[static_cast<std::size_t>(i / 4 % 3)]));
    graph->setAdaptiveSampling(true);
    graph->setAntialiased(false);
    graph->setData(curves_[i].x, curves_[i].y, true);
  }
  plot_->rescaleAxes();
  plot_->yAxis->scaleRange(1.2);
  for (const double level : levels_) {
    auto* line = new QCPItemStraightLine(plot_);
    line->point1->setCoords(0, level);
    line->point2->setCoords(1, level);
    line->setPen(QPen(p.t2, 1.25, Qt::DashLine));
  }
  plot_->legend->setVisible(curves_.size() > 1);
  plot_->legend->setFont(uiFont(14));
  plot_->legend->setTextColor(p.t2);
  plot_->legend->setBrush(p.panel2);
  plot_->legend->setBorderPen(QPen(p.line));
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void RunsPlot::resizeEvent(QResizeEvent* /*event*/) { plot_->setGeometry(rect()); }

}  // namespace vignole
