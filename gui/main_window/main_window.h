#pragma once
// The window: header, page, alarm line, page bar; pulls from the line on a display tick and owns the keys.

#include <QDateTime>
#include <QMainWindow>
#include <QTimer>
#include <functional>

#include "gui/bridge/event_loop_watchdog.h"
#include "gui/bridge/line.h"
#include "gui/theme/theme.h"

namespace vignole {

class AlarmLine;
class HeaderBar;
class MonitorPage;
class PageBar;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  using Clock = std::function<QDateTime()>;

  /// Line and theme outlive the window. The clock is handed in so that a test can hold it still.
  MainWindow(
      Line& line, Theme& theme, const Clock& clock = [] { return QDateTime::currentDateTime(); });

  void startTicking();
  /// One display tick: pulls and shows. Public for tests and pictures.
  void tick(PullDetail detail);

  [[nodiscard]] MonitorPage& monitor() { return *monitor_; }
  [[nodiscard]] HeaderBar& header() { return *header_; }
  [[nodiscard]] AlarmLine& alarmLine() { return *alarm_; }
  [[nodiscard]] const EventLoopWatchdog& watchdog() const { return watchdog_; }

 protected:
  void closeEvent(QCloseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void bindKeys();
  void bindKey(const QKeySequence& key, std::function<void()> action);
  void toggleRun();
  void escape();

  Line& line_;
  Theme& theme_;
  EventLoopWatchdog watchdog_;
  QTimer ticks_, seconds_;
  int tickNumber_ = 0;
  HeaderBar* header_;
  MonitorPage* monitor_;
  AlarmLine* alarm_;
  PageBar* pages_;
};

}  // namespace vignole
