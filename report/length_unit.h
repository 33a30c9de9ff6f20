#pragma once
// Lengths as people read them: what is stored and computed stays in mm.

namespace vignole {

enum class LengthUnit { Millimetre, Inch };

inline constexpr double kMmPerInch = 25.4;
[[nodiscard]] constexpr double inUnit(double mm, LengthUnit unit) {
  return unit == LengthUnit::Inch ? mm / kMmPerInch : mm;
}
/// Of a value that has so many decimals in mm: one more in inches, so that nothing is lost.
[[nodiscard]] constexpr int decimalsIn(LengthUnit unit, int ofMm) { return unit == LengthUnit::Inch ? ofMm + 1 : ofMm; }
[[nodiscard]] constexpr const char* unitName(LengthUnit unit) { return unit == LengthUnit::Inch ? "in" : "mm"; }

}  // namespace vignole
