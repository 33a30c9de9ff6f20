#pragma once
// Lengths as they are shown: what is stored and computed stays in mm.

#include <QObject>
#include <QString>

#include "report/length_unit.h"

namespace vignole {

class Units : public QObject {
  Q_OBJECT

 public:
  using Length = LengthUnit;
  [[nodiscard]] Length length() const { return length_; }
  void setLength(Length length);
  [[nodiscard]] QString name() const;               ///< "mm", "in"
  [[nodiscard]] double shown(double mm) const;      ///< in the unit
  [[nodiscard]] int decimals(int ofMm) const;       ///< so that nothing is lost: one more in inches
  [[nodiscard]] double mmFrom(double shown) const;  ///< of what a person entered

 signals:
  void changed();

 private:
  Length length_ = Length::Millimetre;
};

}  // namespace vignole
