#pragma once
// The bar at the foot: the pages there are, at the left; commands with their keys, at the right.

#include <QFrame>

#include "gui/theme/theme.h"

class QPushButton;

namespace vignole {

class PageBar : public QFrame {
  Q_OBJECT

 public:
  explicit PageBar(const Theme& theme, QWidget* parent = nullptr);
  void setRunning(bool running);
  void setPipelineShown(bool shown);
  void setFullView(bool full);

 signals:
  void monitorAsked();
  void pipelineAsked();
  void fullViewAsked();
  void runAsked();

 private:
  QPushButton* add(const QString& key, const QString& word, const QString& icon, void (PageBar::*signal)());
  void label(QPushButton* button, const QString& key, const QString& word, const QString& icon);
  void relabel();

  const Theme& theme_;
  QPushButton *monitor_, *pipeline_, *full_, *run_;
  bool running_ = false;
};

}  // namespace vignole
