#include "gui/stripes/stripe_view.h"

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "gui/theme/inscription.h"
#include "report/state_symbol.h"

namespace vignole {

namespace {
constexpr double kHead = 34, kFigures = 108, kBrightness = 46;
const QColor kLineColour(0x62, 0xAE, 0xF0), kMark(0xFF, 0xB5, 0x2E), kGround(0x0C, 0x0C, 0x0C);
constexpr double kSaturatedShown = 0.001;
}  // namespace

StripeView::StripeView(const Theme& theme, int camera, QWidget* parent)
    : QWidget(parent), theme_(theme), camera_(camera) {
  setAccessibleName(tr("Camera %1").arg(camera + 1));
  connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void StripeView::show(std::shared_ptr<const StripePicture> picture, bool trial) {
  picture_ = std::move(picture);
  trial_ = trial;
  update();
}

void StripeView::setState(const QString& words, bool stale) {
  if (words == state_ && stale == stale_) return;
  state_ = words;
  stale_ = stale;
  setAccessibleDescription(words);
  update();
}

void StripeView::setChosen(bool chosen) {
  chosen_ = chosen;
  update();
}

QRectF StripeView::pictureArea() const { return QRectF(1, kHead, width() - kFigures - 2, height() - kHead - 1); }

void StripeView::zoom(double factor) {
  zoom_ = std::clamp(zoom_ * factor, 1.0, 64.0);
  if (zoom_ == 1) centre_ = {-1, -1};
  update();
}

void StripeView::fit() {
  zoom_ = 1;
  centre_ = {-1, -1};
  update();
}

void StripeView::mousePressEvent(QMouseEvent* event) {
  dragFrom_ = event->position();
  emit pressed(camera_);
}

void StripeView::mouseMoveEvent(QMouseEvent* event) {
  if (!picture_ || zoom_ <= 1 || !(event->buttons() & Qt::LeftButton)) return;
  const QRectF area = pictureArea();
  const double scale =
      zoom_ * std::min(area.width() / picture_->image.width(), area.height() / picture_->image.height());
  if (centre_.x() < 0) centre_ = QPointF(picture_->image.width(), picture_->image.height()) / 2;
  centre_ -= (event->position() - dragFrom_) / scale;
  dragFrom_ = event->position();
  update();
}

void StripeView::wheelEvent(QWheelEvent* event) {
  if (!picture_) return;
  const QRectF area = pictureArea();
  const double base = std::min(area.width() / picture_->image.width(), area.height() / picture_->image.height());
  if (centre_.x() < 0) centre_ = QPointF(picture_->image.width(), picture_->image.height()) / 2;
  // What lies under the pointer stays there.
  const QPointF under = centre_ + (event->position() - area.center()) / (base * zoom_);
  zoom(event->angleDelta().y() > 0 ? 1.25 : 0.8);
  if (zoom_ > 1) centre_ = under - (event->position() - area.center()) / (base * zoom_);
  update();
}

void StripeView::paintLine(QPainter& painter, const ExtractedLine& line, const QColor& colour, double pxPerPx) const {
  painter.setPen(QPen(colour, 1.6 / pxPerPx));
  for (const StripeLine& l : line.stripe.lines) {
    if (l.rejected()) continue;
    QPolygonF points;
    for (std::size_t i = l.first; i < std::size_t{l.first} + l.count; ++i)
      points << QPointF(static_cast<double>(line.stripe.points[i].x) + 0.5,
                        static_cast<double>(line.stripe.points[i].y) + 0.5);
    painter.drawPolyline(points);
  }
}

void StripeView::paintBrightness(QPainter& painter, const QRectF& area) const {
  painter.setPen(QColor(0xCC, 0xCC, 0xCC));
  painter.setFont(uiFont(14));
  painter.drawText(QPointF(area.left() + 8, area.top() - 2), tr("brightness along the line"));
  painter.setPen(QPen(kMark, 1, Qt::DotLine));
  painter.drawLine(QPointF(area.left(), area.top() + 2), QPointF(area.right(), area.top() + 2));
  const StripeResult& stripe = picture_->inUse.stripe;
  if (stripe.points.empty()) return;
  QPolygonF curve;
  const double step = area.width() / static_cast<double>(stripe.points.size());
  for (std::size_t i = 0; i < stripe.points.size(); ++i) {
    const double dn = std::clamp(static_cast<double>(stripe.points[i].strength), 0.0, 255.0);
    curve << QPointF(area.left() + static_cast<double>(i) * step, area.bottom() - 2 - (area.height() - 4) * dn / 255);
  }
  painter.setPen(QPen(Qt::white, 1));
  painter.drawPolyline(curve);
}

void StripeView::paintFigures(QPainter& painter, const QRectF& area) const {
  const Palette& p = theme_.palette();
  const StripeResult* stripe = picture_ ? &picture_->inUse.stripe : nullptr;
  struct Figure {
    QString word, value, unit;
    bool near = false;
  };
  std::vector<Figure> figures;
  if (stripe != nullptr) {
    std::size_t lines = 0;
    double strength = 0;
    for (const StripeLine& l : stripe->lines) lines += l.rejected() ? 0 : 1;
    for (const StripePoint& point : stripe->points) strength += static_cast<double>(point.strength);
    if (!stripe->points.empty()) strength /= static_cast<double>(stripe->points.size());
    const double saturated = static_cast<double>(stripe->saturatedShare);
    figures = {
        {tr("Points"), count(stripe->points.size()), {}, stripe->points.empty()},
        {tr("Saturated"), locale().toString(100 * saturated, 'f', 1), QStringLiteral("%"), saturated > kSaturatedShown},
        {tr("Noise"), locale().toString(static_cast<double>(stripe->noiseDn), 'f', 1), QStringLiteral("DN"), false},
        {tr("Pieces"), QString::number(lines), {}, false},
        {tr("Mean"), locale().toString(strength, 'f', 0), QStringLiteral("DN"), false}};
  }
  const double pitch = area.height() / 5;
  double y = area.top();
  for (const Figure& f : figures) {
    if (f.near) painter.fillRect(QRectF(area.left() + 2, y + 2, area.width() - 4, pitch - 4), p.nearSoft);
    painter.setPen(stale_ ? p.t3 : p.t2);
    painter.setFont(uiFont(14));
    painter.drawText(QPointF(area.left() + 10, y + pitch / 2 - 6), f.word);
    painter.setPen(stale_ ? p.t3 : p.t1);
    painter.setFont(uiFont(19, 500));
    painter.drawText(QPointF(area.left() + 10, y + pitch / 2 + 16), f.value);
    const double used = painter.fontMetrics().horizontalAdvance(f.value);
    painter.setFont(uiFont(14));
    painter.setPen(p.t3);
    painter.drawText(QPointF(area.left() + 14 + used, y + pitch / 2 + 16), f.unit);
    if (f.near) paintSymbol(painter, QRectF(area.right() - 22, y + 6, 16, 16), StateSymbol::Near, p);
    y += pitch;
  }
}

void StripeView::paintEvent(QPaintEvent* /*event*/) {
  const Palette& p = theme_.palette();
  QPainter painter(this);
  painter.fillRect(rect(), p.panel);
  painter.setFont(uiFont(17, 500));
  painter.setPen(p.t1);
  painter.drawText(QPointF(12, 23), tr("Camera %1").arg(camera_ + 1));
  painter.setFont(uiFont(14));
  painter.setPen(p.t2);
  QString right = state_;
  if (picture_)
    right += (right.isEmpty() ? QString() : QStringLiteral("   ")) + tr("trigger %1").arg(count(picture_->trigger));
  painter.drawText(QRectF(110, 4, width() - 122, 28), Qt::AlignRight | Qt::AlignVCenter, right);

  const QRectF area = pictureArea();
  painter.fillRect(area, kGround);
  if (picture_) {
    const QImage& image = picture_->image;
    const double scale = zoom_ * std::min(area.width() / image.width(), area.height() / image.height());
    const QPointF middle = centre_.x() < 0 ? QPointF(image.width(), image.height()) / 2 : centre_;
    painter.save();
    painter.setClipRect(area);
    if (stale_) painter.setOpacity(0.5);
    painter.translate(area.center());
    painter.scale(scale, scale);
    painter.translate(-middle);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, scale < 1);
    painter.drawImage(QPointF(0, 0), image);
    painter.setRenderHint(QPainter::Antialiasing);
    if (trial_ && picture_->trial) paintLine(painter, *picture_->trial, kMark, scale);
    paintLine(painter, picture_->inUse, kLineColour, scale);
    painter.restore();
    if (zoom_ == 1 && area.height() > 150)
      paintBrightness(painter, QRectF(area.left(), area.bottom() - kBrightness, area.width(), kBrightness));
  } else {
    painter.setPen(QColor(0xCC, 0xCC, 0xCC));
    painter.setFont(uiFont(16));
    painter.drawText(area.adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap,
                     state_.isEmpty() ? tr("no picture yet") : state_);
  }
  painter.setRenderHint(QPainter::Antialiasing);
  paintFigures(painter, QRectF(width() - kFigures, kHead, kFigures, height() - kHead));
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(chosen_ ? p.accent : p.line, chosen_ ? 2 : 1));
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
}

}  // namespace vignole
