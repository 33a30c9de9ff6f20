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
                    const QVector<RunLevel>& levels) {
  xLabel_ = xLabel;
  yLabel_ = yLabel;
  curves_ = curves;
  levels_ = levels;
  message_.clear();
  draw();
}

void RunsPlot::setMessage(const QString& message) {
  message_ = message;
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
  qsizetype runs = 0;
  for (const RunCurve& curve : curves_) runs += curve.look == RunCurve::Look::Mean ? 0 : 1;
  qsizetype run = 0;
  for (const RunCurve& curve : curves_) {
    QCPGraph* graph = plot_->addGraph();
    graph->setName(curve.name);
    if (curve.look == RunCurve::Look::Mean) {
      graph->setPen(QPen(p.accent, 3));
      graph->setAdaptiveSampling(false);  // its gaps are between two points of one place
    } else {
      const QColor colour = runs == 1 ? p.t1 : p.camera[static_cast<std::size_t>(run % 4)];
      graph->setPen(QPen(colour, runs == 1 ? 1 : 1.2, styles[static_cast<std::size_t>(run / 4 % 3)]));
      graph->setAdaptiveSampling(true);
      if (curve.look == RunCurve::Look::Dots) {
        graph->setLineStyle(QCPGraph::lsNone);
        graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, QPen(colour), QBrush(colour), 7));
      }
      ++run;
    }
    graph->setAntialiased(false);
    graph->setData(curve.x, curve.y, true);
  }
  plot_->rescaleAxes();
  QCPRange y = plot_->yAxis->range();
  for (const RunLevel& level : levels_) y.expand(level.y);
  plot_->yAxis->setRange(y);
  plot_->yAxis->scaleRange(levels_.isEmpty() ? 1.2 : 1.35);  // names of levels need room too
  addLevels();
  if (curves_.isEmpty() && !message_.isEmpty()) {
    auto* text = new QCPItemText(plot_);
    text->position->setType(QCPItemPosition::ptAxisRectRatio);
    text->position->setCoords(0.5, 0.5);
    text->setText(message_);
    text->setFont(uiFont(16));
    text->setColor(p.t2);
  }
  plot_->legend->setVisible(curves_.size() > 1);
  plot_->legend->setFont(uiFont(14));
  plot_->legend->setTextColor(p.t2);
  plot_->legend->setBrush(p.panel2);
  plot_->legend->setBorderPen(QPen(p.line));
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void RunsPlot::addLevels() {
  const Palette& p = theme_.palette();
  for (const RunLevel& level : levels_) {
    auto* line = new QCPItemStraightLine(plot_);
    line->point1->setCoords(0, level.y);
    line->point2->setCoords(1, level.y);
    line->setPen(level.limit ? QPen(p.t1, 1.5) : QPen(p.t2, 1.25, Qt::DashLine));
    if (level.name.isEmpty()) continue;
    auto* text = new QCPItemText(plot_);
    text->position->setTypeX(QCPItemPosition::ptAxisRectRatio);
    text->position->setTypeY(QCPItemPosition::ptPlotCoords);
    text->position->setCoords(0, level.y);
    text->setPositionAlignment(Qt::AlignLeft | Qt::AlignBottom);
    text->setPadding(QMargins(8, 2, 4, 2));
    text->setText(level.name);
    text->setFont(uiFont(14, 500));
    text->setColor(p.t1);
    QColor ground = p.panel2;
    ground.setAlpha(215);  // curves beneath stay to be seen
    text->setBrush(ground);
  }
}

void RunsPlot::resizeEvent(QResizeEvent* /*event*/) { plot_->setGeometry(rect()); }

}  // namespace vignole
