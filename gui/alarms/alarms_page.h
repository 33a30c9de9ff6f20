#pragma once
// Alarms: what is wrong now with cause, consequence and action; what was; what is shelved and until when; how many
// come.

#include "gui/alarms/alarm_watch.h"
#include "gui/main_window/page.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;
class QVBoxLayout;

namespace vignole {

class AlarmHistoryPanel;
class Panel;
class RateChart;

class AlarmsPage : public Page {
  Q_OBJECT

 public:
  AlarmsPage(Workplace& place, AlarmWatch& watch, QWidget* parent = nullptr);
  void showLine(const LineSnapshot& line, PullDetail detail) override;

 protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void retranslate();
  void refresh();
  void showActive();
  void showShelved();
  void showRates();
  void shelve();
  void showHealth();
  void setWhole(bool whole);  ///< with chart and health
  void makeRate();
  void makeShelving();
  void makeHealth();

  Workplace& place_;
  AlarmWatch& watch_;
  Panel *active_, *rate_, *shelved_, *shelving_, *healthPanel_;
  AlarmHistoryPanel* history_;
  RateChart* chart_;
  QVBoxLayout* cards_;
  QLabel *quiet_, *tenMinutes_, *hour_, *day_, *words_[3], *flood_, *limit_;
  QTableWidget *shelvedTable_, *health_;
  QComboBox *what_, *minutes_;
  QLineEdit* reason_;
  QPushButton *acknowledge_, *shelveButton_, *unshelve_;
  QString shownActive_;
  int ticks_ = 0;
};

}  // namespace vignole
