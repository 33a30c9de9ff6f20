#include "gui/alarms/alarm_watch.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "engine/archive/alarm_history.h"
#include "engine/database/archive_url.h"
#include "gui/bridge/archive_reader.h"

namespace vignole {

namespace {

constexpr std::uint64_t kTriggersOfAShare = 66;  ///< about a second
constexpr auto kDiskEvery = std::chrono::seconds(30);
constexpr std::size_t kEarlierRead = 200;

AlarmTime systemNow() { return std::chrono::floor<std::chrono::milliseconds>(std::chrono::system_clock::now()); }

std::string verdictWord(Verdict verdict) {
  switch (verdict) {
    case Verdict::Pass:
      return "good";
    case Verdict::Near:
      return "near limit";
    case Verdict::Fail:
      return "out of tolerance";
    case Verdict::NoLimit:
      return "no limits";
    case Verdict::NotMeasured:
      break;
  }
  return "not valid";
}

/// The same as long as the stretch grows: it is told once.
std::string exceptionText(const DimensionSummary& d) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%s from %.2f m", std::string(name(d.dimension)).c_str(),
                d.exceptions.front().fromM);
  return text.data();
}

}  // namespace

AlarmWatch::AlarmWatch(Workplace& place, Clock clock, QObject* parent)
    : QObject(parent), place_(place), clock_(clock ? std::move(clock) : systemNow), book_(*AlarmBook::create()) {
  if (place.archive != nullptr) archive_ = std::make_unique<ArchiveReader>(place.archiveUrl);
  log_ = std::make_unique<AlarmLog>(archive_.get());
  began_ = clock_();
  lookBack();
}

double AlarmWatch::runningS() const { return std::chrono::duration<double>(clock_() - began_).count(); }

AlarmWatch::~AlarmWatch() { archive_.reset(); }

void AlarmWatch::lookBack() {
  if (!archive_) return;
  archive_->ask("before", [this](const Archive* archive, const std::string& /*problem*/) -> ArchiveReader::Answer {
    if (archive == nullptr) return {};
    const AlarmHistory history(*archive);
    AlarmQuery query;
    query.limit = kEarlierRead;
    auto alarms = history.alarms(query);
    auto events = history.events({}, {}, kEarlierRead);
    if (!alarms || !events) return {};
    return [this, alarms = std::move(*alarms), events = std::move(*events)] {
      log_->setEarlier(alarms, events);
      emit changed();
    };
  });
}

std::string AlarmWatch::who() const {
  return place_.session.user().isEmpty() ? "operator" : place_.session.user().toStdString();
}

void AlarmWatch::follow(const LineSnapshot& line) {
  followRail(line);
  followLine(line);
  followTriggers(line);
  followDisk();
  followEvents(line);
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
  // A camera that is lost explains what is not measured.
  const bool measuringNow = line.state == LineState::Measuring;
  const UnmeasuredDimension* missing = nullptr;
  for (const UnmeasuredDimension& u : line.unmeasured)
    if (const auto& limits = line.recipe->limits[index(u.dimension)];
        missing == nullptr && (limits.lowerMm || limits.upperMm))
      missing = &u;
  const bool unmeasured = measuringNow && missing != nullptr && line.lostCameras.empty();
  if (unmeasured || unmeasured_)
    book_.set({"dimension.not-measured", "line"}, unmeasured, now,
              unmeasured ? std::string(name(missing->dimension)) + ": " + missing->reason : std::string());
  unmeasured_ = unmeasured;
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

void AlarmWatch::followTriggers(const LineSnapshot& line) {
  const TriggerLedger& now = line.triggers;
  if (now.seen < before_.seen) before_ = {};  // the line has been started anew
  if (now.seen - before_.seen < kTriggersOfAShare) return;
  const auto share = [&](std::string_view word) {
    const auto sum = [word](const TriggerLedger& ledger) {
      std::uint64_t n = 0;
      for (const auto& [reason, times] : ledger.reasons)
        if (reason.starts_with(word)) n += times;
      return n;
    };
    return 100.0 * static_cast<double>(sum(now) - sum(before_)) / static_cast<double>(now.seen - before_.seen);
  };
  const AlarmTime at = clock_();
  book_.observe({"registration.failed", "line"}, share("not registered"), at);
  for (int c = 0; c < kCameraCount; ++c) {
    const std::string camera = "camera " + std::to_string(c + 1);
    // A camera that is lost altogether has its own alarm.
    book_.observe({"camera.frame-loss", camera}, lost_[static_cast<std::size_t>(c)] ? 0 : share(camera + ":"), at);
  }
  before_ = now;
}

void AlarmWatch::followDisk() {
  const AlarmTime now = clock_();
  if (!archive_ || now - diskAsked_ < kDiskEvery) return;
  diskAsked_ = now;
  // A disk on a network may keep one waiting: not the window.
  archive_->ask("disk", [this](const Archive* archive, const std::string& /*problem*/) -> ArchiveReader::Answer {
    if (archive == nullptr) return {};
    const auto url = parseArchiveUrl(archive->url());
    if (!url || url->file.empty()) return {};
    std::error_code failed;
    const auto space = std::filesystem::space(std::filesystem::absolute(url->file).parent_path(), failed);
    if (failed) return {};
    return [this, gigabytes = static_cast<double>(space.available) / 1e9] {
      book_.observe({"disk.low", "disk"}, gigabytes, clock_());
    };
  });
}

void AlarmWatch::followEvents(const LineSnapshot& line) {
  const auto note = [this](const std::string& text) {
    EventRecord event;
    event.timeUs = std::chrono::duration_cast<std::chrono::microseconds>(clock_().time_since_epoch()).count();
    event.source = "line";
    event.text = text;
    event.user = who();
    log_->noteEvent(std::move(event));
    emit changed();
  };
  const auto runs = [](LineState state) { return state != LineState::Idle && state != LineState::Stopped; };
  if (state_ && runs(*state_) != runs(line.state))
    note(runs(line.state) ? "the line was started" : "the line was stopped");
  state_ = line.state;
  if (line.railsPassed > railsPassed_ && !line.passed.empty())
    note("rail " + line.passed.back().id + " has passed: " + verdictWord(line.passed.back().verdict));
  railsPassed_ = line.railsPassed;
  const QString& user = place_.session.user();
  if (user != user_) {
    if (!user_.isEmpty()) note(user_.toStdString() + " signed out");
    if (!user.isEmpty()) note(user.toStdString() + " signed in");
    user_ = user;
  }
}

void AlarmWatch::observeWindow(double worstMs) { book_.observe({"window.slow", "window"}, worstMs, clock_()); }

void AlarmWatch::take() {
  const std::vector<AlarmEvent> fresh = book_.takeEvents();
  if (fresh.empty()) return;
  for (const AlarmEvent& event : fresh) log_->note(event, book_, rail_.empty() ? rail_ : rail_.substr(5));
  emit changed();
}

void AlarmWatch::acknowledge(std::uint64_t alarm) {
  (void)book_.acknowledge(alarm, who(), clock_());
  take();
}

void AlarmWatch::acknowledge(const std::vector<std::uint64_t>& alarms) {
  book_.acknowledge(alarms, who(), clock_());
  take();
}

void AlarmWatch::acknowledgeAll() {
  std::vector<std::uint64_t> all;
  for (const Alarm& alarm : book_.active()) all.push_back(alarm.id);
  acknowledge(all);
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
