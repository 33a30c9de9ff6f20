#pragma once
// The steps of a wizard: done, at hand, ahead.

#include <QLabel>
#include <QWidget>
#include <vector>

#include "gui/theme/theme.h"

namespace vignole {

class StepList : public QWidget {
  Q_OBJECT

 public:
  struct Step {
    QString title, note;
    QString number;  ///< in the circle; empty: none
  };
  explicit StepList(const Theme& theme, QWidget* parent = nullptr);
  void show(std::vector<Step> steps, int current);
  [[nodiscard]] int current() const { return current_; }
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  const Theme& theme_;
  std::vector<Step> steps_;
  int current_ = 0;
};

/// A wrapped label gets room for all its lines at its present width: nested layouts do not ask for it.
void giveRoom(QLabel& wrapped);

}  // namespace vignole
