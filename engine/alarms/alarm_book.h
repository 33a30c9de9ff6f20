#pragma once
// The alarms of a line: which are on, acknowledged, shelved; what happened; how many come. States after ISA-18.2
// (IEC 62682). Deterministic: every call brings its time. Not for several threads at once.

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "engine/alarms/alarm_signal.h"
#include "engine/geometry/expected.h"

namespace vignole {

enum class AlarmState {
  Normal,                 ///< off, nothing to do
  Unacknowledged,         ///< on, nobody has seen it
  Acknowledged,           ///< on, somebody has
  ReturnedUnacknowledged  ///< off again before anybody saw it
};
[[nodiscard]] std::string_view name(AlarmState state);

/// "camera.lost" of "camera 3", "rail.out-of-tolerance" of the rail: one thing that can be wrong, one alarm, whatever
/// reports it and how often.
struct AlarmKey {
  std::string rule, source;
  bool operator==(const AlarmKey&) const = default;
  bool operator<(const AlarmKey& other) const { return std::tie(rule, source) < std::tie(other.rule, other.source); }
};

struct Shelf {
  AlarmTime from{}, until{};
  std::string by, reason;
};

struct Alarm {
  std::uint64_t id = 0;  ///< of this occurrence; grows
  AlarmKey key;
  AlarmPriority priority = AlarmPriority::Degraded;
  AlarmState state = AlarmState::Normal;
  AlarmTime raised{};  ///< after the on-delay
  std::optional<AlarmTime> cleared;
  std::optional<AlarmTime> acknowledged;
  std::string acknowledgedBy;
  std::vector<std::string> details;  ///< "HW 72.9 mm at 12.3 m", in the order in which they came, each once
  std::optional<double> value;       ///< latest, filtered
  std::optional<Shelf> shelf;        ///< hidden until then
  bool chattering = false;           ///< comes and goes
  bool stale = false;                ///< on for longer than a day
};

enum class AlarmEventKind { Raised, Cleared, Acknowledged, Shelved, Unshelved, ShelfRanOut, FloodBegan, FloodEnded };
[[nodiscard]] std::string_view name(AlarmEventKind kind);

/// For the history; who keeps it takes it with takeEvents().
struct AlarmEvent {
  AlarmTime time{};
  AlarmEventKind kind = AlarmEventKind::Raised;
  std::uint64_t alarm = 0;  ///< id; 0 for a flood
  AlarmKey key;
  AlarmPriority priority = AlarmPriority::Degraded;
  std::string who, text;  ///< text: details, or the reason of a shelving
};

/// How many were raised (shelved ones not counted).
struct AlarmRates {
  std::size_t tenMinutes = 0, hour = 0, day = 0;
  bool flood = false;
};

struct AlarmBookSettings {
  AlarmDuration longestShelf = std::chrono::hours(8);  ///< a shift: nothing is switched off without end
  std::size_t floodAbove = 10;                         ///< raised in ten minutes
  std::size_t floodEndsBelow = 5;                      ///< raised in ten minutes
  std::size_t chatterCount = 3;                        ///< raised so often in `chatterWindow`
  AlarmDuration chatterWindow = std::chrono::minutes(1);
  AlarmDuration staleAfter = std::chrono::hours(24);
  std::size_t maxDetails = 100;  ///< per alarm; further ones are counted by the last
};

/// Alarms of a flood, shown as one line.
struct AlarmGroup {
  std::string rule;
  AlarmPriority priority = AlarmPriority::Degraded;
  std::vector<std::uint64_t> alarms;
  std::size_t unacknowledged = 0;
};

class AlarmBook {
 public:
  /// Rules that checkAlarmRules refuses are refused here too.
  [[nodiscard]] static Expected<AlarmBook> create(std::vector<AlarmRule> rules = standardAlarmRules(),
                                                  const AlarmBookSettings& settings = {});

  /// A value of a rule with a limit. An unknown rule is an error of ours.
  void observe(const AlarmKey& key, double value, AlarmTime now, const std::string& detail = {});
  /// A condition that is known to be on or off. `detail` is added while it is on.
  void set(const AlarmKey& key, bool on, AlarmTime now, const std::string& detail = {});
  /// Delays and shelves run out, rates fall. Call at least once a second.
  void advance(AlarmTime now);

  [[nodiscard]] Expected<void> acknowledge(std::uint64_t alarm, const std::string& who, AlarmTime now);
  /// All that are given ("the page"); those that need none are passed over.
  void acknowledge(const std::vector<std::uint64_t>& alarms, const std::string& who, AlarmTime now);

  /// Hides an alarm of this key, whether it is on or not, until the time is up: then it is raised anew if its
  /// condition is still there. Needs a reason and a time of at most longestShelf.
  [[nodiscard]] Expected<void> shelve(const AlarmKey& key, const std::string& who, const std::string& reason,
                                      AlarmDuration time, AlarmTime now);
  [[nodiscard]] Expected<void> unshelve(const AlarmKey& key, const std::string& who, AlarmTime now);

  /// What is shown: not normal and not shelved; unacknowledged first, then by priority, then the newest.
  [[nodiscard]] std::vector<Alarm> active() const;
  [[nodiscard]] std::vector<Alarm> shelved() const;
  /// The same by rule, for a flood; the most urgent group first.
  [[nodiscard]] std::vector<AlarmGroup> groups() const;
  /// Of what is on: whether the horn should sound, the lamp light.
  [[nodiscard]] std::optional<AlarmPriority> mostUrgent() const;
  [[nodiscard]] AlarmRates rates(AlarmTime now) const;
  [[nodiscard]] const AlarmRule* rule(std::string_view id) const;
  [[nodiscard]] const std::vector<AlarmRule>& rules() const { return *rules_; }
  /// Conditions that are remembered; what is over and seen is forgotten.
  [[nodiscard]] std::size_t tracked() const { return entries_.size(); }
  /// Since the last call, in order.
  [[nodiscard]] std::vector<AlarmEvent> takeEvents();

 private:
  struct Entry {
    explicit Entry(const AlarmRule& alarmRule) : rule(&alarmRule), signal(alarmRule) {}
    const AlarmRule* rule;
    AlarmSignal signal;
    Alarm alarm;
    bool seenOn = false;               ///< state of the signal when it was last followed
    std::deque<AlarmTime> raisings;    ///< latest, for chattering
    std::vector<std::string> waiting;  ///< details that came before the delay was over
  };

  AlarmBook(std::vector<AlarmRule> rules, const AlarmBookSettings& settings);
  Entry& entry(const AlarmKey& key);
  void addDetail(Entry& entry, const std::string& detail) const;
  void catchUp(Entry& entry, AlarmTime now);
  void follow(Entry& entry, AlarmTime now);
  void raise(Entry& entry, AlarmTime at);
  void clear(Entry& entry, AlarmTime at);
  void endShelf(Entry& entry, AlarmEventKind kind, const std::string& who, AlarmTime now);
  void followFlood(AlarmTime now);
  void markAge(Entry& entry, AlarmTime now) const;
  void forgetNormal();
  void note(const Entry& entry, AlarmEventKind kind, AlarmTime time, const std::string& who, const std::string& text);
  [[nodiscard]] std::size_t raisedSince(AlarmTime from) const;

  std::shared_ptr<const std::vector<AlarmRule>> rules_;  ///< at one place, for entries point at them
  AlarmBookSettings settings_;
  std::map<AlarmKey, Entry> entries_;
  std::deque<AlarmTime> raised_;  ///< of the last day
  bool flood_ = false;
  std::uint64_t lastId_ = 0;
  std::vector<AlarmEvent> events_;
};

}  // namespace vignole
