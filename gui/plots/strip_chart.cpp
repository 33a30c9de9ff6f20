#include "gui/plots/strip_chart.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <qcustomplot.h>

#include "gui/theme/inscription.h"

namespace vignole {

namespace {
constexpr int kLabelWidth = 118;

QCPItemLine* horizontal(QCustomPlot* plot) {
  auto* line = new QCPItemLine(plot);
  line->setClipToAxisRect(true);
  return line;
}

void place(QCPItemLine* line, double fromX, double toX, double y) {
  line->start->setCoords(fromX, y);
  line->end->setCoords(toX, y);
}
}  // namespace

StripChart::StripChart(const Theme& theme, QWidget* parent)
    : QWidget(parent), theme_(theme), plot_(new QCustomPlot(this)) {
  setFocusPolicy(Qt::NoFocus);
  plot_->setFocusPolicy(Qt::NoFocus);
  plot_->setMinimumSize(48, 48);  // it paints without regard to whether it has any size
  plot_->setInteractions(QCP::iNone);
  plot_->axisRect()->setAutoMargins(QCP::msNone);
  plot_->axisRect()->setMargins(QMargins(6, 0, 26, 22));
  plot_->yAxis->setVisible(false);
  plot_->yAxis->grid()->setVisible(false);
  belowLower_ = new QCPItemRect(plot_);
  aboveUpper_ = new QCPItemRect(plot_);
  expected_ = horizontal(plot_);
  lower_ = horizontal(plot_);
  upper_ = horizontal(plot_);
  cursor_ = new QCPItemLine(plot_);
  values_ = plot_->addGraph();
  outside_ = plot_->addGraph();
  limitText_ = new QCPItemText(plot_);
  limitText_->setPositionAlignment(Qt::AlignRight | Qt::AlignTop);
  limitText_->position->setTypeX(QCPItemPosition::ptAxisRectRatio);
  note_ = new QCPItemText(plot_);
  note_->setPositionAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  connect(&theme_, &Theme::changed, this, &StripChart::restyle);
  restyle();
}

StripChart::~StripChart() = default;

void StripChart::show(const StripSeries& series) {
  series_ = series;
  setAccessibleName(tr("%1 along the rail: %2").arg(QString(series.name).replace('_', ' '), series.value));
  refresh();
  update(0, 0, kLabelWidth, height());
}

void StripChart::restyle() {
  const Palette& p = theme_.palette();
  plot_->setBackground(p.panel);
  plot_->axisRect()->setBackground(p.panel2);
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) {
    axis->setBasePen(Qt::NoPen);
    axis->setTickPen(Qt::NoPen);
    axis->setSubTickPen(Qt::NoPen);
    axis->setTickLabelFont(uiFont(14));
    axis->setTickLabelColor(p.t3);
    axis->grid()->setPen(QPen(p.line2, 1));
    axis->grid()->setZeroLinePen(Qt::NoPen);
  }
  for (QCPItemRect* beyond : {belowLower_, aboveUpper_}) {
    beyond->setPen(Qt::NoPen);
    QColor hatch = p.t3;
    hatch.setAlphaF(0.6F);
    beyond->setBrush(QBrush(hatch, Qt::BDiagPattern));
  }
  QPen dashed(p.t3, 1.25);
  dashed.setDashPattern({8, 4});
  expected_->setPen(dashed);
  lower_->setPen(QPen(p.t3, 1.5));
  upper_->setPen(QPen(p.t3, 1.5));
  limitText_->setFont(uiFont(14));
  limitText_->setColor(p.t3);
  note_->setFont(uiFont(14, 500));
  note_->setColor(p.t1);
  refresh();
  update();
}

void StripChart::refresh() {
  const Palette& p = theme_.palette();
  values_->setPen(QPen(series_.held ? p.t3 : p.t1, 1.5));
  outside_->setPen(QPen(p.out, 4));
  cursor_->setPen(QPen(series_.held ? p.t3 : p.accent, 2));

  const auto n = series_.points.size();
  QVector<double> x(n), y(n), red(n);
  for (qsizetype i = 0; i < n; ++i) {
    x[i] = series_.points[i].x();
    y[i] = series_.points[i].y();
    const bool out = std::any_of(series_.outside.begin(), series_.outside.end(),
                                 [&](const auto& s) { return x[i] >= s.first && x[i] <= s.second; });
    red[i] = out ? y[i] : std::nan("");
  }
  values_->setData(x, y, true);
  outside_->setData(x, red, true);
  refreshAxes();
  refreshLimits();
  note_->setText(series_.note);
  note_->setVisible(!series_.note.isEmpty());
  note_->position->setCoords(series_.positionM + plot_->xAxis->range().size() * 0.012,
                             plot_->yAxis->range().center() + plot_->yAxis->range().size() * 0.14);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void StripChart::refreshAxes() {
  const double length = std::max({series_.lengthM, series_.positionM, 1.0});
  plot_->xAxis->setRange(0, length);
  auto ticker = QSharedPointer<QCPAxisTickerText>::create();
  const double step = length <= 15 ? 2 : length <= 30 ? 5 : length <= 75 ? 10 : 20;
  const bool empty = series_.lengthM <= 0 && series_.positionM <= 0;
  for (double at = 0; !empty && at <= length - step * 0.45; at += step) ticker->addTick(at, QString::number(at));
  if (!empty) ticker->addTick(length, QStringLiteral("%1 m").arg(QString::number(length, 'g', 4)));
  plot_->xAxis->setTicker(ticker);

  double low = series_.nominal, high = series_.nominal;
  for (const auto& limit : {series_.lower, series_.upper})
    if (limit) {
      low = std::min(low, *limit);
      high = std::max(high, *limit);
    }
  for (const QPointF& point : series_.points) {
    low = std::min(low, point.y());
    high = std::max(high, point.y());
  }
  const double margin = std::max((high - low) * 0.16, series_.least);
  plot_->yAxis->setRange(low - margin, high + margin);
}

void StripChart::refreshLimits() {
  const QCPRange x = plot_->xAxis->range(), y = plot_->yAxis->range();
  place(expected_, x.lower, x.upper, series_.nominal);
  for (auto [line, beyond, limit, edge] : {std::tuple{lower_, belowLower_, series_.lower, y.lower},
                                           std::tuple{upper_, aboveUpper_, series_.upper, y.upper}}) {
    line->setVisible(limit.has_value());
    beyond->setVisible(limit.has_value());
    if (!limit) continue;
    place(line, x.lower, x.upper, *limit);
    beyond->topLeft->setCoords(x.lower, std::max(*limit, edge));
    beyond->bottomRight->setCoords(x.upper, std::min(*limit, edge));
  }
  limitText_->setVisible(series_.upper.has_value());
  if (series_.upper) {
    limitText_->setText(shortSigned(*series_.upper - series_.nominal, series_.decimals));
    limitText_->position->setTypeY(QCPItemPosition::ptPlotCoords);
    limitText_->position->setCoords(0.99, *series_.upper);
  }
  cursor_->setVisible(series_.positionM > 0);
  cursor_->start->setCoords(series_.positionM, y.lower);
  cursor_->end->setCoords(series_.positionM, y.upper);
}

void StripChart::resizeEvent(QResizeEvent* /*event*/) {
  plot_->setGeometry(kLabelWidth - 6, 6, width() - kLabelWidth + 6 - 1, height() - 8);
}

void StripChart::paintEvent(QPaintEvent* /*event*/) {
  const Palette& p = theme_.palette();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(p.line, 1));
  painter.setBrush(p.panel);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
  if (series_.name.isEmpty()) return;
  const double middle = height() / 2.0;
  if (series_.symbol)
    paintSymbol(painter, QRectF(12, middle - 27, 20, 20), series_.held ? StateSymbol::Held : *series_.symbol, p);
  painter.setPen(p.t1);
  paintInscription(painter, 40, middle - 9, uiFont(22, 500), series_.name);
  painter.setPen(series_.held ? p.t3 : p.t1);
  painter.setFont(uiFont(20, 500));
  painter.drawText(QPointF(16, middle + 18), series_.value);
}

}  // namespace vignole
