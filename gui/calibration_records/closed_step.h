#pragma once
// What stands in the place of a wizard while the line measures: its cameras are needed. Says why and offers to stop.

#include "gui/bridge/workplace.h"
#include "gui/theme/panel.h"

namespace vignole {

class ClosedStep : public Panel {
  Q_OBJECT

 public:
  explicit ClosedStep(Workplace& place, QWidget* parent = nullptr);
  /// `why`: what is needed of the line. In the language of now; call again when it changes.
  void say(const QString& why);

 private:
  QLabel *title_, *words_;
  QPushButton* stopLine_;
};

}  // namespace vignole
