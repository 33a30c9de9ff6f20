#pragma once
// Numbers for tables of reports, as plain text.

#include <string>

namespace vignole {

/// With so many decimals and a real minus sign; an en dash where it is not finite.
[[nodiscard]] std::string fixedText(double value, int decimals);
/// With so many significant digits, in powers of ten where it is very small or large.
[[nodiscard]] std::string significantText(double value, int digits);

}  // namespace vignole
