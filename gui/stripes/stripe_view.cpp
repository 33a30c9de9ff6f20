#include "gui/stripes/stripe_view.h"

#include <QEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <array>

#include "gui/stripes/line_pens.h"
#include "gui/theme/inscription.h"
#include "report/state_symbol.h"

namespace vignole {

namespace {
constexpr double kHead = 34, kBrightness = 46;
constexpr int kFigures = 100;
constexpr double kSaturatedShown = 0.001, kMostZoom = 64;
const QColor kGround(0x0C, 0x0C, 0x0C), kOnGround(0xCC, 0xCC, 0xCC);
}  // namespace

StripeView::StripeView(const Theme& theme, int camera, QWidget* parent)
    : QWidget(parent), theme_(theme), camera_(camera) {
  connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
  retranslate();
}

void StripeView::retranslate() { setAccessibleName(tr("Camera %1").arg(camera_ + 1)); }

void StripeView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
}

void StripeView::show(std::shared_ptr<const StripePicture> picture) {
  picture_ = std::move(picture);
  update();
}

void StripeView::setField(const QPolygonF& field) {
  field_ = field;
  update();
}

void StripeView::setState(const QString& words, bool stale) {
  if (words == state_ && stale == stale_) return;
  state_ = words;
  stale_ = stale;
  setAccessibleDescription(words);
  update();
}

void StripeView::setRate(double framesPerS) { rate_ = framesPerS; }

void StripeView::setChosen(bool chosen) {
  chosen_ = chosen;
  update();
}

QRectF StripeView::pictureArea() const { return QRectF(1, kHead, width() - kFigures - 2, height() - kHead - 1); }

QSize StripeView::pictureSize() const {
  const QRectF area = pictureArea();
  return (area.size() * devicePixelRatioF()).toSize();
}

double StripeView::baseScale() const {
  const ImageView& image = picture_->taken->frame.image;
  const QRectF area = pictureArea();
  return std::min(area.width() / image.width, area.height() / image.height);
}

void StripeView::zoom(double factor) {
  zoom_ = std::clamp(zoom_ * factor, 1.0, kMostZoom);
  if (zoom_ <= 1) fit();
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
  if (!hasPixels() || zoom_ <= 1 || !(event->buttons() & Qt::LeftButton)) return;
  const ImageView& image = picture_->taken->frame.image;
  if (centre_.x() < 0) centre_ = QPointF(image.width, image.height) / 2;
  centre_ -= (event->position() - dragFrom_) / (baseScale() * zoom_);
  dragFrom_ = event->position();
  update();
}

void StripeView::wheelEvent(QWheelEvent* event) {
  if (!hasPixels()) return;
  const ImageView& image = picture_->taken->frame.image;
  const QRectF area = pictureArea();
  if (centre_.x() < 0) centre_ = QPointF(image.width, image.height) / 2;
  // What lies under the pointer stays there.
  const QPointF fromMiddle = event->position() - area.center();
  const QPointF under = centre_ + fromMiddle / (baseScale() * zoom_);
  zoom(event->angleDelta().y() > 0 ? 1.25 : 0.8);
  if (zoom_ > 1) centre_ = under - fromMiddle / (baseScale() * zoom_);
  update();
}

void StripeView::paintMarks(QPainter& painter, double scale) const {
  painter.setBrush(Qt::NoBrush);
  if (!field_.isEmpty()) {
    painter.setPen(QPen(QColor(0x9A, 0x9A, 0x9A), 1 / scale, Qt::DashLine));
    painter.drawPolygon(field_);
  }
  painter.setPen(QPen(kMarkColour, 1.5 / scale));
  for (const QRectF& spot : picture_->saturated) painter.drawRect(spot);
}

void StripeView::paintPicture(QPainter& painter, const QRectF& area) const {
  const ImageView& image = picture_->taken->frame.image;
  const double scale = baseScale() * zoom_;
  const QPointF middle = centre_.x() < 0 ? QPointF(image.width, image.height) / 2 : centre_;
  painter.save();
  painter.setClipRect(area);
  if (stale_) painter.setOpacity(0.45);
  if (zoom_ <= 1 && !picture_->whole.isNull()) {
    const QSizeF size = QSizeF(image.width, image.height) * scale;
    painter.drawImage(QRectF(area.center() - QPointF(size.width(), size.height()) / 2, size), picture_->whole);
  }
  painter.translate(area.center());
  painter.scale(scale, scale);
  painter.translate(-middle);
  if (zoom_ > 1 || picture_->whole.isNull()) {
    // The pixels themselves, and only those that are seen.
    const QImage pixels(image.data, image.width, image.height, image.stride, QImage::Format_Grayscale8);
    const QRectF seen = QRectF(middle - QPointF(area.width(), area.height()) / (2 * scale), area.size() / scale)
                            .adjusted(-1, -1, 1, 1)
                            .intersected(QRectF(0, 0, image.width, image.height));
    const QRect whole = seen.toAlignedRect().intersected(pixels.rect());
    painter.drawImage(QRectF(whole), pixels, QRectF(whole));
  }
  // Pixel centres are at integers, the corner of the first pixel is the painter's origin.
  painter.translate(0.5, 0.5);
  painter.setRenderHint(QPainter::Antialiasing);
  if (picture_->trial) strokeLines(painter, picture_->trial->strokes, kMarkColour, scale);
  strokeLines(painter, zoom_ > 1 ? strokesOf(picture_->taken->stripe, 1 / zoom_) : picture_->strokes, kLineColour,
              scale);
  paintMarks(painter, scale);
  painter.restore();
}

void StripeView::paintBrightness(QPainter& painter, const QRectF& area) const {
  painter.setPen(kOnGround);
  painter.setFont(uiFont(14));
  painter.drawText(QPointF(area.left() + 8, area.top() - 3), tr("brightness along the line"));
  painter.setPen(QPen(kMarkColour, 1, Qt::DotLine));
  painter.drawLine(QPointF(area.left(), area.top() + 2), QPointF(area.right(), area.top() + 2));
  const auto& brightness = picture_->brightnessDn;
  if (brightness.size() < 2) return;
  QPolygonF curve;
  const double step = (area.width() - 4) / static_cast<double>(brightness.size() - 1);
  for (std::size_t i = 0; i < brightness.size(); ++i) {
    const double dn = std::clamp(static_cast<double>(brightness[i]), 0.0, 255.0);
    curve << QPointF(area.left() + 2 + static_cast<double>(i) * step,
                     area.bottom() - 2 - (area.height() - 4) * dn / 255);
  }
  painter.setPen(QPen(Qt::white, 1));
  painter.drawPolyline(curve);
}

void StripeView::paintFigures(QPainter& painter, const QRectF& area) const {
  const Palette& p = theme_.palette();
  struct Figure {
    QString word, value, unit;
    bool near = false;
  };
  const auto number = [this](double value, int decimals) { return locale().toString(value, 'f', decimals); };
  const QString none = QStringLiteral("–");
  std::array<Figure, 5> figures = {{{tr("Points"), none, {}},
                                    {tr("Saturated"), none, {}},
                                    {tr("Noise"), none, {}},
                                    {tr("Pieces"), none, {}},
                                    {tr("Mean"), none, {}}}};
  if (hasPixels()) {
    const StripeFigures& f = picture_->figures;
    figures[0] = {figures[0].word, count(f.points), {}, f.points == 0};
    figures[1] = {figures[1].word, number(100 * f.saturatedShare, 1), QStringLiteral("%"),
                  f.saturatedShare > kSaturatedShown};
    figures[2] = {figures[2].word, number(f.noiseDn, 1), QStringLiteral("DN")};
    figures[3] = {figures[3].word, count(f.pieces), {}};
    figures[4] = {figures[4].word, number(f.meanDn, 0), QStringLiteral("DN")};
  }
  const double pitch = area.height() / static_cast<double>(figures.size());
  const bool tight = pitch < 42;
  double y = area.top();
  for (const Figure& f : figures) {
    if (f.near) painter.fillRect(QRectF(area.left() + 2, y + 1, area.width() - 4, pitch - 2), p.nearSoft);
    const double middle = y + pitch / 2;
    painter.setPen(stale_ ? p.t3 : p.t2);
    painter.setFont(uiFont(14));
    const double room = area.width() - (f.near ? 32 : 14);
    painter.drawText(QPointF(area.left() + 9, middle - (tight ? 4 : 6)),
                     painter.fontMetrics().elidedText(f.word, Qt::ElideRight, static_cast<int>(room)));
    painter.setPen(stale_ ? p.t3 : p.t1);
    painter.setFont(uiFont(tight ? 16 : 19, 500));
    const double base = middle + (tight ? 13 : 16);
    painter.drawText(QPointF(area.left() + 9, base), f.value);
    const double used = painter.fontMetrics().horizontalAdvance(f.value);
    painter.setFont(uiFont(14));
    painter.setPen(p.t3);
    painter.drawText(QPointF(area.left() + 13 + used, base), f.unit);
    if (f.near) paintSymbol(painter, QRectF(area.right() - 21, y + 3, 15, 15), StateSymbol::Near, p);
    y += pitch;
  }
}

void StripeView::paintHead(QPainter& painter) const {
  const Palette& p = theme_.palette();
  const std::array<QString, kCameraCount> places = {tr("upper left"), tr("upper right"), tr("lower right"),
                                                    tr("lower left")};
  painter.setFont(uiFont(17, 500));
  painter.setPen(p.t1);
  const QString name = tr("Camera %1").arg(camera_ + 1);
  double left = 12;
  if (stale_) {
    paintSymbol(painter, QRectF(left, 8, 18, 18), StateSymbol::Held, p);
    left += 26;
  }
  painter.drawText(QPointF(left, 23), name);
  left += painter.fontMetrics().horizontalAdvance(name) + 10;
  painter.setFont(uiFont(14));
  painter.setPen(p.t2);
  const QFontMetrics small = painter.fontMetrics();
  QStringList right;
  if (!state_.isEmpty()) right << state_;
  if (!stale_ && rate_ > 0) right << tr("%1/s").arg(locale().toString(rate_, 'f', 1));
  if (picture_) right << tr("trigger %1").arg(count(picture_->trigger));
  const QString words = right.join(QStringLiteral("   "));
  const int place = small.horizontalAdvance(places[static_cast<std::size_t>(camera_)]) + 16;
  if (left + place + small.horizontalAdvance(words) < width() - 12) {
    painter.drawText(QPointF(left, 23), places[static_cast<std::size_t>(camera_)]);
    left += place;
  }
  const QRectF room(left, 4, width() - 12 - left, 28);
  painter.drawText(room, Qt::AlignRight | Qt::AlignVCenter,
                   small.elidedText(words, Qt::ElideRight, static_cast<int>(room.width())));
}

void StripeView::paintEvent(QPaintEvent* /*event*/) {
  const Palette& p = theme_.palette();
  QPainter painter(this);
  painter.fillRect(rect(), p.panel);
  const QRectF area = pictureArea();
  painter.fillRect(area, kGround);
  if (hasPixels()) {
    paintPicture(painter, area);
    if (zoom_ <= 1 && area.height() > 150)
      paintBrightness(painter, QRectF(area.left(), area.bottom() - kBrightness, area.width(), kBrightness));
  } else {
    painter.setPen(kOnGround);
    painter.setFont(uiFont(16));
    painter.drawText(area.adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap,
                     state_.isEmpty() ? tr("no picture yet") : state_);
  }
  painter.setRenderHint(QPainter::Antialiasing);
  paintHead(painter);
  paintFigures(painter, QRectF(width() - kFigures, kHead, kFigures, height() - kHead));
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(chosen_ ? p.accent : p.line, chosen_ ? 2 : 1));
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
}

}  // namespace vignole
