#include "report/state_symbol.h"

#include <QPen>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

namespace vignole {

namespace {

/// Draws about the middle of the box; every length is a share of the box's side, so the shape is the same at any size.
class SymbolPainter {
 public:
  SymbolPainter(QPainter& painter, const QRectF& box, const Palette& palette)
      : painter_(painter), middle_(box.center()), side_(std::min(box.width(), box.height())), palette_(palette) {}

  void paint(StateSymbol symbol) {
    switch (symbol) {
      case StateSymbol::Good:
        return disc(0.35, palette_.t3);
      case StateSymbol::NoLimit:
        return ring();
      case StateSymbol::Near:
        return warning();
      case StateSymbol::Out:
        return crossedSquare();
      case StateSymbol::NotMeasured:
        return struckDiamond();
      case StateSymbol::Held:
        return clock();
      case StateSymbol::Idle:
        return hollow(square(0.36));
      case StateSymbol::Armed:
        return hollow(triangleRight());
      case StateSymbol::Measuring:
        return filled(triangleRight(), palette_.t1);
      case StateSymbol::Fault:
        return barredOctagon();
    }
  }

 private:
  [[nodiscard]] QPointF at(double x, double y) const { return middle_ + QPointF(x, y) * side_; }
  [[nodiscard]] QPen pen(const QColor& colour, double width, Qt::PenJoinStyle join = Qt::RoundJoin) const {
    return {QBrush(colour), width * side_, Qt::SolidLine, Qt::FlatCap, join};
  }
  [[nodiscard]] QPolygonF square(double half) const {
    return {{at(-half, -half), at(half, -half), at(half, half), at(-half, half)}};
  }
  [[nodiscard]] QPolygonF triangleRight() const { return {{at(-0.36, -0.42), at(0.42, 0), at(-0.36, 0.42)}}; }

  void filled(const QPolygonF& shape, const QColor& colour) {
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(colour);
    painter_.drawPolygon(shape);
  }
  void hollow(const QPolygonF& shape) {
    painter_.setPen(pen(palette_.t1, 0.1, Qt::MiterJoin));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawPolygon(shape);
  }
  void line(double x1, double y1, double x2, double y2, const QColor& colour, double width) {
    painter_.setPen(pen(colour, width));
    painter_.drawLine(at(x1, y1), at(x2, y2));
  }
  void disc(double radius, const QColor& colour) {
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(colour);
    painter_.drawEllipse(middle_, radius * side_, radius * side_);
  }
  void ring() {
    painter_.setPen(pen(palette_.t3, 0.1));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawEllipse(middle_, 0.3 * side_, 0.3 * side_);
  }
  void warning() {
    painter_.setPen(pen(palette_.nearInk, 0.05));
    painter_.setBrush(palette_.near);
    painter_.drawPolygon(QPolygonF{{at(0, -0.46), at(0.5, 0.43), at(-0.5, 0.43)}});
    line(0, -0.16, 0, 0.14, palette_.onNear, 0.105);
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(palette_.onNear);
    painter_.drawEllipse(at(0, 0.28), 0.065 * side_, 0.065 * side_);
  }
  void crossedSquare() {
    filled(square(0.43), palette_.out);
    line(-0.206, -0.206, 0.206, 0.206, palette_.onOut, 0.11);
    line(-0.206, 0.206, 0.206, -0.206, palette_.onOut, 0.11);
  }
  void struckDiamond() {
    painter_.setPen(pen(palette_.invalid, 0.105, Qt::MiterJoin));
    painter_.setBrush(palette_.panel2);
    painter_.drawPolygon(QPolygonF{{at(0, -0.425), at(0.425, 0), at(0, 0.425), at(-0.425, 0)}});
    line(-0.17, 0.17, 0.17, -0.17, palette_.invalid, 0.095);
  }
  void clock() {
    painter_.setPen(pen(palette_.t3, 0.08));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawEllipse(middle_, 0.4 * side_, 0.4 * side_);
    painter_.drawPolyline(QPolygonF{{at(0, -0.225), at(0, 0), at(0.18, 0.065)}});
  }
  void barredOctagon() {
    QPolygonF octagon;
    for (int corner = 0; corner < 8; ++corner) {
      const double angle = (corner + 0.5) * M_PI / 4;
      octagon << at(0.47 * std::cos(angle), 0.47 * std::sin(angle));
    }
    filled(octagon, palette_.invalid);
    // The ground colour of its theme is the one that stands out against the theme's violet.
    line(-0.22, 0, 0.22, 0, palette_.panel2, 0.13);
  }

  QPainter& painter_;
  QPointF middle_;
  double side_;
  const Palette& palette_;
};

}  // namespace

StateSymbol symbolOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::Pass:
      return StateSymbol::Good;
    case Verdict::Near:
      return StateSymbol::Near;
    case Verdict::Fail:
      return StateSymbol::Out;
    case Verdict::NoLimit:
      return StateSymbol::NoLimit;
    case Verdict::NotMeasured:
      break;
  }
  return StateSymbol::NotMeasured;
}

void paintSymbol(QPainter& painter, const QRectF& box, StateSymbol symbol, const Palette& palette) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  SymbolPainter(painter, box, palette).paint(symbol);
  painter.restore();
}

}  // namespace vignole
