#include "report/plot_painter.h"

#include <QFontMetricsF>
#include <QPen>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

#include "report/typeface.h"

namespace vignole {

namespace {

constexpr double kTextPx = 14;

QString text(const std::string& s) { return QString::fromStdString(s); }

struct Range {
  double low = 0, high = 1;
  [[nodiscard]] double span() const { return high - low; }
};

/// 1, 2 or 5 times a power of ten, so that about `count` steps fill the span.
double niceStep(double span, double count) {
  const double raw = span / count, power = std::pow(10, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= raw) return factor * power;
  return 10 * power;
}

QString tickText(double value, double step) {
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6);
  return QString::number(std::abs(value) < step * 1e-6 ? 0.0 : value, 'f', decimals)
      .replace(QLatin1Char('-'), QChar(0x2212));
}

class PlotPainter {
 public:
  PlotPainter(QPainter& painter, const QRectF& area, const Plot& plot, const Palette& palette)
      : painter_(painter), area_(area), plot_(plot), palette_(palette) {}

  void paint() {
    double top = area_.top();
    if (!plot_.title.empty()) {
      painter_.setFont(typeface(16, QFont::Medium));
      painter_.setPen(palette_.t1);
      painter_.drawText(QPointF(area_.left(), top + 16), text(plot_.title));
      top += 26;
    }
    if (!findRanges()) {
      painter_.setFont(typeface(kTextPx));
      painter_.setPen(palette_.t2);
      painter_.drawText(area_, Qt::AlignCenter, QStringLiteral("no values"));
      return;
    }
    const double below = 24 + (plot_.xLabel.empty() ? 0 : 20) + (hasKey() ? 24 : 0);
    inner_ = QRectF(QPointF(area_.left() + leftRoom(), top + 4), QPointF(area_.right() - 12, area_.bottom() - below));
    if (plot_.equalScale) equalise();
    axes();
    painter_.save();
    painter_.setClipRect(inner_.adjusted(-1, -1, 1, 1));
    if (plot_.bars && !plot_.curves.empty()) paintBars(plot_.curves.front());
    for (std::size_t i = plot_.bars ? 1 : 0; i < plot_.curves.size(); ++i)
      paintCurve(painter_, plot_.curves[i], curveColour(plot_.curves[i].colour, palette_),
                 [this](const Point2& p) { return map(p); });
    painter_.restore();
    if (hasKey()) key();
  }

 private:
  [[nodiscard]] bool hasKey() const {
    return std::any_of(plot_.curves.begin(), plot_.curves.end(), [](const Curve& c) { return !c.name.empty(); });
  }
  bool findRanges() {
    bool any = false;
    const auto take = [&](double x, double y) {
      if (!std::isfinite(x) || !std::isfinite(y)) return;
      if (!any) {
        x_ = {x, x};
        y_ = {y, y};
      }
      any = true;
      x_ = {std::min(x_.low, x), std::max(x_.high, x)};
      y_ = {std::min(y_.low, y), std::max(y_.high, y)};
    };
    for (const Curve& c : plot_.curves)
      for (const Point2& p : c.points) take(p.x(), p.y());
    if (!any) return false;
    if (plot_.bars) y_ = {std::min(0.0, y_.low), std::max(0.0, y_.high)};
    widen(x_);
    widen(y_);
    if (!plot_.categories.empty()) x_ = {-0.5, static_cast<double>(plot_.categories.size()) - 0.5};
    return true;
  }
  static void widen(Range& r) {
    const double margin = r.span() > 0 ? 0.06 * r.span() : std::max(1e-6, 0.1 * std::abs(r.low));
    r = {r.low - margin, r.high + margin};
  }
  [[nodiscard]] double leftRoom() const {
    const double step = niceStep(y_.span(), 5);
    const QFontMetricsF metrics(typeface(kTextPx));
    double widest = 0;
    for (double v = std::ceil(y_.low / step) * step; v <= y_.high; v += step)
      widest = std::max(widest, metrics.horizontalAdvance(tickText(v, step)));
    return widest + 12 + (plot_.yLabel.empty() ? 0 : 22);
  }
  void equalise() {
    const double pxPerUnit = std::min(inner_.width() / x_.span(), inner_.height() / y_.span());
    const auto fit = [&](Range& r, double px) {
      const double middle = (r.low + r.high) / 2, half = px / pxPerUnit / 2;
      r = {middle - half, middle + half};
    };
    fit(x_, inner_.width());
    fit(y_, inner_.height());
  }
  [[nodiscard]] QPointF map(const Point2& p) const {
    const double share = (p.y() - y_.low) / y_.span();
    return {inner_.left() + (p.x() - x_.low) / x_.span() * inner_.width(),
            plot_.yDown ? inner_.top() + share * inner_.height() : inner_.bottom() - share * inner_.height()};
  }
  void axes() {
    painter_.setFont(typeface(kTextPx));
    const QFontMetricsF metrics(painter_.font());
    const auto grid = [&](const QPointF& a, const QPointF& b) {
      painter_.setPen(QPen(palette_.line2, 1));
      painter_.drawLine(a, b);
      painter_.setPen(palette_.t2);
    };
    const double yStep = niceStep(y_.span(), std::max(2.0, inner_.height() / 60));
    for (double v = std::ceil(y_.low / yStep) * yStep; v <= y_.high; v += yStep) {
      const double y = map({x_.low, v}).y();
      grid({inner_.left(), y}, {inner_.right(), y});
      const QString label = tickText(v, yStep);
      painter_.drawText(QPointF(inner_.left() - 8 - metrics.horizontalAdvance(label), y + 5), label);
    }
    const auto xTick = [&](double v, const QString& label, bool line) {
      const double x = map({v, y_.low}).x();
      if (line) grid({x, inner_.top()}, {x, inner_.bottom()});
      painter_.setPen(palette_.t2);
      painter_.drawText(QPointF(x - metrics.horizontalAdvance(label) / 2, inner_.bottom() + 20), label);
    };
    if (plot_.categories.empty()) {
      const double step = niceStep(x_.span(), std::max(2.0, inner_.width() / 90));
      for (double v = std::ceil(x_.low / step) * step; v <= x_.high; v += step) xTick(v, tickText(v, step), true);
    } else {
      const double room = inner_.width() / static_cast<double>(plot_.categories.size()) - 6;
      for (std::size_t i = 0; i < plot_.categories.size(); ++i)
        xTick(static_cast<double>(i), metrics.elidedText(text(plot_.categories[i]), Qt::ElideRight, room), false);
    }
    painter_.setPen(QPen(palette_.line, 1));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawRect(inner_);
    painter_.setPen(palette_.t2);
    if (!plot_.xLabel.empty())
      painter_.drawText(QRectF(inner_.left(), inner_.bottom() + 22, inner_.width(), 20), Qt::AlignCenter,
                        text(plot_.xLabel));
    if (!plot_.yLabel.empty()) {
      painter_.save();
      painter_.translate(area_.left() + 8, inner_.center().y());
      painter_.rotate(-90);
      painter_.drawText(QRectF(-inner_.height() / 2, -10, inner_.height(), 20), Qt::AlignCenter, text(plot_.yLabel));
      painter_.restore();
    }
  }
  void paintBars(const Curve& curve) {
    const double half = inner_.width() / x_.span() * 0.32;
    for (const Point2& p : curve.points) {
      if (!p.allFinite()) continue;
      const QPointF top = map(p), foot = map({p.x(), 0});
      painter_.fillRect(QRectF(QPointF(top.x() - half, top.y()), QPointF(top.x() + half, foot.y())).normalized(),
                        curveColour(curve.colour, palette_));
    }
  }
  void key() {
    painter_.setFont(typeface(kTextPx));
    const QFontMetricsF metrics(painter_.font());
    double wanted = 0;
    for (const Curve& c : plot_.curves)
      if (!c.name.empty()) wanted += 56 + metrics.horizontalAdvance(text(c.name));
    const bool tight = wanted > area_.right() - inner_.left();
    const double mark = tight ? 8 : 22, gap = tight ? 6 : 26;
    double x = tight ? area_.left() : inner_.left();
    const double y = area_.bottom() - 4;
    for (const Curve& c : plot_.curves) {
      if (c.name.empty()) continue;
      const QColor colour = curveColour(c.colour, palette_);
      if (c.line) {
        painter_.setPen(QPen(colour, 2));
        painter_.drawLine(QPointF(x, y - 5), QPointF(x + mark, y - 5));
      } else {
        painter_.setPen(Qt::NoPen);
        painter_.setBrush(colour);
        painter_.drawEllipse(QPointF(x + mark / 2, y - 5), 3.5, 3.5);
      }
      painter_.setPen(palette_.t2);
      painter_.drawText(QPointF(x + mark + (tight ? 3 : 8), y), text(c.name));
      x += mark + (tight ? 3 : 8) + metrics.horizontalAdvance(text(c.name)) + gap;
    }
  }

  QPainter& painter_;
  QRectF area_, inner_;
  const Plot& plot_;
  const Palette& palette_;
  Range x_, y_;
};

}  // namespace

QColor curveColour(int colour, const Palette& palette) {
  if (colour >= 0 && colour < 4) return palette.camera[static_cast<std::size_t>(colour)];
  if (colour == 5) return palette.accent;
  if (colour == 6) return palette.out;
  return palette.t2;
}

void paintCurve(QPainter& painter, const Curve& curve, const QColor& colour,
                const std::function<QPointF(const Point2&)>& map) {
  if (curve.line) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QBrush(colour), curve.dotPx, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    QPolygonF run;
    for (const Point2& p : curve.points) {
      if (p.allFinite())
        run << map(p);
      else {
        painter.drawPolyline(run);
        run.clear();
      }
    }
    painter.drawPolyline(run);
    return;
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  for (const Point2& p : curve.points)
    if (p.allFinite()) painter.drawEllipse(map(p), curve.dotPx / 2, curve.dotPx / 2);
}

void paintPlot(QPainter& painter, const QRectF& area, const Plot& plot, const Palette& palette) {
  painter.save();
  PlotPainter(painter, area, plot, palette).paint();
  painter.restore();
}

}  // namespace vignole
