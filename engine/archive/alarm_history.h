#pragma once
// Alarms and events on disk. When an alarm is raised, cleared or may be shelved is decided elsewhere (engine/alarms).

#include <optional>
#include <string>
#include <vector>

#include "engine/archive/archive.h"
#include "engine/archive/rail_record.h"

namespace vignole {

struct AlarmRecord {
  std::string uid;           ///< given by the archive when it is first stored
  std::string rule, source;  ///< which rule raised it, of what: "camera.lost" of "camera 3"
  int priority = 3;          ///< 1 (measurement invalid) .. 3
  std::string cause, consequence, action, details;
  std::string rail;  ///< id of the rail that passed, if any
  TimeUs raisedUs = 0;
  std::optional<TimeUs> clearedUs, acknowledgedUs, shelvedUntilUs;
  std::string acknowledgedBy, shelvedBy, shelvingReason;
};

/// One step in the life of an alarm: raised, cleared, acknowledged, shelved ...
struct AlarmStep {
  std::string alarm;  ///< uid; empty for what concerns all, as a flood
  TimeUs timeUs = 0;
  std::string kind, who, text;
};

/// What is worth writing down and is no alarm.
struct EventRecord {
  TimeUs timeUs = 0;
  std::string source, text, user;
};

struct AlarmQuery {
  std::optional<TimeUs> fromUs, toUs;  ///< raised at or after, raised before
  bool activeOnly = false;             ///< not cleared yet
  std::size_t limit = 1000;
};

class AlarmHistory {
 public:
  explicit AlarmHistory(const Archive& archive);
  /// New, or what has changed of one that is stored; returns its uid.
  [[nodiscard]] Expected<std::string> save(const AlarmRecord& alarm);
  [[nodiscard]] Expected<std::vector<AlarmRecord>> alarms(const AlarmQuery& query = {}) const;  ///< newest first
  [[nodiscard]] Expected<void> addStep(const AlarmStep& step);
  [[nodiscard]] Expected<std::vector<AlarmStep>> steps(const std::string& alarmUid) const;  ///< oldest first
  [[nodiscard]] Expected<void> addEvent(const EventRecord& event);
  [[nodiscard]] Expected<std::vector<EventRecord>> events(std::optional<TimeUs> fromUs = {},
                                                          std::optional<TimeUs> toUs = {},
                                                          std::size_t limit = 1000) const;  ///< newest first

 private:
  std::shared_ptr<Database> database_;
};

}  // namespace vignole
