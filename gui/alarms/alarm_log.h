#pragma once
// The lives of the alarms: as rows of a history, and on disk where there is an archive.

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "engine/alarms/alarm_book.h"
#include "engine/archive/alarm_history.h"

namespace vignole {

class ArchiveReader;

/// Window's thread; what goes to the disk goes there in the reader's.
class AlarmLog {
 public:
  /// `reader`: null where nothing is kept.
  explicit AlarmLog(ArchiveReader* reader) : reader_(reader) {}

  void note(const AlarmEvent& event, const AlarmBook& book, const std::string& rail);
  /// Something worth writing down that is no alarm.
  void noteEvent(EventRecord event);

  /// Newest first, the last few hundred.
  [[nodiscard]] const std::deque<AlarmEvent>& steps() const { return steps_; }
  [[nodiscard]] const std::deque<EventRecord>& events() const { return events_; }
  /// One row an alarm, newest first: those of the archive before this start come after this program's.
  [[nodiscard]] std::vector<AlarmRecord> history() const;
  /// So many of history(), the newest, are of this program.
  [[nodiscard]] std::size_t ofThisStart() const { return alarms_.size(); }
  void setEarlier(std::vector<AlarmRecord> alarms, std::vector<EventRecord> events);

 private:
  void store(std::uint64_t alarm, const AlarmStep& step);

  ArchiveReader* reader_;
  std::deque<AlarmEvent> steps_;
  std::deque<EventRecord> events_;
  std::map<std::uint64_t, AlarmRecord> alarms_;  ///< of this program
  std::vector<AlarmRecord> earlier_;
  /// What the archive calls an alarm; the reader's thread alone looks into it.
  std::shared_ptr<std::map<std::uint64_t, std::string>> uids_ =
      std::make_shared<std::map<std::uint64_t, std::string>>();
  std::uint64_t written_ = 0;
};

}  // namespace vignole
