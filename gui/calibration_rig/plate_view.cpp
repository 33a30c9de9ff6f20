#include "gui/calibration_rig/plate_view.h"

#include <QPainter>
#include <QPainterPath>
#include <utility>

namespace vignole {

namespace {
constexpr double kHead = 34;
const QColor kLine(0x62, 0xAE, 0xF0), kMark(0xFF, 0xB5, 0x2E), kText(0xEA, 0xEE, 0xF1);  // on pictures, in both themes

QString shown(const std::string& text) { return QString::fromStdString(text); }
}  // namespace

PlateView::PlateView(const Theme& theme, int camera, QWidget* parent)
    : QWidget(parent), theme_(theme), camera_(camera) {
  connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
  judge();
}

void PlateView::show(std::shared_ptr<const PlateSight> sight, std::vector<std::vector<Point2>> ghost) {
  const bool fresh = sight != sight_;
  sight_ = std::move(sight);
  ghost_ = std::move(ghost);
  if (fresh) {
    image_ = {};
    if (sight_) {
      const Picture& p = sight_->pictures[static_cast<std::size_t>(camera_)];
      if (p.width > 0) image_ = QImage(p.pixels.data(), p.width, p.height, p.width, QImage::Format_Grayscale8);
    }
    scaled_ = {};
    judge();
  }
  update();
}

void PlateView::retranslate() { judge(); }

void PlateView::judge() {
  if (!sight_) {
    word_ = tr("no picture yet");
    symbol_ = StateSymbol::NotMeasured;
  } else {
    const auto c = static_cast<std::size_t>(camera_);
    const PinPicture& lines = sight_->lines.pictures[c];
    const auto found = sight_->found[c].size(), all = found + sight_->missing[c].size();
    if (!lines.usable()) {
      word_ = tr("refused");
      symbol_ = StateSymbol::Out;
    } else {
      word_ = tr("%1 of %2 pins").arg(found).arg(all);
      symbol_ = StateSymbol::Good;
    }
  }
  setAccessibleName(tr("Camera %1: %2").arg(camera_ + 1).arg(word_));
  update();
}

QRectF PlateView::pictureArea() const {
  const QRectF room(1, kHead, width() - 2, height() - kHead - 1);
  if (image_.isNull()) return room;
  const double scale = std::min(room.width() / image_.width(), room.height() / image_.height());
  const QSizeF size(image_.width() * scale, image_.height() * scale);
  return {room.center() - QPointF(size.width() / 2, size.height() / 2), size};
}

QPointF PlateView::onScreen(const Point2& px) const {
  const QRectF area = pictureArea();
  return {area.left() + (px.x() + 0.5) / image_.width() * area.width(),
          area.top() + (px.y() + 0.5) / image_.height() * area.height()};
}

void PlateView::resizeEvent(QResizeEvent* /*event*/) { scaled_ = {}; }

void PlateView::paintEvent(QPaintEvent* /*event*/) {
  const Palette& p = theme_.palette();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(p.line, 1));
  painter.setBrush(p.panel);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
  painter.setFont(uiFont(17, 500));
  painter.setPen(p.t1);
  painter.drawText(QPointF(14, 23), tr("Camera %1").arg(camera_ + 1));
  painter.setFont(uiFont(15));
  const double wide = painter.fontMetrics().horizontalAdvance(word_);
  painter.setPen(p.t2);
  painter.drawText(QPointF(width() - 14 - wide, 23), word_);
  paintSymbol(painter, QRectF(width() - 14 - wide - 26, 9, 18, 18), symbol_, p);
  painter.fillRect(QRectF(1, kHead, width() - 2, height() - kHead - 1), Qt::black);
  if (!image_.isNull()) paintPicture(painter);
}

void PlateView::paintPicture(QPainter& painter) {
  const QRectF area = pictureArea();
  if (scaled_.isNull())
    scaled_ = QPixmap::fromImage(image_.scaled(area.size().toSize(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
  painter.save();
  painter.setClipRect(QRectF(1, kHead, width() - 2, height() - kHead - 1));
  painter.drawPixmap(area.topLeft(), scaled_);
  painter.setPen(QPen(kMark, 1.5, Qt::DashLine));
  for (const auto& outline : ghost_) {
    QPolygonF curve;
    for (const Point2& px : outline) curve << onScreen(px);
    painter.drawPolyline(curve);
  }
  const PinPicture& lines = sight_->lines.pictures[static_cast<std::size_t>(camera_)];
  paintArcs(painter, lines);
  if (!lines.usable()) paintRefusal(painter, lines.refusal);
  painter.restore();
}

void PlateView::paintArcs(QPainter& painter, const PinPicture& lines) const {
  painter.setFont(uiFont(14));
  for (const PinArc& arc : lines.arcs) {
    if (arc.points.empty()) continue;
    QPolygonF curve;
    for (const ArcPoint& point : arc.points) curve << onScreen(point.px);
    const bool good = arc.usable() && arc.pin > 0;
    painter.setPen(QPen(good ? kLine : kMark, good ? 2.5 : 2));
    painter.drawPolyline(curve);
    const QPointF at = curve.at(curve.size() / 2) + QPointF(8, 16);
    painter.setPen(good ? kText : kMark);
    if (good)
      painter.drawText(at, QString::number(arc.pin));
    else if (lines.usable() && arc.points.size() > 20)  // bits of stray light have no words of their own
      painter.drawText(at, arc.usable() ? tr("no pin here") : shown(arc.reason));
  }
  const auto& missing = sight_->missing[static_cast<std::size_t>(camera_)];
  if (missing.empty() || !lines.usable()) return;
  QStringList numbers;
  for (const int pin : missing) numbers << QString::number(pin);
  const QString words = tr("not found: %1").arg(numbers.join(QStringLiteral(", ")));
  const QPointF at(10, height() - 10);
  painter.fillRect(QRectF(4, height() - 26, painter.fontMetrics().horizontalAdvance(words) + 12, 22),
                   QColor(0, 0, 0, 190));
  painter.setPen(kText);
  painter.drawText(at, words);
}

void PlateView::paintRefusal(QPainter& painter, const std::string& refusal) const {
  const QRectF box(10, kHead + 10, width() - 20, height() - kHead - 20);
  painter.setFont(uiFont(15, 500));
  const QRectF words = painter.boundingRect(box.adjusted(8, 6, -8, -6), Qt::TextWordWrap, shown(refusal));
  painter.fillRect(words.adjusted(-8, -6, 8, 6), QColor(0, 0, 0, 210));
  painter.setPen(kMark);
  painter.drawText(words, Qt::TextWordWrap, shown(refusal));
}

}  // namespace vignole
