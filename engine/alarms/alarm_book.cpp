#include "engine/alarms/alarm_book.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace vignole {

namespace {

constexpr AlarmDuration kTenMinutes = std::chrono::minutes(10), kHour = std::chrono::hours(1),
                        kDay = std::chrono::hours(24);

bool isOn(AlarmState state) { return state == AlarmState::Unacknowledged || state == AlarmState::Acknowledged; }
bool isUnacknowledged(AlarmState state) {
  return state == AlarmState::Unacknowledged || state == AlarmState::ReturnedUnacknowledged;
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& p : parts) text += (text.empty() ? "" : "; ") + p;
  return text;
}

std::string inWords(AlarmDuration time) {
  const auto minutes = std::chrono::duration_cast<std::chrono::minutes>(time).count();
  return minutes % 60 == 0 ? std::to_string(minutes / 60) + " h" : std::to_string(minutes) + " min";
}

}  // namespace

std::string_view name(AlarmState state) {
  constexpr std::array<std::string_view, 4> kNames = {"normal", "unacknowledged", "acknowledged",
                                                      "returned, unacknowledged"};
  return kNames.at(static_cast<std::size_t>(state));
}

std::string_view name(AlarmEventKind kind) {
  constexpr std::array<std::string_view, 8> kNames = {"raised",    "cleared",       "acknowledged", "shelved",
                                                      "unshelved", "shelf ran out", "flood began",  "flood ended"};
  return kNames.at(static_cast<std::size_t>(kind));
}

AlarmBook::AlarmBook(std::vector<AlarmRule> rules, const AlarmBookSettings& settings)
    : rules_(std::make_shared<const std::vector<AlarmRule>>(std::move(rules))), settings_(settings) {}

Expected<AlarmBook> AlarmBook::create(std::vector<AlarmRule> rules, const AlarmBookSettings& settings) {
  if (auto fine = checkAlarmRules(rules); !fine) return tl::unexpected(fine.error());
  return AlarmBook(std::move(rules), settings);
}

const AlarmRule* AlarmBook::rule(std::string_view id) const {
  const auto found = std::find_if(rules_->begin(), rules_->end(), [&](const AlarmRule& r) { return r.id == id; });
  return found == rules_->end() ? nullptr : &*found;
}

AlarmBook::Entry& AlarmBook::entry(const AlarmKey& key) {
  const auto found = entries_.find(key);
  if (found != entries_.end()) return found->second;
  const AlarmRule* known = rule(key.rule);
  assert(known != nullptr && "a rule that nobody wrote down");
  Entry& made = entries_.emplace(key, Entry(*known)).first->second;
  made.alarm.key = key;
  made.alarm.priority = known->priority;
  return made;
}

void AlarmBook::addDetail(Entry& entry, const std::string& detail) const {
  if (detail.empty()) return;
  std::vector<std::string>& list = isOn(entry.alarm.state) ? entry.alarm.details : entry.waiting;
  if (list.size() < settings_.maxDetails && std::find(list.begin(), list.end(), detail) == list.end())
    list.push_back(detail);
}

void AlarmBook::observe(const AlarmKey& key, double value, AlarmTime now, const std::string& detail) {
  Entry& e = entry(key);
  catchUp(e, now);
  e.signal.observe(value, now);
  e.alarm.value = e.signal.value();
  if (e.signal.raw()) addDetail(e, detail);
  follow(e, now);
}

void AlarmBook::set(const AlarmKey& key, bool on, AlarmTime now, const std::string& detail) {
  Entry& e = entry(key);
  catchUp(e, now);
  e.signal.set(on, now);
  if (on) addDetail(e, detail);
  follow(e, now);
}

/// What was due before now, first: a delay may have run out between two calls.
void AlarmBook::catchUp(Entry& e, AlarmTime now) {
  e.signal.advance(now);
  follow(e, now);
}

void AlarmBook::follow(Entry& e, AlarmTime now) {
  if (!e.signal.raw() && !e.signal.on()) e.waiting.clear();  // it never became an alarm
  if (e.signal.on() == e.seenOn) return;
  e.seenOn = e.signal.on();
  if (e.seenOn)
    raise(e, std::min(now, e.signal.since()));
  else
    clear(e, std::min(now, e.signal.since()));
}

void AlarmBook::raise(Entry& e, AlarmTime at) {
  e.alarm.id = ++lastId_;
  e.alarm.state = e.rule->needsAcknowledgement ? AlarmState::Unacknowledged : AlarmState::Acknowledged;
  e.alarm.raised = at;
  e.alarm.cleared.reset();
  e.alarm.acknowledged.reset();
  e.alarm.acknowledgedBy.clear();
  e.alarm.details = std::move(e.waiting);
  e.waiting.clear();
  if (e.alarm.shelf) return;  // nobody is told, nothing is counted
  raised_.push_back(at);
  e.raisings.push_back(at);
  note(e, AlarmEventKind::Raised, at, {}, joined(e.alarm.details));
}

void AlarmBook::clear(Entry& e, AlarmTime at) {
  const bool seen = e.alarm.state == AlarmState::Acknowledged || e.alarm.shelf;
  e.alarm.cleared = at;
  e.alarm.state = seen ? AlarmState::Normal : AlarmState::ReturnedUnacknowledged;
  if (!e.alarm.shelf) note(e, AlarmEventKind::Cleared, at, {}, joined(e.alarm.details));
}

Expected<void> AlarmBook::acknowledge(std::uint64_t alarm, const std::string& who, AlarmTime now) {
  if (who.empty()) return inputError("acknowledge", "needs the name of who does it");
  for (auto& [key, e] : entries_) {
    if (e.alarm.id != alarm || alarm == 0) continue;
    if (!isUnacknowledged(e.alarm.state))
      return inputError("alarm " + std::to_string(alarm), "needs no acknowledgement");
    e.alarm.state = e.alarm.state == AlarmState::Unacknowledged ? AlarmState::Acknowledged : AlarmState::Normal;
    e.alarm.acknowledged = now;
    e.alarm.acknowledgedBy = who;
    note(e, AlarmEventKind::Acknowledged, now, who, {});
    return {};
  }
  return inputError("alarm " + std::to_string(alarm), "is not in the list any more");
}

void AlarmBook::acknowledge(const std::vector<std::uint64_t>& alarms, const std::string& who, AlarmTime now) {
  for (const std::uint64_t alarm : alarms) static_cast<void>(acknowledge(alarm, who, now));
}

Expected<void> AlarmBook::shelve(const AlarmKey& key, const std::string& who, const std::string& reason,
                                 AlarmDuration time, AlarmTime now) {
  const std::string where = key.source.empty() ? key.rule : key.rule + ", " + key.source;
  if (rule(key.rule) == nullptr) return inputError(where, "there is no such alarm");
  if (who.empty()) return inputError(where, "shelving needs the name of who does it");
  if (reason.find_first_not_of(" \t\r\n") == std::string::npos) return inputError(where, "shelving needs a reason");
  if (time <= AlarmDuration(0) || time > settings_.longestShelf)
    return inputError(where, "can be shelved for at most " + inWords(settings_.longestShelf));
  Entry& e = entry(key);
  e.alarm.shelf = Shelf{now, now + time, who, reason};
  if (e.alarm.state == AlarmState::ReturnedUnacknowledged) e.alarm.state = AlarmState::Normal;
  note(e, AlarmEventKind::Shelved, now, who, reason);
  return {};
}

Expected<void> AlarmBook::unshelve(const AlarmKey& key, const std::string& who, AlarmTime now) {
  const auto found = entries_.find(key);
  if (found == entries_.end() || !found->second.alarm.shelf) return inputError(key.rule, "is not shelved");
  endShelf(found->second, AlarmEventKind::Unshelved, who, now);
  return {};
}

void AlarmBook::endShelf(Entry& e, AlarmEventKind kind, const std::string& who, AlarmTime now) {
  note(e, kind, now, who, e.alarm.shelf->reason);
  e.alarm.shelf.reset();
  if (!e.signal.on()) {
    e.alarm.state = AlarmState::Normal;
    return;
  }
  e.waiting = e.alarm.details;  // still wrong: it is raised anew, with what is known of it
  raise(e, now);
}

void AlarmBook::advance(AlarmTime now) {
  for (auto& [key, e] : entries_) {
    catchUp(e, now);
    if (e.alarm.shelf && now >= e.alarm.shelf->until)
      endShelf(e, AlarmEventKind::ShelfRanOut, {}, e.alarm.shelf->until);
    markAge(e, now);
  }
  followFlood(now);
  forgetNormal();
}

void AlarmBook::markAge(Entry& e, AlarmTime now) const {
  while (!e.raisings.empty() && e.raisings.front() <= now - settings_.chatterWindow) e.raisings.pop_front();
  e.alarm.chattering = e.raisings.size() >= settings_.chatterCount;
  e.alarm.stale = isOn(e.alarm.state) && now - e.alarm.raised > settings_.staleAfter;
}

void AlarmBook::followFlood(AlarmTime now) {
  while (!raised_.empty() && raised_.front() <= now - kDay) raised_.pop_front();
  const std::size_t lately = raisedSince(now - kTenMinutes);
  if (!flood_ ? lately <= settings_.floodAbove : lately >= settings_.floodEndsBelow) return;
  flood_ = !flood_;
  AlarmEvent event;
  event.time = now;
  event.kind = flood_ ? AlarmEventKind::FloodBegan : AlarmEventKind::FloodEnded;
  event.text = std::to_string(lately) + " alarms in 10 minutes";
  events_.push_back(std::move(event));
}

/// Every rail is a source of its own: without this the book would grow with every rail.
void AlarmBook::forgetNormal() {
  std::erase_if(entries_, [](const auto& item) {
    const Entry& e = item.second;
    const bool quiet = e.alarm.state == AlarmState::Normal && !e.alarm.shelf && !e.signal.raw() && !e.signal.on();
    return quiet && !e.signal.value() && e.raisings.empty();
  });
}

std::size_t AlarmBook::raisedSince(AlarmTime from) const {
  // Times of delays that ran out may come a little out of order.
  return static_cast<std::size_t>(std::count_if(raised_.begin(), raised_.end(), [&](AlarmTime t) { return t > from; }));
}

AlarmRates AlarmBook::rates(AlarmTime now) const {
  return {raisedSince(now - kTenMinutes), raisedSince(now - kHour), raisedSince(now - kDay), flood_};
}

std::vector<Alarm> AlarmBook::active() const {
  std::vector<Alarm> list;
  for (const auto& [key, e] : entries_)
    if (e.alarm.state != AlarmState::Normal && !e.alarm.shelf) list.push_back(e.alarm);
  std::sort(list.begin(), list.end(), [](const Alarm& a, const Alarm& b) {
    return std::tuple(!isUnacknowledged(a.state), a.priority, b.id) <
           std::tuple(!isUnacknowledged(b.state), b.priority, a.id);
  });
  return list;
}

std::vector<Alarm> AlarmBook::shelved() const {
  std::vector<Alarm> list;
  for (const auto& [key, e] : entries_)
    if (e.alarm.shelf) list.push_back(e.alarm);
  return list;
}

std::vector<AlarmGroup> AlarmBook::groups() const {
  std::vector<AlarmGroup> list;
  for (const Alarm& alarm : active()) {
    auto group = std::find_if(list.begin(), list.end(), [&](const AlarmGroup& g) { return g.rule == alarm.key.rule; });
    if (group == list.end()) group = list.insert(list.end(), {alarm.key.rule, alarm.priority, {}, 0});
    group->alarms.push_back(alarm.id);
    group->unacknowledged += isUnacknowledged(alarm.state) ? 1 : 0;
  }
  std::stable_sort(list.begin(), list.end(), [](const AlarmGroup& a, const AlarmGroup& b) {
    return std::tuple(a.unacknowledged == 0, a.priority) < std::tuple(b.unacknowledged == 0, b.priority);
  });
  return list;
}

std::optional<AlarmPriority> AlarmBook::mostUrgent() const {
  std::optional<AlarmPriority> most;
  for (const auto& [key, e] : entries_)
    if (isOn(e.alarm.state) && !e.alarm.shelf && (!most || e.alarm.priority < *most)) most = e.alarm.priority;
  return most;
}

std::vector<AlarmEvent> AlarmBook::takeEvents() {
  std::vector<AlarmEvent> taken;
  taken.swap(events_);
  return taken;
}

void AlarmBook::note(const Entry& e, AlarmEventKind kind, AlarmTime time, const std::string& who,
                     const std::string& text) {
  events_.push_back({time, kind, e.alarm.id, e.alarm.key, e.alarm.priority, who, text});
}

}  // namespace vignole
