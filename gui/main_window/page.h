#pragma once
// One of the ten pages behind F1 .. F10.

#include <QWidget>
#include <array>

#include "gui/bridge/line.h"

namespace vignole {

/// In the order of their keys.
enum class PageId { Monitor, Stripes, Charts, Rails, Calibration, Recipes, Quality, Alarms, Diagnostics, Settings };
inline constexpr int kPageCount = 10;

/// Word (translated), icon of resources/icons and the word of `--page`.
struct PageName {
  const char* word;
  const char* icon;
  const char* option;
};
[[nodiscard]] const PageName& pageName(PageId page);
[[nodiscard]] QString pageWord(PageId page);

/// Keys of a page are shortcuts of its own, with Qt::WidgetWithChildrenShortcut. Text is set in a function that
/// changeEvent(QEvent::LanguageChange) calls again.
class Page : public QWidget {
  Q_OBJECT

 public:
  using QWidget::QWidget;
  /// On every display tick while the page is the one that is shown; figures that are read only with Everything, five
  /// times a second.
  virtual void showLine(const LineSnapshot& line, PullDetail detail) = 0;
};

}  // namespace vignole
