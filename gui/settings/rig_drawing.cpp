#include "gui/settings/rig_drawing.h"

#include <QEvent>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/geometry/primitive.h"
#include "engine/optics/nominal_rig.h"
#include "engine/optics/plane_map.h"

namespace vignole {

namespace {

constexpr double kLabelPx = 46;  // around the outermost camera
constexpr double kFarMm = 600;   // beyond this the light plane is not looked at
constexpr double kStepMm = 1;    // of a drawn arc

/// Where the camera's axis meets its light plane.
Point3 aimOf(const RangeFinderCalibration& finder, const Point3& centre) {
  const Point3 axis = finder.cameraFromWorld.rotation.row(2).transpose();
  const double towards = finder.lightPlane.normal.dot(axis);
  if (std::abs(towards) < 1e-6) return centre;
  return centre + (finder.lightPlane.distanceMm - finder.lightPlane.normal.dot(centre)) / towards * axis;
}

QPolygonF fieldOf(const RangeFinderCalibration& finder) {
  const PlaneMap planeFromImage(finder);
  const double w = finder.intrinsics.widthPx - 1, h = finder.intrinsics.heightPx - 1;
  QPolygonF field;
  constexpr int kSteps = 8;  // a side: lenses bend it
  const auto add = [&](double column, double row) {
    const PlanePoint p = planeFromImage(column, row);
    if (std::hypot(p.x, p.y) < kFarMm) field << QPointF(p.x, p.y);
  };
  for (int i = 0; i < kSteps; ++i) add(w * i / kSteps, 0);
  for (int i = 0; i < kSteps; ++i) add(w, h * i / kSteps);
  for (int i = 0; i < kSteps; ++i) add(w - w * i / kSteps, h);
  for (int i = 0; i < kSteps; ++i) add(0, h - h * i / kSteps);
  return field;
}

}  // namespace

RigDrawing::RigDrawing(const Theme& theme, const Units& units, QWidget* parent)
    : QWidget(parent), theme_(theme), units_(units) {
  connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
  connect(&units_, &Units::changed, this, qOverload<>(&QWidget::update));
  setAccessibleName(tr("The rig as it is calibrated"));
}

void RigDrawing::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::LanguageChange) return;
  setAccessibleName(tr("The rig as it is calibrated"));
  update();
}

void RigDrawing::show(const RigCalibration& calibration, const Section& section, const Transform2& worldFromSection) {
  for (std::size_t c = 0; c < stations_.size(); ++c) {
    const RangeFinderCalibration& finder = calibration.rangeFinders[c];
    Station& s = stations_[c];
    s.serial = QString::fromStdString(finder.serial);
    s.centre = cameraCentre(finder.cameraFromWorld);
    s.aim = aimOf(finder, s.centre);
    const Point3 ray = s.centre - s.aim;
    s.distanceMm = ray.norm();
    s.elevationDeg = s.distanceMm > 0
                         ? std::asin(std::clamp(finder.lightPlane.normal.dot(ray) / s.distanceMm, -1.0, 1.0)) * 180 /
                               std::numbers::pi
                         : 0;
    s.field = fieldOf(finder);
  }
  rail_.clear();
  for (const NamedPrimitive& p : section.primitives)
    for (const Point2& onSection : polyline(p.shape, kStepMm)) {
      const Point2 at = worldFromSection * onSection;
      rail_ << QPointF(at.x(), at.y());
    }
  known_ = true;
  update();
}

QPointF RigDrawing::View::map(const Point3& p) const {
  return area.center() + QPointF((p[right] - centreMm.x()) * pxPerMm, (centreMm.y() - p.y()) * pxPerMm);
}

RigDrawing::View RigDrawing::fitted(const QRectF& area, int right) const {
  Point3 low = Point3::Constant(1e9), high = Point3::Constant(-1e9);
  const auto take = [&](const Point3& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  };
  for (const Station& s : stations_) {
    take(s.centre);
    take(s.aim);
  }
  for (const QPointF& p : rail_) take({p.x(), p.y(), 0});
  View view;
  view.area = area;
  view.right = right;
  view.centreMm = QPointF((low[right] + high[right]) / 2, (low.y() + high.y()) / 2);
  view.pxPerMm = std::max(0.01, std::min((area.width() - 4 * kLabelPx) / std::max(1.0, high[right] - low[right]),
                                         (area.height() - 2.4 * kLabelPx) / std::max(1.0, high.y() - low.y())));
  return view;
}

void RigDrawing::paintView(QPainter& painter, const View& view, const QString& title) {
  const Palette& p = theme_.palette();
  const bool across = view.right == 0;
  painter.setPen(p.t2);
  painter.setFont(uiFont(15));
  painter.drawText(view.area.adjusted(0, 2, 0, 0), Qt::AlignTop | Qt::AlignHCenter, title);
  const auto flat = [&](const QPolygonF& mm) {
    QPolygonF px;
    for (const QPointF& q : mm) px << view.map({q.x(), q.y(), 0});
    return px;
  };
  if (across) {
    for (std::size_t c = 0; c < stations_.size(); ++c) {
      QColor tint = p.camera[c];
      painter.setPen(QPen(tint, 1, Qt::DashLine));
      tint.setAlpha(18);
      painter.setBrush(tint);
      painter.drawPolygon(flat(stations_[c].field));
    }
    painter.setPen(QPen(p.model, 1.5));
    painter.setBrush(p.steel);
    painter.drawPolygon(flat(rail_));
  } else {
    // From the side the rail is a bar and the light plane a line across it.
    double low = 1e9, high = -1e9;
    for (const QPointF& q : rail_) low = std::min(low, q.y()), high = std::max(high, q.y());
    const double top = view.map({0, high, 0}).y(), bottom = view.map({0, low, 0}).y();
    painter.setPen(QPen(p.model, 1.5));
    painter.setBrush(p.steel);
    painter.drawRect(QRectF(QPointF(view.area.left() + 12, top), QPointF(view.area.right() - 12, bottom)));
    const double x = view.map(Point3::Zero()).x();
    painter.setPen(QPen(p.out, 2));
    painter.drawLine(QPointF(x, top - 24), QPointF(x, bottom + 24));
  }
  for (std::size_t c = 0; c < stations_.size(); ++c) {
    const Station& s = stations_[c];
    const QPointF from = view.map(s.centre), to = view.map(s.aim);
    painter.setPen(QPen(p.camera[c], 1.5));
    painter.drawLine(from, to);
    // The body lies along the axis.
    const QPointF way = from - to;
    painter.save();
    painter.translate(from);
    painter.rotate(std::atan2(way.y(), way.x()) * 180 / std::numbers::pi);
    painter.setPen(QPen(p.t1, 1.5));
    painter.setBrush(p.panel2);
    painter.drawRect(QRectF(0, -8, 24, 16));
    painter.drawRect(QRectF(-7, -5, 7, 10));
    painter.restore();
    painter.setPen(p.t1);
    painter.setFont(uiFont(15, 500));
    const bool left = from.x() < view.area.center().x(), up = way.y() < 0;
    const int align = (left ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter;
    if (!across) {
      // Two cameras stand behind each other: each has a line of its own.
      const double row = s.centre.x() > 0 ? 17 : 0;
      const QRectF box(left ? from.x() - 12 : from.x() - 108, from.y() + (up ? -60 : 24) + row, 120, 17);
      painter.drawText(box, align,
                       QStringLiteral("%1   %2°").arg(c + 1).arg(locale().toString(std::abs(s.elevationDeg), 'f', 1)));
      continue;
    }
    const QRectF box(left ? from.x() - 50 : from.x() - 100, from.y() + (up ? -60 : 24), 150, 18);
    painter.drawText(box, align, tr("Camera %1").arg(c + 1));
    painter.setPen(p.t2);
    painter.setFont(uiFont(14));
    const bool inch = units_.length() == Units::Length::Inch;
    painter.drawText(
        box.translated(0, 17), align,
        QStringLiteral("%1 %2").arg(locale().toString(inch ? s.distanceMm / 25.4 : s.distanceMm, 'f', inch ? 1 : 0),
                                    inch ? QStringLiteral("in") : QStringLiteral("mm")));
  }
}

void RigDrawing::paintEvent(QPaintEvent* /*event*/) {
  if (!known_) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF whole(rect());
  const double middle = whole.width() * 0.55;
  paintView(painter, fitted({whole.left(), whole.top(), middle, whole.height()}, 0),
            tr("Along the rail: fields of view on the light plane, distances"));
  paintView(painter, fitted({middle, whole.top(), whole.width() - middle, whole.height()}, 2),
            tr("From the side: angles out of the light plane"));
}

}  // namespace vignole
