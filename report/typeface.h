#pragma once
// The one typeface of screens and pages: Roboto, whose digits are tabular as they stand (mockups/README.md).

#include <QFont>

namespace vignole {

/// Roboto, or DejaVu Sans where Roboto is not installed; never a family without glyphs. Needs a QGuiApplication.
[[nodiscard]] QFont typeface(double sizePx, QFont::Weight weight = QFont::Normal);

}  // namespace vignole
