#include "gui/alarms/alarm_log.h"

#include <algorithm>

#include "gui/bridge/archive_reader.h"

namespace vignole {

namespace {

constexpr std::size_t kKept = 500;

TimeUs microseconds(AlarmTime time) {
  return std::chrono::duration_cast<std::chrono::microseconds>(time.time_since_epoch()).count();
}

/// All that came so far, not only what came first.
std::string detailsOf(std::uint64_t id, const AlarmBook& book) {
  for (const Alarm& alarm : book.active()) {
    if (alarm.id != id) continue;
    std::string text;
    for (const std::string& detail : alarm.details) text += (text.empty() ? "" : "; ") + detail;
    return text;
  }
  return {};
}

AlarmRecord recordOf(const AlarmEvent& event, const AlarmRule& rule, const std::string& rail) {
  AlarmRecord record;
  record.rule = event.key.rule;
  record.source = event.key.source;
  record.priority = static_cast<int>(event.priority);
  record.cause = rule.cause;
  record.consequence = rule.consequence;
  record.action = rule.action;
  record.details = event.text;
  record.rail = rail;
  record.raisedUs = microseconds(event.time);
  return record;
}

}  // namespace

void AlarmLog::note(const AlarmEvent& event, const AlarmBook& book, const std::string& rail) {
  steps_.push_front(event);
  if (steps_.size() > kKept) steps_.pop_back();
  const TimeUs time = microseconds(event.time);
  const AlarmRule* rule = book.rule(event.key.rule);
  if (rule != nullptr && event.kind == AlarmEventKind::Raised)
    alarms_.insert_or_assign(event.alarm, recordOf(event, *rule, rail));
  if (const auto at = alarms_.find(event.alarm); at != alarms_.end()) {
    AlarmRecord& record = at->second;
    if (const std::string details = detailsOf(event.alarm, book); !details.empty()) record.details = details;
    if (event.kind == AlarmEventKind::Cleared) {
      record.clearedUs = time;
    } else if (event.kind == AlarmEventKind::Acknowledged) {
      record.acknowledgedUs = time;
      record.acknowledgedBy = event.who;
    } else if (event.kind == AlarmEventKind::Shelved) {
      record.shelvedBy = event.who;
      record.shelvingReason = event.text;
    }
  }
  while (alarms_.size() > kKept) alarms_.erase(alarms_.begin());
  store(event.alarm, {{}, time, std::string(name(event.kind)), event.who, event.text});
}

void AlarmLog::store(std::uint64_t alarm, const AlarmStep& step) {
  if (reader_ == nullptr) return;
  std::optional<AlarmRecord> record;
  if (const auto at = alarms_.find(alarm); at != alarms_.end()) record = at->second;
  // Each its own kind: none replaces another that waits.
  reader_->ask(
      "alarm " + std::to_string(++written_),
      [uids = uids_, alarm, record, step](const Archive* archive, const std::string&) -> ArchiveReader::Answer {
        if (archive == nullptr) return {};
        AlarmHistory history(*archive);
        AlarmStep named = step;
        if (record) {
          AlarmRecord known = *record;
          if (const auto uid = uids->find(alarm); uid != uids->end()) known.uid = uid->second;
          if (auto saved = history.save(known)) named.alarm = (*uids)[alarm] = *saved;
          if (known.clearedUs && known.acknowledgedUs) uids->erase(alarm);
        }
        (void)history.addStep(named);
        return {};
      });
}

void AlarmLog::noteEvent(EventRecord event) {
  if (reader_ != nullptr)
    reader_->ask("event " + std::to_string(++written_),
                 [event](const Archive* archive, const std::string&) -> ArchiveReader::Answer {
                   if (archive != nullptr) (void)AlarmHistory(*archive).addEvent(event);
                   return {};
                 });
  events_.push_front(std::move(event));
  if (events_.size() > kKept) events_.pop_back();
}

std::vector<AlarmRecord> AlarmLog::history() const {
  std::vector<AlarmRecord> all;
  all.reserve(alarms_.size() + earlier_.size());
  for (auto at = alarms_.rbegin(); at != alarms_.rend(); ++at) all.push_back(at->second);
  all.insert(all.end(), earlier_.begin(), earlier_.end());
  return all;
}

void AlarmLog::setEarlier(std::vector<AlarmRecord> alarms, std::vector<EventRecord> events) {
  earlier_ = std::move(alarms);
  for (EventRecord& event : events) events_.push_back(std::move(event));
  while (events_.size() > kKept) events_.pop_back();
}

}  // namespace vignole
