#include "gui/bridge/rail_watch.h"

namespace vignole {

namespace {
constexpr std::size_t kPassedKept = 12;
constexpr auto kRateWindow = std::chrono::seconds(2);
}  // namespace

void RailWatch::Absence::note(bool absent, double positionM, const std::string& why) {
  if (!absent) {
    run = 0;
    return;
  }
  if (run++ == 0) fromM = positionM;
  reason = why;
}

InspectionObserver RailWatch::observer() {
  InspectionObserver observer;
  observer.railBegan = [this](const RailBegin& rail) { began(rail); };
  observer.profileMeasured = [this](const ProfileResult& result) { measured(result); };
  observer.railEnded = [this](const RailBegin& rail, const TriggerLedger& ledger) { railEnded(rail, ledger); };
  observer.ended = [this](const std::string& error) {
    const std::lock_guard lock(mutex_);
    underWay_ = false;
    ended_ = error;
  };
  return observer;
}

void RailWatch::began(const RailBegin& rail) {
  auto fresh = std::make_unique<RailSummariser>(rail, recipe_, calibrationId_);
  const std::lock_guard lock(mutex_);
  summariser_.swap(fresh);
  ledger_ = {};
  underWay_ = true;
  dimensions_ = {};
  for (Absence& camera : cameras_) camera.fromM = 0;  // a camera that was lost before is lost from this rail's head on
}

void RailWatch::measured(const ProfileResult& result) {
  mailbox_.publish(result);
  const double positionM = result.profile.positionMm / 1000;
  const std::lock_guard lock(mutex_);
  ++profiles_;
  ++ledger_.seen;
  ++(result.profile.complete() && result.registration.valid ? ledger_.measured : ledger_.incomplete);
  if (summariser_) summariser_->add(result);
  for (std::size_t c = 0; c < cameras_.size(); ++c)
    cameras_[c].note(!result.profile.missing[c].empty(), positionM, result.profile.missing[c]);
  for (const Dimension d : kDimensions) {
    const DimensionResult& r = result.measurement.dimensions[index(d)];
    dimensions_[index(d)].note(!r.valueMm.has_value(), positionM, r.reason);
  }
}

void RailWatch::railEnded(const RailBegin& rail, const TriggerLedger& ledger) {
  const std::lock_guard lock(mutex_);
  underWay_ = false;
  ledger_ = ledger;
  if (!summariser_) return;
  const Verdict verdict = summariser_->summary(ledger).verdict;
  passed_.push_back({rail.id, verdict});
  if (passed_.size() > kPassedKept) passed_.pop_front();
  ++railsPassed_;
  if (verdict == Verdict::Pass) ++railsGood_;
}

void RailWatch::fill(LineSnapshot& snapshot, PullDetail detail, Clock::time_point now) {
  if (auto fresh = mailbox_.takeNew()) {
    snapshot.latest = std::move(fresh);
    lastArrival_ = now;
  }
  snapshot.ageS = lastArrival_ ? std::chrono::duration<double>(now - *lastArrival_).count() : 0;
  if (detail == PullDetail::Profile) return;

  const std::lock_guard lock(mutex_);
  rate_.emplace_back(now, profiles_);
  while (rate_.size() > 2 && now - rate_.front().first > kRateWindow) rate_.pop_front();
  const double span = std::chrono::duration<double>(now - rate_.front().first).count();
  snapshot.profilesPerS = span > 0.2 ? static_cast<double>(profiles_ - rate_.front().second) / span : 0;
  // A rail that has begun but not yet shown a profile does not wipe the one on the screen.
  if (summariser_ && ledger_.seen > 0)
    snapshot.rail = std::make_shared<const RailSummary>(summariser_->summary(ledger_));
  snapshot.recentIncomplete = ledger_.incomplete + ledger_.lost;
  snapshot.lostCameras.clear();
  for (std::size_t c = 0; c < cameras_.size(); ++c)
    if (cameras_[c].run >= kSustained)
      snapshot.lostCameras.push_back({static_cast<int>(c), cameras_[c].fromM, cameras_[c].reason});
  snapshot.unmeasured.clear();
  for (const Dimension d : kDimensions)
    if (const Absence& a = dimensions_[index(d)]; a.run >= kSustained)
      snapshot.unmeasured.push_back({d, a.fromM, a.reason});
  snapshot.passed.assign(passed_.begin(), passed_.end());
  snapshot.railsPassed = railsPassed_;
  snapshot.railsGood = railsGood_;
}

bool RailWatch::railUnderWay() const {
  const std::lock_guard lock(mutex_);
  return underWay_;
}

std::optional<std::string> RailWatch::ended() const {
  const std::lock_guard lock(mutex_);
  return ended_;
}

void RailWatch::forget() {
  mailbox_.clear();
  lastArrival_.reset();
  const std::lock_guard lock(mutex_);
  summariser_.reset();
  ledger_ = {};
}

void RailWatch::restart(const std::string& calibrationId) {
  const std::lock_guard lock(mutex_);
  if (!calibrationId.empty()) calibrationId_ = calibrationId;
  ended_.reset();
  underWay_ = false;
  cameras_ = {};
  dimensions_ = {};
}

}  // namespace vignole
