#include "gui/monitor/verdict_panel.h"

#include <QFontMetricsF>
#include <QPainter>

#include "gui/theme/inscription.h"

namespace vignole {

namespace {

struct Ground {
  QColor fill, edge;
};

Ground groundOf(StateSymbol symbol, const Palette& p) {
  switch (symbol) {
    case StateSymbol::Out:
      return {p.outSoft, p.out};
    case StateSymbol::Near:
      return {p.nearSoft, p.near};
    case StateSymbol::NotMeasured:
      return {p.invalidSoft, p.invalid};
    default:
      return {p.panel, p.line};
  }
}

}  // namespace

VerdictPanel::VerdictPanel(const Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme) {
  connect(&theme_, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void VerdictPanel::show(const LineSnapshot& line, LengthUnit unit) {
  verdict_ = railVerdict(line, unit);
  trust_ = gaugeTrust(line);
  simulation_ = line.simulation;
  setAccessibleName(tr("Verdict: %1, %2. Gauge: %3").arg(verdict_.word, verdict_.sentence, trust_.word));
  update();
}

void VerdictPanel::paintEvent(QPaintEvent* /*event*/) {
  const Palette& p = theme_.palette();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Ground ground = verdict_.held && verdict_.symbol != StateSymbol::NotMeasured ? Ground{p.panel, p.line}
                                                                                     : groundOf(verdict_.symbol, p);
  const bool abnormal = ground.fill != p.panel;
  painter.setPen(QPen(ground.edge, abnormal ? 2 : 1));
  painter.setBrush(ground.fill);
  const double inset = abnormal ? 1 : 0.5;
  painter.drawRoundedRect(QRectF(rect()).adjusted(inset, inset, -inset, -inset), 4, 4);
  if (abnormal) painter.fillRect(QRectF(0, 0, 12, height()), ground.edge);

  const bool small = height() < 110;
  const int wordPixels = small ? 48 : 64;
  const double trustLeft = width() - (width() < 900 ? 250.0 : 282.0);
  const double symbolSide = small ? 60 : 80;
  paintSymbol(painter, QRectF(small ? 24 : 26, (height() - symbolSide) / 2, symbolSide, symbolSide),
              verdict_.held && verdict_.symbol != StateSymbol::NotMeasured ? StateSymbol::Held : verdict_.symbol, p);
  const double left = small ? 98 : 124;
  painter.setPen(verdict_.held && verdict_.symbol != StateSymbol::NotMeasured ? p.t3 : p.t1);
  QFont word = uiFont(wordPixels, 700);
  while (word.pixelSize() > 30 && QFontMetricsF(word).horizontalAdvance(verdict_.word) > trustLeft - left - 16)
    word.setPixelSize(word.pixelSize() - 2);
  painter.setFont(word);
  painter.drawText(QPointF(left - 2, height() * 0.55), verdict_.word);
  painter.setPen(p.t1);
  paintInscription(painter, left, height() * 0.84, uiFont(small ? 18 : 22), verdict_.sentence, trustLeft - left - 14);

  painter.setPen(QPen(abnormal ? ground.edge : p.line, 1));
  painter.drawLine(QPointF(trustLeft, 16), QPointF(trustLeft, height() - 16));
  paintTrust(painter, trustLeft + 14);
}

void VerdictPanel::paintTrust(QPainter& painter, double left) const {
  const Palette& p = theme_.palette();
  const bool small = height() < 110;
  const double room = width() - left - 12;
  const double top = height() / 2.0 - (small ? 34 : 40);
  paintSymbol(painter, QRectF(left, top, 24, 24), trust_.symbol, p);
  painter.setPen(p.t1);
  const QString trust = tr("Gauge: %1").arg(trust_.word.toLower());
  QFont trustFont = uiFont(small ? 20 : 24, 500);
  while (trustFont.pixelSize() > 16 && QFontMetricsF(trustFont).horizontalAdvance(trust) > room - 34)
    trustFont.setPixelSize(trustFont.pixelSize() - 1);
  paintInscription(painter, left + 34, top + 20, trustFont, trust, room - 34);
  painter.setPen(p.t2);
  paintInscription(painter, left, top + (small ? 42 : 50), uiFont(small ? 15 : 16), trust_.cameras, room);
  paintInscription(painter, left, top + (small ? 62 : 74), uiFont(small ? 15 : 16),
                   simulation_ ? tr("SIMULATION, %1").arg(trust_.provenance) : trust_.provenance, room);
}

}  // namespace vignole
