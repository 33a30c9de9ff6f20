#include "gui/monitor/profile_canvas.h"

#include <QPainter>

#include "gui/theme/inscription.h"
#include "report/dimension_text.h"

namespace vignole {

ProfileCanvas::ProfileCanvas(const Theme& theme, const Recipe& recipe, QWidget* parent)
    : QWidget(parent), theme_(theme) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  retranslate();
  drawing_.section = &recipe.section;
  drawing_.limits = &recipe.limits;
  drawing_.parameters = &recipe.parameters;
  connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void ProfileCanvas::show(const LineSnapshot& line) {
  const bool held = line.held();
  std::string note;
  if (held)
    note = tr("last profile at %1 m, %2 ago")
               .arg(numberText(line.latest->profile.positionMm / 1000, 2), age(line.ageS))
               .toStdString();
  if (line.latest == result_ && held == drawing_.held && note == drawing_.heldNote) return;
  result_ = line.latest;
  drawing_.held = held;
  drawing_.heldNote = note;
  drawing_.profile = result_ ? &result_->profile : nullptr;
  drawing_.registration = result_ ? &result_->registration : nullptr;
  drawing_.measurement = result_ ? &result_->measurement : nullptr;
  update();
}

void ProfileCanvas::setUnit(LengthUnit unit) {
  drawing_.unit = unit;
  update();
}

void ProfileCanvas::retranslate() {
  setAccessibleName(tr("Measured profile over the section"));
  update();
}

void ProfileCanvas::setView(ProfileView view) {
  drawing_.view = view;
  update();
}

void ProfileCanvas::setMagnification(double magnification) {
  drawing_.magnification = magnification;
  update();
}

void ProfileCanvas::setByCamera(bool byCamera) {
  drawing_.byCamera = byCamera;
  update();
}

void ProfileCanvas::setBeforeRegistration(bool before) {
  drawing_.beforeRegistration = before;
  update();
}

void ProfileCanvas::setSelected(std::optional<Dimension> dimension) {
  if (drawing_.selected == dimension) return;
  drawing_.selected = dimension;
  update();
}

void ProfileCanvas::paintEvent(QPaintEvent* /*event*/) {
  const Palette& p = theme_.palette();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), p.panel2);
  painter.setFont(uiFont(16));
  paintProfile(painter, QRectF(rect()), drawing_, p);
}

}  // namespace vignole
