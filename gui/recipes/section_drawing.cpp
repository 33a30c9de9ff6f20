#include "gui/recipes/section_drawing.h"

#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace vignole {

namespace {

constexpr double kNameRoomPx = 62;  // around the outline
constexpr double kStepMm = 0.5;     // of a drawn arc

}  // namespace

SectionDrawing::SectionDrawing(const Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme) {
  connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void SectionDrawing::show(const Section& section) {
  lines_.clear();
  for (const NamedPrimitive& p : section.primitives) lines_.push_back({QString::fromStdString(p.name), p.shape});
  closed_ = true;
  gap_.reset();
  message_.clear();
  update();
}

void SectionDrawing::showOpen(const std::vector<Piece>& pieces, const std::optional<OutlineGap>& gap) {
  lines_.clear();
  for (const Piece& piece : pieces) lines_.push_back({QString(), piece.shape});
  closed_ = false;
  gap_ = gap;
  message_.clear();
  update();
}

void SectionDrawing::showMessage(const QString& message) {
  lines_.clear();
  gap_.reset();
  labels_.clear();
  message_ = message;
  update();
}

void SectionDrawing::setChosen(const QString& primitive) {
  chosen_ = primitive;
  update();
}

SectionDrawing::View SectionDrawing::view() const {
  Point2 low(1e9, 1e9), high(-1e9, -1e9);
  for (const Line& line : lines_)
    for (const Point2& p : polyline(line.shape, kStepMm)) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  const QRectF room = QRectF(rect()).adjusted(kNameRoomPx, kNameRoomPx / 2, -kNameRoomPx, -kNameRoomPx / 2);
  View view;
  view.pxPerMm = std::max(0.1, std::min(room.width() / std::max(1.0, high.x() - low.x()),
                                        room.height() / std::max(1.0, high.y() - low.y())));
  const Point2 middle = (low + high) / 2;
  view.origin = room.center() + QPointF(-middle.x(), middle.y()) * view.pxPerMm;
  return view;
}

void SectionDrawing::paintEvent(QPaintEvent* /*event*/) {
  const Palette& p = theme_.palette();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), p.panel2);
  if (lines_.empty()) {
    painter.setFont(uiFont(16));
    painter.setPen(p.t2);
    painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, message_);
    return;
  }
  const View view = this->view();
  if (closed_) {
    QPolygonF outline;
    for (const Line& line : lines_)
      for (const Point2& at : polyline(line.shape, kStepMm)) outline << view.map(at);
    painter.setPen(Qt::NoPen);
    painter.setBrush(p.steel);
    painter.drawPolygon(outline);
  }
  painter.setBrush(Qt::NoBrush);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    QPolygonF curve;
    for (const Point2& at : polyline(lines_[i].shape, kStepMm)) curve << view.map(at);
    const bool chosen = closed_ && !chosen_.isEmpty() && lines_[i].name == chosen_;
    // In turn dark and grey: where one ends and the next begins is seen without colour.
    const QColor ink = chosen ? p.accent : !closed_ || i % 2 == 0 ? p.t1 : p.model;
    painter.setPen(QPen(ink, chosen ? 5 : 2.5, Qt::SolidLine, Qt::FlatCap));
    painter.drawPolyline(curve);
  }
  if (closed_) paintNames(painter, view);
  if (gap_) paintGap(painter, view);
}

void SectionDrawing::paintNames(QPainter& painter, const View& view) {
  const Palette& p = theme_.palette();
  labels_.clear();
  std::vector<QPointF> outline;
  for (const Line& line : lines_)
    for (const Point2& at : polyline(line.shape, kStepMm)) outline.push_back(view.map(at));
  const auto covers = [&](const QRectF& box) {
    return std::any_of(labels_.begin(), labels_.end(), [&](const QRectF& other) { return other.intersects(box); }) ||
           std::any_of(outline.begin(), outline.end(), [&](const QPointF& at) { return box.contains(at); });
  };
  const QFont font = uiFont(14, 500);
  painter.setFont(font);
  const QFontMetricsF metrics(font);
  for (const Line& line : lines_) {
    const double half = length(line.shape) / 2;
    const QPointF foot = view.map(pointAt(line.shape, half));
    const Point2 normal = normalAt(line.shape, half);
    const QPointF out(normal.x(), -normal.y());
    const QSizeF size(metrics.horizontalAdvance(line.name) + 4, metrics.height() - 2);
    QRectF box;
    bool found = false;
    // Outwards, further and further, and a little to either side: the first place that covers nothing.
    for (double off = 8; off < 90 && !found; off += 6)
      for (const double turn : {0.0, 0.4, -0.4, 0.8, -0.8}) {
        const QPointF way(out.x() * std::cos(turn) - out.y() * std::sin(turn),
                          out.x() * std::sin(turn) + out.y() * std::cos(turn));
        const QPointF middle = foot + way * off + QPointF(way.x() * size.width() / 2, way.y() * size.height() / 2);
        box = QRectF(middle - QPointF(size.width() / 2, size.height() / 2), size);
        if (covers(box) || !QRectF(rect()).contains(box)) continue;
        found = true;
        break;
      }
    if (!found) continue;  // the table beside the drawing has it all the same
    labels_.push_back(box);
    const QPointF near(std::clamp(foot.x(), box.left(), box.right()), std::clamp(foot.y(), box.top(), box.bottom()));
    painter.setPen(QPen(p.t3, 1));
    if (QLineF(foot, near).length() > 10) painter.drawLine(QLineF(foot, near));
    painter.setPen(line.name == chosen_ ? p.accent : p.t1);
    painter.drawText(box, Qt::AlignCenter, line.name);
  }
}

void SectionDrawing::paintGap(QPainter& painter, const View& view) const {
  const Palette& p = theme_.palette();
  const QPointF end = view.map(gap_->end);
  painter.setPen(QPen(p.out, 2.5));
  painter.drawEllipse(end, 12, 12);
  QString words = tr("free end");
  if (gap_->other) {
    const QPointF other = view.map(*gap_->other);
    painter.drawEllipse(other, 12, 12);
    painter.setPen(QPen(p.out, 2, Qt::DashLine));
    painter.drawLine(end, other);
    words = tr("open here: %1 mm").arg(locale().toString((*gap_->other - gap_->end).norm(), 'g', 4));
  }
  painter.setFont(uiFont(16, 500));
  const QFontMetricsF metrics(painter.font());
  QRectF box(end + QPointF(20, -14), QSizeF(metrics.horizontalAdvance(words) + 12, 28));
  if (box.right() > width()) box.moveRight(end.x() - 20);
  painter.setPen(Qt::NoPen);
  painter.setBrush(p.outSoft);
  painter.drawRect(box);
  painter.setPen(p.t1);
  painter.drawText(box, Qt::AlignCenter, words);
}

}  // namespace vignole
