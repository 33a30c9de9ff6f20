#include "gui/bridge/seam_watch.h"

#include <utility>

namespace vignole {

namespace {
constexpr std::size_t kRailsKept = 400;
}

SeamWatch::SeamWatch(const Section& section, const DriftSettings& settings) : settings_(settings) { restart(section); }

void SeamWatch::restart(const Section& section) {
  watch_ = std::make_unique<DriftWatch>(section, settings_);
  rails_.clear();
  auto fresh = std::make_shared<DriftTrack>();
  fresh->baselineRails = settings_.baselineRails;
  const std::lock_guard lock(mutex_);
  track_ = std::move(fresh);
}

InspectionObserver SeamWatch::watched(InspectionObserver other) {
  other.profileMeasured = [this, next = std::move(other.profileMeasured)](const ProfileResult& result) {
    watch_->add(result.profile, result.registration);
    if (next) next(result);
  };
  other.railEnded = [this, next = std::move(other.railEnded)](const RailBegin& rail, const TriggerLedger& ledger) {
    endRail();
    if (next) next(rail, ledger);
  };
  return other;
}

void SeamWatch::endRail() {
  auto fresh = std::make_shared<DriftTrack>();
  fresh->latest = watch_->endRail();
  fresh->baselineRails = settings_.baselineRails;
  if (!fresh->latest.learning) {
    DriftTrack::Rail rail;
    for (std::size_t c = 0; c < rail.valueMm.size(); ++c) {
      rail.valueMm[c] = fresh->latest.cameras[c].valueMm;
      rail.limitMm[c] = fresh->latest.cameras[c].limitMm;
    }
    rails_.push_back(rail);
    if (rails_.size() > kRailsKept) rails_.erase(rails_.begin());
  }
  fresh->rails = rails_;
  const std::lock_guard lock(mutex_);
  track_ = std::move(fresh);
}

std::shared_ptr<const DriftTrack> SeamWatch::track() const {
  const std::lock_guard lock(mutex_);
  return track_;
}

}  // namespace vignole
