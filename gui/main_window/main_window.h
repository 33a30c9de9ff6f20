#pragma once
// The window: header, page, alarm line, page bar; pulls from the line on a display tick and owns the keys.

#include <QDateTime>
#include <QMainWindow>
#include <QMessageBox>
#include <QPointer>
#include <QTimer>
#include <array>
#include <chrono>
#include <functional>

#include "gui/bridge/event_loop_watchdog.h"
#include "gui/bridge/workplace.h"
#include "gui/main_window/page.h"
#include "gui/main_window/tour.h"

class QStackedWidget;

namespace vignole {

class AlarmLine;
class AlarmWatch;
class HeaderBar;
class MonitorPage;
class PageBar;
class SettingsPage;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  using Clock = std::function<QDateTime()>;

  /// The workplace outlives the window. The clock is handed in so that a test can hold it still.
  explicit MainWindow(
      Workplace& place, const Clock& clock = [] { return QDateTime::currentDateTime(); });

  void startTicking();
  /// So long without a key or a touch, and a person who signed in is taken to have gone.
  void setIdleReturn(std::chrono::milliseconds time) { idle_.setInterval(time); }
  /// One display tick: pulls and shows. Public for tests and pictures.
  void tick(PullDetail detail);

  void showPage(PageId page);  ///< nothing if there is no such page
  [[nodiscard]] PageId page() const { return shown_; }
  [[nodiscard]] Page* page(PageId page) const { return all_[static_cast<std::size_t>(page)]; }
  [[nodiscard]] MonitorPage& monitor() { return *monitor_; }
  [[nodiscard]] HeaderBar& header() { return *header_; }
  [[nodiscard]] AlarmWatch& alarms() { return *alarms_; }
  [[nodiscard]] AlarmLine& alarmLine() { return *alarm_; }
  /// A few steps over Monitor; `left` of it is told by tourLeft().
  void startTour();
  [[nodiscard]] Tour* tour() const { return tour_; }
  /// Asked while a rail is measured; null: nothing is.
  [[nodiscard]] QMessageBox* question() const { return question_; }
  [[nodiscard]] const EventLoopWatchdog& watchdog() const { return watchdog_; }

 signals:
  void tourLeft();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void addPages();
  void add(PageId page, Page* widget);
  void bindKeys();
  void bindKey(const QKeySequence& key, std::function<void()> action);
  void toggleRun();
  void signInOrOut();
  void askBeforeClosing();

  Workplace& place_;
  Line& line_;
  Theme& theme_;
  EventLoopWatchdog watchdog_;
  QTimer ticks_, seconds_;
  QTimer idle_;  ///< until a person who signed in is taken to have gone
  int tickNumber_ = 0;
  /// Closing: at once where a person said so, or when the rail under way has passed.
  enum class Closing { No, AfterRail, Now } closing_ = Closing::No;
  QPointer<QMessageBox> question_;
  HeaderBar* header_;
  QStackedWidget* stack_;
  std::array<Page*, kPageCount> all_{};
  PageId shown_ = PageId::Monitor;
  MonitorPage* monitor_;
  SettingsPage* settings_;
  AlarmLine* alarm_;
  AlarmWatch* alarms_;
  PageBar* pages_;
  QPointer<Tour> tour_;
};

}  // namespace vignole
