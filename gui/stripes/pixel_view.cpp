#include "gui/stripes/pixel_view.h"

#include <QPainter>

#include "gui/stripes/line_pens.h"

namespace vignole {

namespace {
constexpr double kScale = 8;
}

PixelView::PixelView(const Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme) {
  connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void PixelView::show(LatestFrames::Held taken, QPointF centre, const QString& instead) {
  if (taken == taken_ && centre == centre_ && instead == instead_) return;
  taken_ = std::move(taken);
  centre_ = centre;
  instead_ = instead;
  update();
}

void PixelView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  if (!taken_) {
    painter.setPen(QColor(0xCC, 0xCC, 0xCC));
    painter.setFont(uiFont(14));
    painter.drawText(QRectF(rect()).adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap, instead_);
  } else {
    const ImageView& image = taken_->frame.image;
    const QImage pixels(image.data, image.width, image.height, image.stride, QImage::Format_Grayscale8);
    painter.translate(QRectF(rect()).center());
    painter.scale(kScale, kScale);
    painter.translate(-centre_ - QPointF(0.5, 0.5));
    const QRect seen = QRectF(centre_.x() - width() / (2 * kScale), centre_.y() - height() / (2 * kScale),
                              width() / kScale, height() / kScale)
                           .adjusted(-1, -1, 2, 2)
                           .toAlignedRect()
                           .intersected(pixels.rect());
    painter.drawImage(QRectF(seen), pixels, QRectF(seen));
    painter.translate(0.5, 0.5);
    painter.setRenderHint(QPainter::Antialiasing);
    strokeLines(painter, strokesOf(taken_->stripe, 0), kLineColour, kScale);
  }
  painter.resetTransform();
  painter.setPen(theme_.palette().line);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

}  // namespace vignole
