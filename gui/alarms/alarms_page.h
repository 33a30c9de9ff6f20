#pragma once
// Alarms: what is wrong now with cause, consequence and action; what was; what is shelved and until when; how many
// come.

#include "gui/alarms/alarm_watch.h"
#include "gui/main_window/page.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QScrollArea;
class QTableWidget;
class QVBoxLayout;

namespace vignole {

class Panel;

class AlarmsPage : public Page {
  Q_OBJECT

 public:
  AlarmsPage(Workplace& place, AlarmWatch& watch, QWidget* parent = nullptr);
  void showLine(const LineSnapshot& line, PullDetail detail) override;

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void retranslate();
  void refresh();
  void showActive();
  void showHistory();
  void showShelved();
  void showRates();
  void shelve();
  void exportHistory();
  [[nodiscard]] QWidget* card(const Alarm& alarm);

  Workplace& place_;
  AlarmWatch& watch_;
  Panel *active_, *history_, *rate_, *shelved_, *shelving_;
  QVBoxLayout* cards_;
  QLabel *quiet_, *tenMinutes_, *hour_, *day_, *flood_, *limit_;
  QTableWidget *historyTable_, *shelvedTable_;
  QComboBox *what_, *minutes_;
  QLineEdit* reason_;
  QPushButton *acknowledge_, *export_, *shelveButton_, *unshelve_;
  QString shownActive_;
};

}  // namespace vignole
