#pragma once
// What happened: the alarms that came and went, one a row, and apart from them the events. Also those of earlier
// starts, where an archive keeps them.

#include "gui/alarms/alarm_watch.h"
#include "gui/theme/panel.h"

class QButtonGroup;
class QTableWidget;

namespace vignole {

class AlarmHistoryPanel : public Panel {
  Q_OBJECT

 public:
  AlarmHistoryPanel(const Theme& theme, AlarmWatch& watch, QWidget* parent = nullptr);
  void refresh();
  void retranslate();
  /// As CSV, of what is shown; the error says why not.
  [[nodiscard]] Expected<void> exportTo(const QString& file) const;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showAlarms();
  void showEvents();
  void shareWidth();
  void askAndExport();

  const Theme& theme_;
  AlarmWatch& watch_;
  QButtonGroup* which_;
  QTableWidget *alarms_, *events_;
  QPushButton* export_;
};

}  // namespace vignole
