#pragma once
// A short tour for somebody who has read nothing: a few steps over Monitor, each pointing at one thing.

#include <QWidget>
#include <functional>
#include <vector>

#include "gui/theme/theme.h"

class QLabel;
class QPushButton;

namespace vignole {

/// Covers its parent; the line goes on below it. Esc leaves, Enter or Right goes on.
class Tour : public QWidget {
  Q_OBJECT

 public:
  /// What a step points at; text is asked for anew when the language changes.
  struct Step {
    const QWidget* target;
    std::function<QString()> title, text;
  };
  Tour(const Theme& theme, std::vector<Step> steps, QWidget* parent);
  [[nodiscard]] std::size_t step() const { return at_; }
  void next();
  void leave();

 signals:
  void left();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void show(std::size_t step);
  void layOut();
  [[nodiscard]] QRect targetRect() const;

  const Theme& theme_;
  std::vector<Step> steps_;
  std::size_t at_ = 0;
  QWidget* box_;
  QLabel *title_, *text_, *count_;
  QPushButton *next_, *leave_;
};

}  // namespace vignole
