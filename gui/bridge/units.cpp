#include "gui/bridge/units.h"

namespace vignole {

void Units::setLength(Length length) {
  if (length == length_) return;
  length_ = length;
  emit changed();
}

QString Units::name() const { return QString::fromLatin1(unitName(length_)); }
double Units::shown(double mm) const { return inUnit(mm, length_); }
int Units::decimals(int ofMm) const { return decimalsIn(length_, ofMm); }
double Units::mmFrom(double shown) const { return shown * kMmPerInch / inUnit(kMmPerInch, length_); }

}  // namespace vignole
