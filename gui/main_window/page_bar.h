#pragma once
// The bar at the foot: a key for each page.

#include <QFrame>
#include <array>

#include "gui/main_window/page.h"
#include "gui/theme/theme.h"

class QHBoxLayout;
class QPushButton;

namespace vignole {

class PageBar : public QFrame {
  Q_OBJECT

 public:
  explicit PageBar(const Theme& theme, QWidget* parent = nullptr);
  void addPage(PageId page);  ///< in the order of their keys
  void setShown(PageId page);
  void setAlarms(std::size_t active);  ///< counted on the key of Alarms
  [[nodiscard]] QPushButton* button(PageId page) const { return pages_[static_cast<std::size_t>(page)]; }

 signals:
  void pageAsked(vignole::PageId page);

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void relabel();

  const Theme& theme_;
  QHBoxLayout* row_;
  std::array<QPushButton*, kPageCount> pages_{};
  PageId shown_ = PageId::Monitor;
  std::size_t alarms_ = 0;
};

}  // namespace vignole
