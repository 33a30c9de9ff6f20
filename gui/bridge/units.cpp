#include "gui/bridge/units.h"

namespace vignole {

namespace {
constexpr double kMmPerInch = 25.4;
}

void Units::setLength(Length length) {
  if (length == length_) return;
  length_ = length;
  emit changed();
}

QString Units::name() const { return length_ == Length::Millimetre ? QStringLiteral("mm") : QStringLiteral("in"); }
double Units::shown(double mm) const { return length_ == Length::Millimetre ? mm : mm / kMmPerInch; }
int Units::decimals(int ofMm) const { return length_ == Length::Millimetre ? ofMm : ofMm + 1; }
double Units::mmFrom(double shown) const { return length_ == Length::Millimetre ? shown : shown * kMmPerInch; }

}  // namespace vignole
