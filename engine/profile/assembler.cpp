#include "engine/profile/assembler.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace vignole {

namespace {
constexpr std::uint64_t kEverything = std::numeric_limits<std::uint64_t>::max();
constexpr const char* kStopped = "stopped";
}  // namespace

std::string cameraReason(int camera, const std::string& reason) {
  return "camera " + std::to_string(camera + 1) + ": " + reason;
}

// ---- what comes in

ProfileAssembler::Pending& ProfileAssembler::pendingAt(std::uint64_t trigger) {
  std::unique_ptr<Pending>& entry = pending_[trigger];
  if (!entry) {
    if (spent_.empty()) {
      entry = std::make_unique<Pending>();
    } else {
      entry = std::move(spent_.back());
      spent_.pop_back();
    }
  }
  return *entry;
}

ProfileAssembler::Slot* ProfileAssembler::accept(int camera, std::uint64_t trigger) {
  Stream& from = stream(camera);
  // Judged by the camera's own stream alone, so that the verdict does not depend on how fast the others are.
  if (trigger < from.next) {
    remarks_.emplace(from.next, cameraReason(camera, from.lastFrame == trigger ? "repeated frame" : "late frame"));
    return nullptr;
  }
  from.next = trigger + 1;
  from.lastFrame = trigger;
  if (trigger < cursor_) {  // given up before it came
    remarks_.emplace(from.next, cameraReason(camera, "late frame"));
    return nullptr;
  }
  return &pendingAt(trigger).slots[static_cast<std::size_t>(camera)];
}

void ProfileAssembler::add(PartialContour& contour) {
  Slot* slot = accept(contour.camera, contour.trigger);
  if (slot == nullptr) return;
  std::swap(slot->contour, contour);
  slot->has = true;
}

void ProfileAssembler::add(int camera, const FrameLost& lost) {
  if (Slot* slot = accept(camera, lost.trigger)) slot->missing = lost.reason.empty() ? "frame lost" : lost.reason;
}

void ProfileAssembler::add(int camera, const RailBegin& begin) {
  Stream& from = stream(camera);
  from.next = std::max(from.next, begin.firstTrigger);
  const RailKey key{begin.firstTrigger, begin.id};
  if (from.rail && from.rail != key) from.railsEnded = std::max(from.railsEnded, begin.firstTrigger);
  from.rail = key;
  // Known by another camera's word, or already over.
  if (begin.firstTrigger < cursor_ || lastEnded_ == key) return;
  for (const Rail& rail : rails_)
    if (rail.key() == key || rail.begin->firstTrigger > begin.firstTrigger) return;
  // A rail that begins ends the one before it, should its end never have been told.
  if (!rails_.empty() && (!rails_.back().end || *rails_.back().end > begin.firstTrigger))
    rails_.back().end = begin.firstTrigger;
  rails_.push_back({std::make_shared<const RailBegin>(begin), {}});
}

void ProfileAssembler::add(int camera, const RailEnd& end) {
  Stream& from = stream(camera);
  from.next = std::max(from.next, end.endTrigger);
  from.railsEnded = std::max(from.railsEnded, end.endTrigger);
  for (Rail& rail : rails_)
    if (rail.key() == from.rail && !rail.end) rail.end = std::max(end.endTrigger, rail.begin->firstTrigger);
}

void ProfileAssembler::add(int camera, const SourceEnd& end) {
  stream(camera).ended = true;
  stream(camera).error = end.error;
}

// ---- how far everything is

bool ProfileAssembler::allEnded() const {
  return std::all_of(streams_.begin(), streams_.end(), [](const Stream& s) { return s.ended; });
}

bool ProfileAssembler::ended() const {
  return allEnded() && !inRail_ && rails_.empty() && pending_.empty() && remarks_.empty();
}

std::string ProfileAssembler::error() const {
  for (const Stream& s : streams_)
    if (!s.error.empty()) return s.error;
  return {};
}

std::uint64_t ProfileAssembler::passedByAll() const {
  std::uint64_t passed = kEverything;
  for (const Stream& s : streams_)
    if (!s.ended) passed = std::min(passed, s.next);
  return passed;
}

std::uint64_t ProfileAssembler::furthest() const {
  std::uint64_t next = 0;
  for (const Stream& s : streams_) next = std::max(next, s.next);
  return next;
}

std::uint64_t ProfileAssembler::lead(int camera) const {
  const std::uint64_t passed = passedByAll(), next = stream(camera).next;
  return passed < next ? next - passed : 0;
}

std::uint64_t ProfileAssembler::settledBelow() const {
  const std::uint64_t passed = passedByAll();
  if (settings_.giveUpAfter == 0) return passed;
  const std::uint64_t next = furthest();
  return std::max(passed, next > settings_.giveUpAfter ? next - settings_.giveUpAfter : 0);
}

std::optional<std::uint64_t> ProfileAssembler::endOfRail() const {
  if (rails_.front().end) return rails_.front().end;
  if (allEnded()) return std::max(cursor_, furthest());  // cut short: as far as any camera came
  return {};
}

bool ProfileAssembler::railPassed(std::uint64_t end) const {
  // Being beyond the last trigger is not enough: the end token itself must have come through, or something later.
  const bool byAll = std::all_of(streams_.begin(), streams_.end(),
                                 [end](const Stream& s) { return s.ended || s.railsEnded >= end || s.next > end; });
  return byAll || (settings_.giveUpAfter != 0 && settledBelow() > end);
}

// ---- what comes out

bool ProfileAssembler::next(Assembly& out) {
  out.rail.reset();
  out.lost = 0;
  out.reasons.clear();
  return inRail_ ? nextInRail(out) : nextOutsideRail(out);
}

bool ProfileAssembler::nextRemark(std::uint64_t upTo, Assembly& out) {
  if (remarks_.empty() || remarks_.begin()->first > upTo) return false;
  lose(0, {remarks_.begin()->second}, out);
  remarks_.erase(remarks_.begin());
  return true;
}

bool ProfileAssembler::nextOutsideRail(Assembly& out) {
  if (nextRemark(allEnded() && rails_.empty() && pending_.empty() ? kEverything : cursor_, out)) return true;
  const std::uint64_t first = rails_.empty() ? kEverything : rails_.front().begin->firstTrigger;
  if (!pending_.empty() && pending_.begin()->first < first) {
    const std::uint64_t stray = pending_.begin()->first;
    if (stray >= settledBelow()) return false;
    recycle(pending_.begin());
    cursor_ = std::max(cursor_, stray + 1);
    lose(1, {"outside of a rail"}, out);
    return true;
  }
  return !rails_.empty() && beginRail(out);
}

bool ProfileAssembler::beginRail(Assembly& out) {
  inRail_ = true;
  cursor_ = std::max(cursor_, rails_.front().begin->firstTrigger);
  out.kind = Assembly::Kind::RailBegan;
  out.rail = rails_.front().begin;
  return true;
}

bool ProfileAssembler::nextInRail(Assembly& out) {
  if (nextRemark(cursor_, out)) return true;
  const std::optional<std::uint64_t> end = endOfRail();
  const std::uint64_t limit = std::min(settledBelow(), end.value_or(kEverything));
  if (cursor_ < limit) {
    const auto entry = pending_.begin();
    const std::uint64_t upTo = entry == pending_.end() ? limit : std::min(limit, entry->first);
    if (cursor_ < upTo) {  // a hole in the counts of all four
      // The end may not be known yet: what lies beyond the furthest camera is no trigger.
      lose(upTo - cursor_, {"missed by all cameras"}, out);
      cursor_ = upTo;
      return true;
    }
    settle(cursor_, *entry->second, out);
    recycle(entry);
    ++cursor_;
    return true;
  }
  if (!end || cursor_ < *end || !railPassed(*end)) return false;
  if (nextRemark(*end, out)) return true;
  endRail(out);
  return true;
}

void ProfileAssembler::endRail(Assembly& out) {
  out.kind = Assembly::Kind::RailEnded;
  out.rail = rails_.front().begin;
  lastEnded_ = rails_.front().key();
  rails_.pop_front();
  inRail_ = false;
}

void ProfileAssembler::lose(std::uint64_t count, std::vector<std::string> reasons, Assembly& out) {
  out.kind = Assembly::Kind::Lost;
  if (inRail_) out.rail = rails_.front().begin;
  out.lost = count;
  out.reasons = std::move(reasons);
}

std::string ProfileAssembler::reasonForEmptySlot(int camera, std::uint64_t trigger) const {
  const Stream& from = stream(camera);
  if (trigger < from.next) return "no frame";
  if (!from.ended) return "too late";  // given up
  return from.error.empty() ? kStopped : "source failed";
}

void ProfileAssembler::settle(std::uint64_t trigger, Pending& pending, Assembly& out) {
  bool anyPoints = false, stopped = false;
  for (int c = 0; c < kCameraCount; ++c) {
    Slot& slot = pending.slots[static_cast<std::size_t>(c)];
    if (slot.has) {
      slot.missing = slot.contour.missing;
      anyPoints = anyPoints || !slot.contour.points.empty();
    } else if (slot.missing.empty()) {
      slot.missing = reasonForEmptySlot(c, trigger);
    }
    stopped = stopped || slot.missing == kStopped;
  }
  // What a stop cut through is no profile: the cameras stop at different triggers.
  if (!anyPoints || stopped) {
    std::vector<std::string> reasons;
    for (int c = 0; c < kCameraCount; ++c) {
      const std::string& missing = pending.slots[static_cast<std::size_t>(c)].missing;
      if (!missing.empty()) reasons.push_back(cameraReason(c, missing));
    }
    lose(1, std::move(reasons), out);
    return;
  }
  out.kind = Assembly::Kind::Profile;
  out.rail = rails_.front().begin;
  join(trigger, pending, out.profile);
}

void ProfileAssembler::join(std::uint64_t trigger, Pending& pending, Profile& profile) const {
  const RailBegin& rail = *rails_.front().begin;
  profile.trigger = trigger;
  profile.positionMm = rail.beginsAtMm + static_cast<double>(trigger - rail.firstTrigger) * rail.spacingMm;
  profile.points.clear();
  profile.lineEnds.clear();
  double correlated = 0;
  for (std::size_t c = 0; c < kCameraCount; ++c) {
    Slot& slot = pending.slots[c];
    profile.missing[c] = slot.missing;
    profile.pointsOfCamera[c] = 0;
    profile.overloaded[c] = slot.has && slot.contour.overloaded;
    if (!slot.has || !slot.missing.empty()) continue;
    const auto before = static_cast<std::uint32_t>(profile.points.size());
    const auto count = static_cast<std::uint32_t>(slot.contour.points.size());
    profile.points.insert(profile.points.end(), slot.contour.points.begin(), slot.contour.points.end());
    for (const std::uint32_t end : slot.contour.lineEnds) profile.lineEnds.push_back(before + end);
    profile.pointsOfCamera[c] = count;
    correlated += static_cast<double>(slot.contour.correlatedPoints) * count;
  }
  profile.correlatedPoints =
      profile.points.empty() ? 1.0F : static_cast<float>(correlated / static_cast<double>(profile.points.size()));
}

void ProfileAssembler::recycle(std::map<std::uint64_t, std::unique_ptr<Pending>>::iterator entry) {
  for (Slot& slot : entry->second->slots) {
    slot.has = false;
    slot.missing.clear();
  }
  spent_.push_back(std::move(entry->second));
  pending_.erase(entry);
}

}  // namespace vignole
