#pragma once
// From what the line says to alarms: one rail out of tolerance is one alarm, however many dimensions; a camera that is
// lost is one of its own. Keeps them, and writes their lives into the archive where there is one.

#include <QObject>
#include <deque>
#include <functional>
#include <memory>
#include <string>

#include "engine/alarms/alarm_book.h"
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

  [[nodiscard]] const AlarmBook& book() const { return book_; }
  [[nodiscard]] AlarmRates rates() const { return book_.rates(clock_()); }
  [[nodiscard]] AlarmTime now() const { return clock_(); }
  /// Newest first, the last few hundred.
  [[nodiscard]] const std::deque<AlarmEvent>& events() const { return events_; }

  void acknowledge(std::uint64_t alarm);
  void acknowledgeAll();
  [[nodiscard]] Expected<void> shelve(const AlarmKey& key, const std::string& reason, AlarmDuration time);
  [[nodiscard]] Expected<void> unshelve(const AlarmKey& key);

 signals:
  void changed();  ///< of what is active, shelved or written down

 private:
  void followRail(const LineSnapshot& line);
  void followLine(const LineSnapshot& line);
  void take();
  void write(const AlarmEvent& event);
  [[nodiscard]] std::string who() const;

  Workplace& place_;
  Clock clock_;
  AlarmBook book_;
  std::string rail_;  ///< source of the alarms of the rail that passes
  std::array<bool, kCameraCount> lost_{};
  std::deque<AlarmEvent> events_;
  std::unique_ptr<ArchiveReader> archive_;
  std::uint64_t written_ = 0;
};

}  // namespace vignole
