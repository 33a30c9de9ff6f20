#pragma once
#include <QLayout>
#include <QSize>
#include <QWidget>
#include <algorithm>

namespace vignole::test {

/// What a widget needs at the width it has: words that wrap need less height the wider they stand.
inline QSize leastSize(const QWidget& widget) {
  QSize least = widget.minimumSizeHint();
  if (const QLayout* layout = widget.layout(); layout != nullptr && layout->hasHeightForWidth())
    least.setHeight(std::min(least.height(), layout->minimumHeightForWidth(widget.width())));
  return least;
}

}  // namespace vignole::test
