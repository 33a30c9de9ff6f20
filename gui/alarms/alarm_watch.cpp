#include "gui/alarms/alarm_watch.h"

#include <algorithm>

#include "engine/archive/alarm_history.h"
#include "gui/bridge/archive_reader.h"
#include "report/dimension_text.h"

namespace vignole {

namespace {

constexpr std::size_t kEventsKept = 500;

AlarmTime systemNow() { return std::chrono::floor<std::chrono::milliseconds>(std::chrono::system_clock::now()); }

/// The same as long as the stretch grows: it is told once.
std::string exceptionText(const DimensionSummary& d) {
  return std::string(name(d.dimension)) + " from " + numberText(d.exceptions.front().fromM, 2).toStdString() + " m";
}

}  // namespace

AlarmWatch::AlarmWatch(Workplace& place, Clock clock, QObject* parent)
    : QObject(parent), place_(place), clock_(clock ? std::move(clock) : systemNow), book_(*AlarmBook::create()) {
  if (place.archive != nullptr) archive_ = std::make_unique<ArchiveReader>(place.archiveUrl);
}

AlarmWatch::~AlarmWatch() { archive_.reset(); }

std::string AlarmWatch::who() const {
  return place_.session.user().isEmpty() ? "operator" : place_.session.user().toStdString();
}

void AlarmWatch::follow(const LineSnapshot& line) {
  followRail(line);
  followLine(line);
  book_.advance(clock_());
  take();
}

void AlarmWatch::followRail(const LineSnapshot& line) {
  const AlarmTime now = clock_();
  const std::string rail = line.rail ? "rail " + line.rail->rail.id : std::string();
  if (rail != rail_ && !rail_.empty())
    // The rail has passed: its alarm stays until somebody has seen it.
    for (const char* rule : {"rail.out-of-tolerance", "rail.wrong-section"}) book_.set({rule, rail_}, false, now);
  rail_ = rail;
  if (!line.rail) return;
  for (const DimensionSummary& d : line.rail->dimensions)
    if (!d.exceptions.empty()) book_.set({"rail.out-of-tolerance", rail}, true, now, exceptionText(d));
  if (line.rail->looksLike)
    book_.set({"rail.wrong-section", rail}, true, now, "looks like " + line.rail->looksLike->section);
  book_.set({"calibration.invalid", "calibration"}, !line.rail->calibrationWarning.empty(), now,
            line.rail->calibrationWarning);
}

void AlarmWatch::followLine(const LineSnapshot& line) {
  const AlarmTime now = clock_();
  std::array<bool, kCameraCount> lost{};
  for (const LostCamera& l : line.lostCameras) {
    lost[static_cast<std::size_t>(l.camera)] = true;
    book_.set({"camera.lost", "camera " + std::to_string(l.camera + 1)}, true, now, l.reason);
  }
  for (int c = 0; c < kCameraCount; ++c) {
    const auto i = static_cast<std::size_t>(c);
    if (lost_[i] && !lost[i]) book_.set({"camera.lost", "camera " + std::to_string(c + 1)}, false, now);
  }
  lost_ = lost;
  book_.set({"measurement.stopped", "line"}, line.state == LineState::Fault || line.state == LineState::Silent, now,
            line.error.empty() ? std::string("no profiles") : line.error);
  const bool measuring = line.state == LineState::Measuring && line.rail && line.rail->profiles > 50;
  if (measuring)
    book_.observe({"profiles.incomplete", "line"},
                  100.0 * static_cast<double>(line.recentIncomplete) / static_cast<double>(line.rail->profiles), now);
  double fill = 0;
  for (const StageStatistics& s : line.stages)
    if (s.queueCapacity > 0)
      fill = std::max(fill, 100.0 * static_cast<double>(s.queueDepth) / static_cast<double>(s.queueCapacity));
  book_.observe({"pipeline.late", "pipeline"}, fill, now);
  if (place_.writer != nullptr) {
    const std::string failure = place_.writer->status().failure;
    book_.set({"archive.unreachable", "archive"}, !failure.empty(), now, failure);
  }
}

void AlarmWatch::take() {
  const std::vector<AlarmEvent> fresh = book_.takeEvents();
  if (fresh.empty()) return;
  for (const AlarmEvent& event : fresh) {
    events_.push_front(event);
    write(event);
  }
  while (events_.size() > kEventsKept) events_.pop_back();
  emit changed();
}

void AlarmWatch::write(const AlarmEvent& event) {
  if (!archive_) return;
  EventRecord record;
  record.timeUs = std::chrono::duration_cast<std::chrono::microseconds>(event.time.time_since_epoch()).count();
  record.source = event.key.rule.empty() ? "alarms" : event.key.rule + ", " + event.key.source;
  record.text = std::string(name(event.kind)) + (event.text.empty() ? "" : ": " + event.text);
  record.user = event.who;
  // Each its own kind: none replaces another that waits.
  archive_->ask(std::to_string(++written_),
                [record](const Archive* archive, const std::string&) -> ArchiveReader::Answer {
                  if (archive != nullptr) (void)AlarmHistory(*archive).addEvent(record);
                  return {};
                });
}

void AlarmWatch::acknowledge(std::uint64_t alarm) {
  (void)book_.acknowledge(alarm, who(), clock_());
  take();
}

void AlarmWatch::acknowledgeAll() {
  std::vector<std::uint64_t> all;
  for (const Alarm& alarm : book_.active()) all.push_back(alarm.id);
  book_.acknowledge(all, who(), clock_());
  take();
}

Expected<void> AlarmWatch::shelve(const AlarmKey& key, const std::string& reason, AlarmDuration time) {
  auto done = book_.shelve(key, who(), reason, time, clock_());
  take();
  return done;
}

Expected<void> AlarmWatch::unshelve(const AlarmKey& key) {
  auto done = book_.unshelve(key, who(), clock_());
  take();
  return done;
}

}  // namespace vignole
