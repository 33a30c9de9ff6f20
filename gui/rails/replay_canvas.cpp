#include "gui/rails/replay_canvas.h"

#include <QEvent>
#include <QPainter>

namespace vignole {

ReplayCanvas::ReplayCanvas(const Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme) {
  setAccessibleName(tr("Profile of the stored rail"));
  connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void ReplayCanvas::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::LanguageChange) return;
  setAccessibleName(tr("Profile of the stored rail"));
  update();
}

void ReplayCanvas::show(std::shared_ptr<const OpenedRail> rail, std::shared_ptr<const ProfileResult> profile,
                        std::optional<Dimension> selected) {
  rail_ = std::move(rail);
  profile_ = std::move(profile);
  const bool before = drawing_.beforeRegistration;
  drawing_ = {};
  drawing_.beforeRegistration = before;
  if (rail_ && rail_->recipe) {
    drawing_.section = &rail_->recipe->section;
    drawing_.limits = &rail_->recipe->limits;
    drawing_.parameters = &rail_->recipe->parameters;
  }
  if (profile_) {
    drawing_.profile = &profile_->profile;
    drawing_.registration = &profile_->registration;
    drawing_.measurement = &profile_->measurement;
  }
  drawing_.selected = selected;
  message_.clear();
  update();
}

void ReplayCanvas::setBeforeRegistration(bool before) {
  drawing_.beforeRegistration = before;
  update();
}

void ReplayCanvas::setMessage(const QString& message) {
  rail_.reset();
  profile_.reset();
  drawing_ = {};
  message_ = message;
  update();
}

void ReplayCanvas::paintEvent(QPaintEvent* /*event*/) {
  const Palette& p = theme_.palette();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), p.panel2);
  painter.setFont(uiFont(16));
  if (drawing_.section != nullptr) {
    paintProfile(painter, QRectF(rect()).adjusted(12, 8, -12, -8), drawing_, p);
    return;
  }
  painter.setPen(p.t2);
  painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, message_);
}

}  // namespace vignole
