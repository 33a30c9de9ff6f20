#include "gui/plots/tolerance_plot.h"

#include <algorithm>
#include <cmath>
#include <qcustomplot.h>

namespace vignole {

namespace {

QCPItemLine* straight(QCustomPlot* plot) {
  auto* line = new QCPItemLine(plot);
  line->setClipToAxisRect(true);
  return line;
}

QCPItemText* label(QCustomPlot* plot, Qt::Alignment alignment) {
  auto* text = new QCPItemText(plot);
  text->setPositionAlignment(alignment);
  text->position->setTypeX(QCPItemPosition::ptAxisRectRatio);
  text->setClipToAxisRect(true);
  return text;
}

}  // namespace

TolerancePlot::TolerancePlot(const Theme& theme, QWidget* parent)
    : QWidget(parent), theme_(theme), plot_(new QCustomPlot(this)) {
  plot_->setFocusPolicy(Qt::NoFocus);
  plot_->setMinimumSize(48, 48);
  plot_->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
  plot_->setNoAntialiasingOnDrag(true);
  plot_->yAxis->setNumberFormat(QStringLiteral("f"));
  below_ = new QCPItemRect(plot_);
  above_ = new QCPItemRect(plot_);
  bandLow_ = plot_->addGraph();
  bandHigh_ = plot_->addGraph();
  bandHigh_->setChannelFillGraph(bandLow_);
  values_ = plot_->addGraph();
  values_->setAdaptiveSampling(true);
  values_->setAntialiased(false);  // long lines: a pixel's edge is not worth ten times the time
  spans_ = new QCPErrorBars(plot_->xAxis, plot_->yAxis);
  spans_->setDataPlottable(values_);
  spans_->setErrorType(QCPErrorBars::etValueError);
  spans_->setWhiskerWidth(0);
  expected_ = straight(plot_);
  lower_ = straight(plot_);
  upper_ = straight(plot_);
  cursorLine_ = straight(plot_);
  lowerText_ = label(plot_, Qt::AlignLeft | Qt::AlignTop);
  upperText_ = label(plot_, Qt::AlignLeft | Qt::AlignBottom);
  expectedText_ = label(plot_, Qt::AlignLeft | Qt::AlignBottom);
  connect(plot_, &QCustomPlot::mouseDoubleClick, this, &TolerancePlot::fit);
  connect(plot_, &QCustomPlot::mouseMove, this, [this](QMouseEvent* event) {
    if (event->buttons() != Qt::NoButton || series_.x.isEmpty()) return;
    const double x = plot_->xAxis->pixelToCoord(event->position().x());
    const auto after = std::lower_bound(series_.x.begin(), series_.x.end(), x);
    auto at = static_cast<int>(after - series_.x.begin());
    if (at == series_.x.size() || (at > 0 && x - series_.x[at - 1] < series_.x[at] - x)) --at;
    setCursor(at);
  });
  connect(plot_->xAxis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this, &TolerancePlot::placeItems);
  connect(plot_->yAxis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this, &TolerancePlot::placeItems);
  connect(&theme_, &Theme::changed, this, &TolerancePlot::restyle);
  restyle();
}

TolerancePlot::~TolerancePlot() = default;

void TolerancePlot::restyle() {
  const Palette& p = theme_.palette();
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
  for (QCPItemRect* beyond : {below_, above_}) {
    beyond->setPen(Qt::NoPen);
    beyond->setBrush(p.chan);
  }
  bandLow_->setPen(Qt::NoPen);
  bandHigh_->setPen(Qt::NoPen);
  bandHigh_->setBrush(p.accentSoft);
  values_->setPen(QPen(p.t1, 1));
  spans_->setPen(QPen(p.t2, 1.5));
  expected_->setPen(QPen(p.t2, 1.25, Qt::DashLine));
  lower_->setPen(QPen(p.t1, 2));
  upper_->setPen(QPen(p.t1, 2));
  cursorLine_->setPen(QPen(p.accent, 2));
  for (QCPItemText* text : {lowerText_, upperText_, expectedText_}) {
    text->setFont(uiFont(14, 500));
    text->setColor(p.t1);
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void TolerancePlot::show(const ToleranceSeries& series) {
  const bool another =
      series.x.isEmpty() || series_.x.isEmpty() || series.xLabel != series_.xLabel || series.yLabel != series_.yLabel;
  series_ = series;
  values_->setData(series.x, series.y, true);
  values_->setLineStyle(series.dots ? QCPGraph::lsNone : QCPGraph::lsLine);
  values_->setScatterStyle(series.dots ? QCPScatterStyle(QCPScatterStyle::ssDisc, 7) : QCPScatterStyle::ssNone);
  QVector<double> under, over;
  for (qsizetype i = 0; i < series.low.size(); ++i) {
    under.append(series.y[i] - series.low[i]);
    over.append(series.high[i] - series.y[i]);
  }
  spans_->setData(under, over);
  bandLow_->setData(series.bandX, series.bandLow, true);
  bandHigh_->setData(series.bandX, series.bandHigh, true);
  plot_->xAxis->setLabel(series.xLabel);
  plot_->yAxis->setLabel(series.yLabel);
  if (series.names.isEmpty()) {
    plot_->xAxis->setTicker(QSharedPointer<QCPAxisTicker>::create());
  } else {
    auto ticker = QSharedPointer<QCPAxisTickerText>::create();
    const qsizetype step = std::max<qsizetype>(1, series.names.size() / 6);
    for (qsizetype i = 0; i < series.names.size(); i += step) ticker->addTick(series.x[i], series.names[i]);
    plot_->xAxis->setTicker(ticker);
  }
  if (cursor_ && *cursor_ >= series.x.size()) cursor_.reset();
  if (another)
    fit();
  else
    placeItems();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void TolerancePlot::fit() {
  double low = 1e300, high = -1e300;
  const auto take = [&](double v) {
    if (!std::isfinite(v)) return;
    low = std::min(low, v);
    high = std::max(high, v);
  };
  for (const QVector<double>* all : {&series_.y, &series_.low, &series_.high, &series_.bandLow, &series_.bandHigh})
    for (const double v : *all) take(v);
  for (const auto& limit : {series_.expected, series_.lower, series_.upper})
    if (limit) take(*limit);
  if (low > high) low = 0, high = 1;
  const double room = std::max(high - low, 1e-6) * 0.14;
  plot_->yAxis->setRange(low - room, high + room);
  double from = 0, to = 1;
  if (!series_.x.isEmpty()) from = series_.x.front(), to = series_.x.back();
  const double side = series_.dots ? 0.7 : 0;
  plot_->xAxis->setRange(from - side, std::max(to, from + 1e-6) + side);
  placeItems();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void TolerancePlot::zoom(double factor) {
  const double about = cursor_ ? series_.x[*cursor_] : plot_->xAxis->range().center();
  plot_->xAxis->scaleRange(factor, about);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void TolerancePlot::setCursor(std::optional<int> value) {
  if (value && (series_.x.isEmpty() || *value < 0 || *value >= series_.x.size())) return;
  if (value == cursor_) return;
  cursor_ = value;
  placeItems();
  plot_->replot(QCustomPlot::rpQueuedReplot);
  emit cursorChanged();
}

double TolerancePlot::yMin() const { return plot_->yAxis->range().lower; }
double TolerancePlot::yMax() const { return plot_->yAxis->range().upper; }

void TolerancePlot::placeItems() {
  const QCPRange x = plot_->xAxis->range(), y = plot_->yAxis->range();
  plot_->yAxis->setNumberPrecision(y.size() > 20 ? 0 : y.size() > 2 ? 1 : y.size() > 0.4 ? 2 : 3);
  const auto line = [&](QCPItemLine* item, const std::optional<double>& at) {
    item->setVisible(at.has_value());
    if (!at) return;
    item->start->setCoords(x.lower, *at);
    item->end->setCoords(x.upper, *at);
  };
  line(expected_, series_.expected);
  line(lower_, series_.lower);
  line(upper_, series_.upper);
  const auto beyond = [&](QCPItemRect* item, const std::optional<double>& from, double to) {
    item->setVisible(from.has_value());
    if (!from) return;
    item->topLeft->setCoords(x.lower, std::max(*from, to));
    item->bottomRight->setCoords(x.upper, std::min(*from, to));
  };
  beyond(below_, series_.lower, std::min(y.lower, series_.lower.value_or(y.lower)));
  beyond(above_, series_.upper, std::max(y.upper, series_.upper.value_or(y.upper)));
  const auto text = [&](QCPItemText* item, const std::optional<double>& at, const QString& words) {
    item->setVisible(at.has_value());
    if (!at) return;
    item->position->setCoords(0.008, *at);
    item->setText(words.arg(locale().toString(*at, 'f', 3)));
  };
  text(lowerText_, series_.lower, tr("lower limit %1"));
  text(upperText_, series_.upper, tr("upper limit %1"));
  text(expectedText_, series_.expected, tr("expected %1"));
  cursorLine_->setVisible(cursor_.has_value());
  if (cursor_) {
    cursorLine_->start->setCoords(series_.x[*cursor_], y.lower);
    cursorLine_->end->setCoords(series_.x[*cursor_], y.upper);
  }
}

bool TolerancePlot::save(const QString& file) {
  return file.endsWith(QStringLiteral(".pdf"), Qt::CaseInsensitive) ? plot_->savePdf(file, 1200, 600)
                                                                    : plot_->savePng(file, 1600, 800, 1);
}

void TolerancePlot::resizeEvent(QResizeEvent* /*event*/) { plot_->setGeometry(rect()); }

}  // namespace vignole
