#pragma once
// The colour tokens of the two themes (light grey, dark), shared by the HMI's widgets, the pictures and the pages.

#include <QColor>
#include <array>

namespace vignole {

struct Palette {
  bool dark = false;
  QColor bg, panel, panel2, head, line, line2, chan;  ///< grounds and lines
  QColor t1, t2, t3;                                  ///< text: values, labels, notes (t3 is also "good")
  QColor accent, accentSoft, onAccent;
  QColor out, onOut, near, onNear, nearInk, invalid;  ///< states; never alone, always with a symbol and a word
  QColor outSoft, nearSoft, invalidSoft;
  QColor steel, model;
  std::array<QColor, 4> camera;
};

[[nodiscard]] const Palette& lightPalette();
[[nodiscard]] const Palette& darkPalette();

}  // namespace vignole
