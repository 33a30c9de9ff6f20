#pragma once
// The look of the HMI: one of two palettes, the type of the mock-ups, icons tinted with the palette's colours.

#include <QFont>
#include <QObject>
#include <QPixmap>
#include <QString>

#include "engine/geometry/expected.h"
#include "report/palette.h"

namespace vignole {

/// Registers Roboto (Debian fonts-roboto-unhinted) and makes it the application's font; DejaVu Sans stands in.
/// The error says which packages to install: without a font every glyph is an empty box. Needs a QGuiApplication.
[[nodiscard]] Expected<void> installFonts();

/// Type of the mock-ups: size in pixels, weight 400, 500 or 700.
[[nodiscard]] QFont uiFont(int pixels, int weight = 400);

/// Which palette is shown; widgets repaint on changed(). Lives as long as the widgets that refer to it.
class Theme : public QObject {
  Q_OBJECT

 public:
  explicit Theme(bool dark = false) : palette_(dark ? &darkPalette() : &lightPalette()) {}

  [[nodiscard]] const Palette& palette() const { return *palette_; }
  [[nodiscard]] bool dark() const { return palette_->dark; }
  void setDark(bool dark);
  /// Style sheet of the standard widgets in this palette.
  [[nodiscard]] QString styleSheet() const;
  /// Icon `name` of resources/icons, in device-independent pixels.
  [[nodiscard]] QPixmap icon(const QString& name, int pixels, const QColor& colour, qreal pixelRatio = 1) const;

 signals:
  void changed();

 private:
  const Palette* palette_;
};

}  // namespace vignole
