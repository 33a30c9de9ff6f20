#include "engine/acquisition/rail_announcement.h"

#include <utility>

namespace vignole {

namespace {

constexpr std::size_t kRailsRemembered = 16;  // cameras are never so far apart

class AnnouncedSource : public FrameSource {
 public:
  AnnouncedSource(std::unique_ptr<FrameSource> source, RailAnnouncements& rails)
      : source_(std::move(source)), rails_(rails) {}

  [[nodiscard]] FrameMessage next(int camera, std::stop_token stop) override {
    FrameMessage message = source_->next(camera, std::move(stop));
    auto* rail = std::get_if<RailBegin>(&message);
    if (rail == nullptr) return message;
    RailAnnouncement known = rails_.taken(rail->firstTrigger);
    if (!known.id.empty()) rail->id = std::move(known.id);
    if (!known.heat.empty()) rail->heat = std::move(known.heat);
    if (known.temperatureC) rail->temperatureC = *known.temperatureC;
    return message;
  }
  [[nodiscard]] bool live() const override { return source_->live(); }

 private:
  std::unique_ptr<FrameSource> source_;
  RailAnnouncements& rails_;
};

}  // namespace

void RailAnnouncements::announce(RailAnnouncement next) {
  const std::lock_guard lock(mutex_);
  waiting_ = std::move(next);
}

void RailAnnouncements::withdraw() {
  const std::lock_guard lock(mutex_);
  waiting_.reset();
}

std::optional<RailAnnouncement> RailAnnouncements::waiting() const {
  const std::lock_guard lock(mutex_);
  return waiting_;
}

RailAnnouncement RailAnnouncements::taken(std::uint64_t firstTrigger) {
  const std::lock_guard lock(mutex_);
  if (const auto known = taken_.find(firstTrigger); known != taken_.end()) return known->second;
  const RailAnnouncement now = waiting_.value_or(RailAnnouncement{});
  waiting_.reset();
  taken_.emplace(firstTrigger, now);
  if (taken_.size() > kRailsRemembered) taken_.erase(taken_.begin());
  return now;
}

void RailAnnouncements::restart() {
  const std::lock_guard lock(mutex_);
  taken_.clear();
}

std::unique_ptr<FrameSource> announced(std::unique_ptr<FrameSource> source, RailAnnouncements& rails) {
  return std::make_unique<AnnouncedSource>(std::move(source), rails);
}

}  // namespace vignole
