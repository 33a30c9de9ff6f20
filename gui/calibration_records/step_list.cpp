#include "gui/calibration_records/step_list.h"

#include <QPainter>
#include <QPainterPath>
#include <utility>

namespace vignole {

namespace {
constexpr int kLeastStep = 38, kMostStep = 60;
}

StepList::StepList(const Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme) {
  connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void giveRoom(QLabel& wrapped) {
  wrapped.setMinimumHeight(wrapped.text().isEmpty() || wrapped.width() < 200 ? 0
                                                                             : wrapped.heightForWidth(wrapped.width()));
}

QSize StepList::minimumSizeHint() const { return {160, kLeastStep * static_cast<int>(steps_.size())}; }

void StepList::show(std::vector<Step> steps, int current) {
  const bool grew = steps.size() != steps_.size();
  steps_ = std::move(steps);
  current_ = current;
  QString spoken;
  for (std::size_t i = 0; i < steps_.size(); ++i)
    if (static_cast<int>(i) == current_)
      spoken = tr("Step %1 of %2: %3").arg(i + 1).arg(steps_.size()).arg(steps_[i].title);
  setAccessibleName(spoken);
  if (grew) updateGeometry();
  update();
}

void StepList::paintEvent(QPaintEvent* /*event*/) {
  if (steps_.empty()) return;
  const Palette& p = theme_.palette();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double step = std::min<double>(kMostStep, height() / static_cast<double>(steps_.size()));
  const double radius = step < 48 ? 12 : 14, x = 20;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const double top = step * static_cast<double>(i), y = top + step / 2;
    const bool at = static_cast<int>(i) == current_, done = static_cast<int>(i) < current_;
    if (at) {
      painter.fillRect(QRectF(0, top, width(), step), p.accentSoft);
      painter.fillRect(QRectF(0, top, 4, step), p.accent);
    }
    if (i + 1 < steps_.size()) {
      painter.setPen(QPen(done ? p.t2 : p.line, 1.5));
      painter.drawLine(QPointF(x, y + radius), QPointF(x, y + step - radius));
    }
    painter.setPen(QPen(at ? p.accent : done ? p.t2 : p.line, 1.5));
    painter.setBrush(at ? p.accent : done ? p.t2 : p.panel2);
    painter.drawEllipse(QPointF(x, y), radius, radius);
    if (done) {
      painter.setPen(QPen(p.panel2, 2));
      painter.setBrush(Qt::NoBrush);
      painter.drawPolyline(QPolygonF({{x - 5, y}, {x - 1.5, y + 4}, {x + 5, y - 4}}));
    } else {
      painter.setFont(uiFont(14, 500));
      painter.setPen(at ? p.panel2 : p.t2);
      painter.drawText(QRectF(x - radius, y - radius, 2 * radius, 2 * radius), Qt::AlignCenter, steps_[i].number);
    }
    const double left = x + radius + 10, room = width() - left - 6;
    painter.setFont(uiFont(16, at ? 500 : 400));
    painter.setPen(p.t1);
    const bool two = !steps_[i].note.isEmpty();
    painter.drawText(QPointF(left, y + (two ? -2 : 6)),
                     painter.fontMetrics().elidedText(steps_[i].title, Qt::ElideRight, static_cast<int>(room)));
    if (!two) continue;
    painter.setFont(uiFont(14));
    painter.setPen(p.t2);
    painter.drawText(QPointF(left, y + 16),
                     painter.fontMetrics().elidedText(steps_[i].note, Qt::ElideRight, static_cast<int>(room)));
  }
}

}  // namespace vignole
