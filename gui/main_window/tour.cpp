#include "gui/main_window/tour.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/theme/panel.h"

namespace vignole {

namespace {
constexpr int kBoxWidth = 440, kGap = 20;
}

Tour::Tour(const Theme& theme, std::vector<Step> steps, QWidget* parent)
    : QWidget(parent), theme_(theme), steps_(std::move(steps)), box_(new QWidget(this)) {
  box_->setObjectName(QStringLiteral("tourBox"));
  title_ = makeLabel(22, 500, "t1", box_, true);
  text_ = makeLabel(17, 400, "t1", box_, true);
  count_ = makeLabel(15, 400, "t2", box_);
  leave_ = makeButton(theme, {}, box_);
  next_ = makeButton(theme, {}, box_, true);
  auto* column = new QVBoxLayout(box_);
  column->setContentsMargins(20, 16, 20, 16);
  column->setSpacing(10);
  column->addWidget(title_);
  column->addWidget(text_);
  auto* row = new QHBoxLayout;
  row->addWidget(count_);
  row->addStretch(1);
  row->addWidget(leave_);
  row->addWidget(next_);
  column->addLayout(row);
  connect(next_, &QPushButton::clicked, this, &Tour::next);
  connect(leave_, &QPushButton::clicked, this, &Tour::leave);
  connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
  parent->installEventFilter(this);
  setGeometry(parent->rect());
  QWidget::show();
  raise();
  show(0);
  next_->setFocus();
}

void Tour::show(std::size_t step) {
  at_ = step;
  const Step& s = steps_[step];
  title_->setText(s.title());
  text_->setText(s.text());
  setAccessibleName(s.title() + QStringLiteral(". ") + s.text());
  count_->setText(tr("%1 of %2").arg(step + 1).arg(steps_.size()));
  leave_->setText(tr("Close (Esc)"));
  leave_->setAccessibleName(tr("Close the tour"));
  next_->setText(step + 1 < steps_.size() ? tr("Next") : tr("Begin"));
  next_->setAccessibleName(next_->text());
  layOut();
}

void Tour::next() {
  if (at_ + 1 < steps_.size())
    show(at_ + 1);
  else
    leave();
}

void Tour::leave() {
  hide();
  emit left();
  deleteLater();
}

QRect Tour::targetRect() const {
  const QWidget* target = steps_[at_].target;
  if (target == nullptr || !target->isVisible()) return {};
  return QRect(target->mapTo(parentWidget(), QPoint(0, 0)), target->size());
}

// Beside what is pointed at, where there is most room.
void Tour::layOut() {
  box_->setFixedWidth(kBoxWidth);
  const int high = std::max(box_->layout()->heightForWidth(kBoxWidth), box_->sizeHint().height());
  const QRect target = targetRect();
  QPoint at((width() - kBoxWidth) / 2, (height() - high) / 2);
  if (!target.isNull()) {
    const int right = width() - target.right(), below = height() - target.bottom();
    const int x = std::clamp(target.center().x() - kBoxWidth / 2, kGap, width() - kBoxWidth - kGap);
    const int y = std::clamp(target.center().y() - high / 2, kGap, height() - high - kGap);
    if (right > kBoxWidth + 2 * kGap)
      at = {target.right() + kGap, y};
    else if (target.left() > kBoxWidth + 2 * kGap)
      at = {target.left() - kGap - kBoxWidth, y};
    else if (below > high + 2 * kGap)
      at = {x, target.bottom() + kGap};
    else
      at = {x, std::max(kGap, target.top() - kGap - high)};
  }
  box_->setGeometry(QRect(at, QSize(kBoxWidth, high)));
  update();
}

bool Tour::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize) {
    setGeometry(parentWidget()->rect());
    layOut();
  }
  return QWidget::eventFilter(watched, event);
}

void Tour::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) show(at_);
}

void Tour::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Escape:
      leave();
      break;
    case Qt::Key_Right:
    case Qt::Key_Return:
    case Qt::Key_Enter:
      next();
      break;
    case Qt::Key_Left:
      if (at_ > 0) show(at_ - 1);
      break;
    default:
      QWidget::keyPressEvent(event);
  }
}

void Tour::mousePressEvent(QMouseEvent* /*event*/) { next(); }

void Tour::paintEvent(QPaintEvent* /*event*/) {
  const Palette& p = theme_.palette();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath dim;
  dim.addRect(rect());
  const QRect target = targetRect();
  QPainterPath hole;
  if (!target.isNull()) hole.addRoundedRect(QRectF(target).adjusted(-4, -4, 4, 4), 6, 6);
  QColor shade(0, 0, 0);
  shade.setAlphaF(theme_.dark() ? 0.6F : 0.45F);
  painter.fillPath(dim.subtracted(hole), shade);
  painter.setPen(QPen(p.accent, 3));
  painter.drawPath(hole);
  painter.setPen(QPen(p.accent, 2));
  painter.setBrush(p.panel2);
  painter.drawRoundedRect(QRectF(box_->geometry()), 4, 4);
}

}  // namespace vignole
