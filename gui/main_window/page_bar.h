#pragma once
// The bar at the foot: the pages there are, at the left; commands with their keys, at the right.

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
  void setRunning(bool running);
  void setPipelineShown(bool shown);
  void setFullView(bool full);

 signals:
  void pageAsked(PageId page);
  void pipelineAsked();
  void fullViewAsked();
  void runAsked();

 private:
  QPushButton* add(const QString& key, const QString& word, const QString& icon, void (PageBar::*signal)());
  void label(QPushButton* button, const QString& key, const QString& word, const QString& icon);
  void relabel();

  const Theme& theme_;
  QHBoxLayout* pageRow_;
  std::array<QPushButton*, kPageCount> pages_{};
  PageId shown_ = PageId::Monitor;
  QPushButton *pipeline_, *full_, *run_;
  bool running_ = false;
};

}  // namespace vignole
