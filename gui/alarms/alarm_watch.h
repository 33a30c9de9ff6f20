#pragma once
// From what the line says to alarms: one rail out of tolerance is one alarm, however many dimensions; a camera that is
// lost is one of its own. Keeps them, and writes their lives into the archive where there is one.

#include <QObject>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "engine/alarms/alarm_book.h"
#include "gui/alarms/alarm_log.h"
#include "gui/bridge/workplace.h"

namespace vignole {

class ArchiveReader;

/// Window's thread.
class AlarmWatch : public QObject {
  Q_OBJECT

 public:
  using Clock = std::function<AlarmTime()>;
  explicit AlarmWatch(Workplace& place, Clock clock = {}, QObject* parent = nullptr);
  ~AlarmWatch() override;

  /// A few times a second.
  void follow(const LineSnapshot& line);
  /// The worst turn of the window's event loop since the last call.
  void observeWindow(double worstMs);

  [[nodiscard]] const AlarmBook& book() const { return book_; }
  [[nodiscard]] AlarmRates rates() const { return book_.rates(clock_()); }
  [[nodiscard]] AlarmTime now() const { return clock_(); }
  [[nodiscard]] double runningS() const;  ///< since this watch began
  [[nodiscard]] const AlarmLog& log() const { return *log_; }

  void acknowledge(std::uint64_t alarm);
  void acknowledge(const std::vector<std::uint64_t>& alarms);
  void acknowledgeAll();
  [[nodiscard]] Expected<void> shelve(const AlarmKey& key, const std::string& reason, AlarmDuration time);
  [[nodiscard]] Expected<void> unshelve(const AlarmKey& key);

 signals:
  void changed();  ///< of what is active, shelved or written down

 private:
  void followRail(const LineSnapshot& line);
  void followLine(const LineSnapshot& line);
  void followTriggers(const LineSnapshot& line);
  void followDisk();
  void followEvents(const LineSnapshot& line);
  void lookBack();  ///< at what the archive knows from before
  void take();
  [[nodiscard]] std::string who() const;

  Workplace& place_;
  Clock clock_;
  AlarmBook book_;
  AlarmTime began_{};
  std::string rail_;  ///< source of the alarms of the rail that passes
  std::array<bool, kCameraCount> lost_{};
  bool unmeasured_ = false;
  TriggerLedger before_;  ///< when shares were last taken
  AlarmTime diskAsked_{};
  std::optional<LineState> state_;
  std::uint64_t railsPassed_ = 0;
  QString user_;
  std::unique_ptr<ArchiveReader> archive_;
  std::unique_ptr<AlarmLog> log_;
};

}  // namespace vignole
