#include "gui/calibration_lens/target_view.h"

#include <QPainter>
#include <algorithm>
#include <utility>

namespace vignole {

namespace {
const QColor kLine(0x62, 0xAE, 0xF0), kMark(0xFF, 0xB5, 0x2E);  // on pictures, in both themes

QRectF fitted(const QRectF& room, double width, double height) {
  const double scale = std::min(room.width() / width, room.height() / height);
  const QSizeF size(width * scale, height * scale);
  return {room.center() - QPointF(size.width() / 2, size.height() / 2), size};
}
}  // namespace

TargetPicture::TargetPicture(const Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme) {
  connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void TargetPicture::show(std::shared_ptr<const LensSight> sight, std::vector<Point2> ghost) {
  if (sight != sight_) {
    sight_ = std::move(sight);
    image_ = {};
    scaled_ = {};
    if (sight_)
      image_ = QImage(sight_->picture.pixels.data(), sight_->picture.width, sight_->picture.height,
                      sight_->picture.width, QImage::Format_Grayscale8);
  }
  ghost_ = std::move(ghost);
  update();
}

void TargetPicture::resizeEvent(QResizeEvent* /*event*/) { scaled_ = {}; }

void TargetPicture::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), Qt::black);
  if (image_.isNull()) return;
  const QRectF area = fitted(rect(), image_.width(), image_.height());
  if (scaled_.isNull())
    scaled_ = QPixmap::fromImage(image_.scaled(area.size().toSize(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
  painter.drawPixmap(area.topLeft(), scaled_);
  const auto onScreen = [&](const Point2& px) {
    return QPointF(area.left() + (px.x() + 0.5) / image_.width() * area.width(),
                   area.top() + (px.y() + 0.5) / image_.height() * area.height());
  };
  painter.setClipRect(area);
  painter.setPen(QPen(kLine, 1.5));
  for (const FoundPoint& point : sight_->view.points) {
    const QPointF at = onScreen(point.px);
    painter.drawLine(at - QPointF(4, 0), at + QPointF(4, 0));
    painter.drawLine(at - QPointF(0, 4), at + QPointF(0, 4));
  }
  QPolygonF outline;
  for (const Point2& px : ghost_) outline << onScreen(px);
  painter.setPen(QPen(kMark, 2.5, Qt::DashLine));
  painter.drawPolyline(outline);
}

CoverageMap::CoverageMap(const Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme) {
  connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void CoverageMap::show(const std::vector<TargetView>& taken, const std::vector<Point2>& ghost, int widthPx,
                       int heightPx) {
  std::vector<CoveragePoint> points;
  points_.clear();
  for (const TargetView& view : taken)
    for (const FoundPoint& point : view.points) {
      points.push_back({point.px, {0, 0}});
      points_.push_back(point.px);
    }
  coverage_ = coverageOf(points, widthPx, heightPx);
  ghost_ = ghost;
  widthPx_ = widthPx;
  heightPx_ = heightPx;
  update();
}

void CoverageMap::paintEvent(QPaintEvent* /*event*/) {
  const Palette& p = theme_.palette();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF area = fitted(QRectF(rect()).adjusted(1, 1, -1, -1), widthPx_, heightPx_);
  painter.fillRect(area, p.panel2);
  const int columns = std::max(1, coverage_.columns), rows = std::max(1, coverage_.rows);
  for (int row = 0; row < coverage_.rows; ++row)
    for (int column = 0; column < coverage_.columns; ++column) {
      const CoverageCell& cell = coverage_.cells[static_cast<std::size_t>(row * coverage_.columns + column)];
      if (cell.points == 0) continue;
      QColor fill = p.accent;
      fill.setAlphaF(static_cast<float>(std::min(0.7, 0.15 + 0.02 * cell.points)));
      painter.fillRect(QRectF(area.left() + column * area.width() / columns, area.top() + row * area.height() / rows,
                              area.width() / columns, area.height() / rows),
                       fill);
    }
  const auto onScreen = [&](const Point2& px) {
    return QPointF(area.left() + px.x() / widthPx_ * area.width(), area.top() + px.y() / heightPx_ * area.height());
  };
  painter.setPen(Qt::NoPen);
  painter.setBrush(p.t1);
  for (const Point2& px : points_) painter.drawEllipse(onScreen(px), 1.1, 1.1);
  painter.setClipRect(area);
  QPolygonF outline;
  for (const Point2& px : ghost_) outline << onScreen(px);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(p.t1, 1.5, Qt::DashLine));
  painter.drawPolyline(outline);
  painter.setPen(QPen(p.line, 1));
  painter.drawRect(area);
}

}  // namespace vignole
