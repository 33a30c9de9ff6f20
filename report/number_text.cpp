#include "report/number_text.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace vignole {

namespace {

std::string withMinus(const char* text) {
  std::string out;
  for (; *text != '\0'; ++text) {
    if (*text == '-')
      out += "\u2212";
    else
      out += *text;
  }
  return out;
}

}  // namespace

std::string fixedText(double value, int decimals) {
  if (!std::isfinite(value)) return "\u2013";
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.*f", decimals, value);
  return withMinus(buffer.data());
}

std::string significantText(double value, int digits) {
  if (!std::isfinite(value)) return "\u2013";
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value);
  return withMinus(buffer.data());
}

}  // namespace vignole
