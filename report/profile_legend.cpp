#include "report/profile_legend.h"

#include <QFontMetricsF>
#include <QPen>
#include <array>

#include "report/dimension_text.h"
#include "report/drawing_words.h"
#include "report/typeface.h"

namespace vignole {

namespace {

constexpr double kTextPx = 14, kSamplePx = 28, kGapPx = 8, kItemGapPx = 22;

/// The longest of the round lengths whose bar stays below `longestPx`.
template <std::size_t N>
double roundLength(const std::array<double, N>& lengths, double pxPerMm, double longestPx) {
  double best = lengths.front();
  for (const double length : lengths)
    if (length * pxPerMm <= longestPx) best = length;
  return best;
}

QString shortNumber(double value) { return QString::number(value).replace('.', decimalMark()); }

class LegendPainter {
 public:
  LegendPainter(QPainter& painter, const QRectF& area, const ProfileLegend& legend)
      : painter_(painter),
        area_(area),
        l_(legend),
        font_(typeface(kTextPx * legend.scale)),
        metrics_(font_),
        y_(area.center().y() + 1) {}

  void paint() {
    painter_.setPen(QPen(l_.palette.line2, 1));
    painter_.drawLine(area_.topLeft(), area_.topRight());
    painter_.setFont(font_);
    paintBars();
    x_ = area_.left();
    paintItem(modelText(), [this](const QRectF& s) { line(s, QPen(l_.palette.model, 1.5)); });
    if (l_.drawing.beforeRegistration) {
      paintItem(Drawing::tr("As seen"), [this](const QRectF& s) { line(s, QPen(l_.palette.camera[1], 2)); });
      paintItem(Drawing::tr("Registered"), [this](const QRectF& s) { line(s, QPen(l_.palette.t1, 2)); });
      return;
    }
    if (l_.drawing.byCamera)
      for (int camera = 0; camera < 4; ++camera) paintCamera(camera);
    else
      paintItem(Drawing::tr("Measured"),
                [this](const QRectF& s) { line(s, QPen(l_.drawing.held ? l_.palette.t3 : l_.palette.t1, 2)); });
    if (l_.drawing.limits != nullptr) paintItem(Drawing::tr("Tolerance"), [this](const QRectF& s) { band(s); });
  }

 private:
  [[nodiscard]] QString modelText() const {
    const Section& section = *l_.drawing.section;
    const QString name = QString::fromStdString(section.name);
    if (section.standing == SectionStanding::Approximate) return Drawing::tr("Model %1 (approximate)").arg(name);
    if (section.standing == SectionStanding::Invented) return Drawing::tr("Model %1 (invented)").arg(name);
    return Drawing::tr("Model %1").arg(name);
  }
  void text(double x, const QString& what) {
    painter_.setPen(l_.palette.t2);
    painter_.drawText(QPointF(x, y_ + 0.36 * kTextPx * l_.scale), what);
  }
  void line(const QRectF& sample, const QPen& pen) {
    painter_.setPen(pen);
    painter_.drawLine(QPointF(sample.left(), y_), QPointF(sample.right(), y_));
  }
  void band(const QRectF& sample) {
    painter_.fillRect(sample, l_.palette.chan);
    QPen dashed(QBrush(l_.palette.t3), 1, Qt::CustomDashLine, Qt::FlatCap);
    dashed.setDashPattern({5, 3});
    painter_.setPen(dashed);
    painter_.drawLine(sample.topLeft(), sample.topRight());
    painter_.drawLine(sample.bottomLeft(), sample.bottomRight());
  }

  template <typename Sample>
  void paintItem(const QString& what, Sample sample, double samplePx = kSamplePx) {
    const double wide = (samplePx + kGapPx) * l_.scale + metrics_.horizontalAdvance(what);
    if (x_ + wide > itemsEnd_) return;
    sample(QRectF(x_, y_ - 8 * l_.scale, samplePx * l_.scale, 16 * l_.scale));
    text(x_ + (samplePx + kGapPx) * l_.scale, what);
    x_ += wide + kItemGapPx * l_.scale;
  }
  void paintCamera(int camera) {
    const QColor& colour = l_.drawing.held ? l_.palette.t3 : l_.palette.camera[static_cast<std::size_t>(camera)];
    paintItem(
        camera == 0 ? Drawing::tr("Camera 1") : QString::number(camera + 1),
        [&](const QRectF& s) {
          painter_.setPen(Qt::NoPen);
          painter_.setBrush(colour);
          painter_.drawEllipse(s.center(), 5 * l_.scale, 5 * l_.scale);
        },
        12);
  }

  void bar(double right, double lengthPx, const QString& what, const QColor& ink, double width) {
    const double wide = metrics_.horizontalAdvance(what);
    const double from = right - wide - kGapPx * l_.scale - lengthPx, to = from + lengthPx, tick = 6 * l_.scale;
    painter_.setPen(QPen(ink, width));
    painter_.drawLine(QPointF(from, y_), QPointF(to, y_));
    painter_.setPen(QPen(ink, 1.5));
    painter_.drawLine(QPointF(from, y_ - tick), QPointF(from, y_ + tick));
    painter_.drawLine(QPointF(to, y_ - tick), QPointF(to, y_ + tick));
    text(to + kGapPx * l_.scale, what);
    itemsEnd_ = from - kItemGapPx * l_.scale;
  }
  void paintBars() {
    const double m = l_.drawing.magnification;
    const LengthUnit unit = l_.drawing.unit;
    const double pxPerUnit = l_.pxPerMm / inUnit(1, unit);
    const double plain =
        roundLength(std::array{0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0}, pxPerUnit, 76 * l_.scale);
    const double deviation =
        roundLength(std::array{0.0005, 0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0},
                    pxPerUnit * m, 50 * l_.scale);
    const QString name = QString::fromLatin1(unitName(unit));
    bar(area_.right(), plain * pxPerUnit, shortNumber(plain) + ' ' + name, l_.palette.t2, 1.5);
    bar(itemsEnd_, deviation * pxPerUnit * m,
        Drawing::tr("deviation %1 %2, \u00d7%3").arg(shortNumber(deviation), name).arg(m), l_.palette.t1, 3);
  }

  QPainter& painter_;
  QRectF area_;
  const ProfileLegend& l_;
  QFont font_;
  QFontMetricsF metrics_;
  double y_;
  double x_ = 0, itemsEnd_ = 0;
};

}  // namespace

void paintProfileLegend(QPainter& painter, const QRectF& area, const ProfileLegend& legend) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  LegendPainter(painter, area, legend).paint();
  painter.restore();
}

}  // namespace vignole
