#include "gui/theme/state_icon.h"

#include <QPainter>
#include <QPixmap>

namespace vignole {

QIcon stateIcon(StateSymbol symbol, const Palette& palette) {
  QPixmap pixmap(40, 40);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  paintSymbol(painter, QRectF(2, 2, 36, 36), symbol, palette);
  return pixmap;
}

}  // namespace vignole
