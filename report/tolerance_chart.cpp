#include "report/tolerance_chart.h"

#include <QFontInfo>
#include <QFontMetricsF>
#include <QPen>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

#include "report/dimension_text.h"
#include "report/drawing_words.h"
#include "report/engine_words.h"
#include "report/hatch.h"
#include "report/state_symbol.h"
#include "report/typeface.h"

namespace vignole {

namespace {

constexpr double kTitlePx = 18, kSmallPx = 14, kSymbolPx = 18;
constexpr double kTitleRowPx = 28, kAxisRowPx = 20, kLimitsColumnPx = 62;
constexpr double kRoomBeyondLimits = 0.2;  // of the tolerance, above and below
constexpr double kFarthestBeyond = 1.5;    // of the tolerance: a wild value must not flatten the rest

QString metresText(double m) { return QString::number(m, 'g', 6).replace('.', decimalMark()); }

class ChartPainter {
 public:
  ChartPainter(QPainter& painter, const QRectF& area, const DimensionSummary& summary, double lengthM,
               const Palette& palette)
      : painter_(painter),
        s_(summary),
        lengthM_(lengthM > 0 ? lengthM : lastPosition(summary)),
        palette_(palette),
        scale_(std::clamp(QFontInfo(painter.font()).pixelSize() / 16.0, 0.4, 4.0)),
        decimals_(decimalsOf(summary.dimension)),
        title_(area.left(), area.top(), area.width(), kTitleRowPx * scale_),
        plot_(area.left(), title_.bottom(), area.width() - kLimitsColumnPx * scale_,
              area.height() - (kTitleRowPx + kAxisRowPx) * scale_) {
    chooseRange();
  }

  void paint() {
    painter_.setRenderHint(QPainter::Antialiasing);
    paintTitle();
    painter_.fillRect(plot_, palette_.panel2);
    paintGrid();
    paintLimits();
    painter_.save();
    painter_.setClipRect(plot_, Qt::IntersectClip);
    paintNotMeasured();
    paintTrack();
    paintExceptions();
    painter_.restore();
  }

 private:
  static double lastPosition(const DimensionSummary& s) { return s.track.empty() ? 1.0 : s.track.back().positionM; }
  [[nodiscard]] double x(double m) const { return plot_.left() + m / lengthM_ * plot_.width(); }
  [[nodiscard]] double y(double mm) const { return plot_.bottom() - (mm - low_) / (high_ - low_) * plot_.height(); }

  void chooseRange() {
    low_ = s_.nominalMm;
    high_ = s_.nominalMm;
    if (s_.lowerMm) low_ = std::min(low_, *s_.lowerMm);
    if (s_.upperMm) high_ = std::max(high_, *s_.upperMm);
    const double tolerance = high_ - low_;
    const double floor = tolerance > 0 ? low_ - kFarthestBeyond * tolerance : -1e9;
    const double ceiling = tolerance > 0 ? high_ + kFarthestBeyond * tolerance : 1e9;
    for (const TrackBin& bin : s_.track) {
      if (bin.count == 0) continue;
      low_ = std::min(low_, std::max(bin.minMm, floor));
      high_ = std::max(high_, std::min(bin.maxMm, ceiling));
    }
    const double room = std::max(kRoomBeyondLimits * (high_ - low_), 1e-3);
    low_ -= room;
    high_ += room;
  }

  void paintTitle() {
    const double side = kSymbolPx * scale_, middle = title_.center().y();
    paintSymbol(painter_, QRectF(title_.left(), middle - side / 2, side, side), symbolOf(s_.verdict), palette_);
    painter_.setFont(typeface(kTitlePx * scale_, QFont::Medium));
    painter_.setPen(palette_.t1);
    const QPointF at(title_.left() + side + 8 * scale_, middle + 0.36 * kTitlePx * scale_);
    double advance = drawDimensionName(painter_, at, s_.dimension) + 10 * scale_;
    painter_.setFont(typeface(kSmallPx * scale_));
    painter_.setPen(palette_.t2);
    QString figures = wordOf(s_.verdict);
    if (s_.values.count() > 0)
      figures += QStringLiteral("   mean %1   s %2")
                     .arg(numberText(s_.meanMm(), decimals_), numberText(s_.values.sd(), decimals_));
    if (!s_.radius.empty()) figures += QStringLiteral("   u of mean %1").arg(numberText(s_.uOfMeanMm(), decimals_));
    painter_.drawText(at + QPointF(advance, 0), figures);
  }

  void paintGrid() {
    const double step = axisStep(lengthM_, std::clamp(static_cast<int>(plot_.width() / (56 * scale_)), 2, 10));
    const QFont small = typeface(kSmallPx * scale_);
    const QFontMetricsF metrics(small);
    painter_.setFont(small);
    const int last = static_cast<int>(std::floor(lengthM_ / step * (1 + 1e-9)));
    for (int tick = 0; tick <= last; ++tick) {
      const double m = tick * step;
      painter_.setPen(QPen(palette_.line2, 1));
      painter_.drawLine(QPointF(x(m), plot_.top()), QPointF(x(m), plot_.bottom()));
      const QString text = tick == last ? metresText(m) + QStringLiteral(" m") : metresText(m);
      const double wide = metrics.horizontalAdvance(text);
      const double from = std::clamp(x(m) - wide / 2, plot_.left(), plot_.right() + kLimitsColumnPx * scale_ - wide);
      painter_.setPen(palette_.t3);
      painter_.drawText(QPointF(from, plot_.bottom() + 15 * scale_), text);
    }
  }

  void rule(double mm, const QPen& pen, const QString& text) {
    painter_.setPen(pen);
    painter_.drawLine(QPointF(plot_.left(), y(mm)), QPointF(plot_.right(), y(mm)));
    painter_.setPen(palette_.t3);
    painter_.setFont(typeface(kSmallPx * scale_));
    painter_.drawText(QPointF(plot_.right() + 6 * scale_, y(mm) + 0.36 * kSmallPx * scale_), text);
  }

  void paintLimits() {
    if (s_.upperMm)
      painter_.fillRect(QRectF(plot_.left(), plot_.top(), plot_.width(), y(*s_.upperMm) - plot_.top()), palette_.chan);
    if (s_.lowerMm)
      painter_.fillRect(QRectF(plot_.left(), y(*s_.lowerMm), plot_.width(), plot_.bottom() - y(*s_.lowerMm)),
                        palette_.chan);
    QPen expected(QBrush(palette_.t3), 1.25, Qt::CustomDashLine, Qt::FlatCap);
    expected.setDashPattern({8, 4});
    const QPen limit(palette_.t2, 1.75);
    rule(s_.nominalMm, expected, numberText(s_.nominalMm, decimals_));
    // Limits nearer to the nominal than a line of text would print over it.
    const auto deviation = [&](double mm) {
      return std::abs(y(mm) - y(s_.nominalMm)) < kSmallPx * scale_ ? QString() : limitText(mm - s_.nominalMm);
    };
    if (s_.upperMm) rule(*s_.upperMm, limit, deviation(*s_.upperMm));
    if (s_.lowerMm) rule(*s_.lowerMm, limit, deviation(*s_.lowerMm));
  }

  [[nodiscard]] double binWidth() const {
    if (s_.track.size() < 2) return lengthM_;
    return s_.track[1].positionM - s_.track[0].positionM;
  }

  void hatch(double fromM, double toM) {
    paintHatch(painter_, QRectF(QPointF(x(fromM), plot_.top()), QPointF(x(toM), plot_.bottom())), palette_.invalid,
               8 * scale_, 1.5 * scale_);
  }
  void paintNotMeasured() {
    const double half = 0.5 * binWidth();
    double measuredTo = 0;
    for (const TrackBin& bin : s_.track) {
      if (bin.count == 0) continue;
      if (bin.positionM - half > measuredTo + 0.1 * half) hatch(measuredTo, bin.positionM - half);
      measuredTo = bin.positionM + half;
    }
    // The track ends with the last value: what follows was not measured either. The rail's end may cut a bin.
    if (measuredTo + 2 * half < lengthM_) hatch(measuredTo, lengthM_);
    if (s_.values.count() > 0) return;
    painter_.setPen(palette_.invalid);
    painter_.setFont(typeface(kSmallPx * scale_, QFont::Medium));
    const QString reason = s_.reason.empty() ? Drawing::tr("Not measured")
                                             : Drawing::tr("Not measured, because %1").arg(inWords(s_.reason));
    const QRectF box = painter_.fontMetrics().boundingRect(plot_.toRect(), Qt::AlignCenter | Qt::TextWordWrap, reason);
    painter_.fillRect(box.adjusted(-6, -3, 6, 3), palette_.panel2);
    painter_.drawText(plot_, Qt::AlignCenter | Qt::TextWordWrap, reason);
  }

  /// Calls `run` with every polyline of measured bins between two positions.
  template <typename Use>
  void eachRun(double fromM, double toM, Use use) const {
    QPolygonF mean, upper, lower;
    const auto flush = [&] {
      if (!mean.isEmpty()) use(mean, upper, lower);
      mean.clear(), upper.clear(), lower.clear();
    };
    for (const TrackBin& bin : s_.track) {
      if (bin.count == 0 || bin.positionM < fromM || bin.positionM > toM) {
        flush();
        continue;
      }
      mean << QPointF(x(bin.positionM), y(bin.meanMm));
      upper << QPointF(x(bin.positionM), y(bin.maxMm));
      lower << QPointF(x(bin.positionM), y(bin.minMm));
    }
    flush();
  }

  void paintTrack() {
    eachRun(-1e9, 1e9, [&](const QPolygonF& mean, const QPolygonF& upper, const QPolygonF& lower) {
      QPolygonF envelope = upper;
      for (qsizetype i = lower.size() - 1; i >= 0; --i) envelope << lower[i];
      QColor soft = palette_.t3;
      soft.setAlphaF(0.35F);
      painter_.setPen(Qt::NoPen);
      painter_.setBrush(soft);
      painter_.drawPolygon(envelope);
      painter_.setBrush(Qt::NoBrush);
      painter_.setPen(QPen(QBrush(palette_.t1), 1.6, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
      painter_.drawPolyline(mean);
    });
  }

  void paintExceptions() {
    const double side = 14 * scale_;
    for (const DimensionException& e : s_.exceptions) {
      const double half = 0.5 * binWidth();
      eachRun(e.fromM - half, e.toM + half, [&](const QPolygonF& mean, const QPolygonF&, const QPolygonF&) {
        painter_.setPen(QPen(QBrush(palette_.out), 4, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
        painter_.drawPolyline(mean);
      });
      const bool high = !s_.upperMm || e.worstMm > s_.nominalMm;
      const double at =
          std::clamp(y(e.worstMm) + (high ? side : -side), plot_.top() + side / 2, plot_.bottom() - side / 2);
      const double middle = x(0.5 * (e.fromM + e.toM));
      paintSymbol(painter_, QRectF(middle - side / 2, at - side / 2, side, side), StateSymbol::Out, palette_);
    }
  }

  QPainter& painter_;
  const DimensionSummary& s_;
  double lengthM_;
  const Palette& palette_;
  double scale_;
  int decimals_;
  QRectF title_, plot_;
  double low_ = 0, high_ = 1;
};

}  // namespace

double axisStep(double length, int most) {
  const double raw = std::max(length, 1e-9) / std::max(1, most);
  const double decade = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * decade >= raw * (1 - 1e-9)) return factor * decade;
  return 10 * decade;
}

void paintToleranceChart(QPainter& painter, const QRectF& area, const DimensionSummary& summary, double lengthM,
                         const Palette& palette) {
  painter.save();
  ChartPainter(painter, area, summary, lengthM, palette).paint();
  painter.restore();
}

}  // namespace vignole
