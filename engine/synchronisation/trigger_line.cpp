#include "engine/synchronisation/trigger_line.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vignole {

namespace {
constexpr std::size_t kArrivalsRemembered = 32;
constexpr const char* kLost = "frame lost";
constexpr const char* kNone = "no frame";  // before its first, while others had some
}  // namespace

TriggerLine::TriggerLine(TriggerLineSettings settings) : settings_(std::move(settings)) {
  settings_.beginAfter = std::max(settings_.beginAfter, 1);
  settings_.endAfter = std::max(settings_.endAfter, 1);
  settings_.giveUpAfter = std::max<std::uint64_t>(settings_.giveUpAfter, 1);
  if (!settings_.railId) settings_.railId = [](std::uint64_t n) { return "rail-" + std::to_string(n); };
}

TriggerLine::View TriggerLine::Row::view() const {
  bool any = false;
  for (const Slot& slot : slots) {
    if (!slot.frame) continue;
    if (slot.railInView) return View::Rail;  // one camera is enough: the others may be blind
    any = true;
  }
  return any ? View::Nothing : View::Unknown;
}

std::uint64_t TriggerLine::next() const {
  std::uint64_t furthest = cursor_;
  for (const Camera& c : cameras_) furthest = std::max(furthest, c.next);
  return furthest;
}

std::uint64_t TriggerLine::behind(int camera) const {
  const std::uint64_t furthest = next();
  return furthest - std::min(at(camera).next, furthest);
}

double TriggerLine::triggersPerS() const {
  if (arrivals_.size() < 2) return 0;
  const Arrival &a = arrivals_.front(), &b = arrivals_.back();
  return b.s > a.s ? static_cast<double>(b.trigger - a.trigger) / (b.s - a.s) : 0;
}

// ---- what comes in

void TriggerLine::add(Frame frame, bool railInView, double arrivedS) {
  if (ended_) return;
  Camera& from = at(frame.camera);
  const std::uint64_t trigger = frame.trigger;
  if (from.began && trigger < from.next) {
    const auto row = waiting_.find(trigger);
    const bool has = row != waiting_.end() && row->second.slots[static_cast<std::size_t>(frame.camera)].frame;
    ++(has ? counts_.repeatedFrames : counts_.lateFrames);
    return;
  }
  if (from.justBack || from.down) {
    // What it missed while it was away was lost with it.
    const std::uint64_t begin = std::max({from.next, cursor_, trigger - std::min(trigger, settings_.giveUpAfter)});
    if (open_ && trigger > begin) lose(frame.camera, trigger, trigger - begin, from.downReason);
    from.justBack = from.down = false;
  }
  if (arrivals_.empty() || trigger > arrivals_.back().trigger) {
    arrivals_.push_back({trigger, arrivedS});
    if (arrivals_.size() > kArrivalsRemembered) arrivals_.pop_front();
  }
  if (!from.began) from.first = trigger;
  from.began = true;
  from.next = trigger + 1;
  if (trigger < cursor_) {  // given up before it came
    ++counts_.lateFrames;
    return;
  }
  Row& row = waiting_[trigger];
  row.trigger = trigger;
  Slot& slot = row.slots[static_cast<std::size_t>(frame.camera)];
  slot.railInView = railInView;
  slot.frame = std::move(frame);
  settle();
}

void TriggerLine::lose(int camera, std::uint64_t next, std::uint64_t count, const std::string& reason) {
  for (std::uint64_t t = next - std::min(count, next); t < next; ++t) {
    if (t < cursor_) continue;
    Row& row = waiting_[t];
    row.trigger = t;
    Slot& slot = row.slots[static_cast<std::size_t>(camera)];
    if (!slot.frame && slot.reason.empty()) slot.reason = reason;
  }
}

void TriggerLine::setDown(int camera, std::string reason) {
  Camera& c = at(camera);
  c.down = true;
  c.justBack = false;
  c.downReason = std::move(reason);
  settle();
}

void TriggerLine::setUp(int camera) {
  Camera& c = at(camera);
  if (!c.down) return;
  // Still not waited for: when its first frame comes is not known. That frame ends it.
  c.justBack = true;
}

void TriggerLine::restartCounts() {
  for (int c = 0; c < static_cast<int>(kCameras); ++c)
    if (!at(c).down) setDown(c, "counted anew");  // what waits is settled as it is
  for (const auto& [trigger, row] : waiting_)
    for (const Slot& slot : row.slots) counts_.framesOfLostCounts += slot.frame ? 1U : 0U;
  waiting_.clear();
  const std::uint64_t furthest = next();
  if (inRail_) endRail(held_.empty() ? furthest : held_.front().trigger);
  dropHeld();
  arrivals_.clear();
  cursor_ = furthest;
  open_ = false;
  for (Camera& c : cameras_) {
    c.next = furthest;
    c.began = false;
  }
}

// ---- settling, in the order of the triggers

void TriggerLine::open() {
  for (const Camera& c : cameras_)
    if (!c.down && !c.began && waiting_.size() < settings_.giveUpAfter) return;
  if (waiting_.empty()) return;
  cursor_ = std::max(cursor_, waiting_.begin()->first);
  open_ = true;
}

bool TriggerLine::settled(std::uint64_t trigger) const {
  const std::uint64_t furthest = next();
  if (trigger >= furthest) return false;
  if (furthest - trigger > settings_.giveUpAfter) return true;
  return std::all_of(cameras_.begin(), cameras_.end(), [&](const Camera& c) { return c.down || c.next > trigger; });
}

void TriggerLine::settle() {
  if (!open_) open();
  if (!open_) return;
  while (!ended_ && settled(cursor_)) {
    Row row;
    if (const auto found = waiting_.find(cursor_); found != waiting_.end()) {
      row = std::move(found->second);
      waiting_.erase(found);
    }
    row.trigger = cursor_;
    for (std::size_t c = 0; c < kCameras; ++c) {
      Slot& slot = row.slots[c];
      if (slot.frame || !slot.reason.empty()) continue;
      const Camera& from = cameras_[c];
      slot.reason = from.down              ? from.downReason
                    : from.next <= cursor_ ? "too late"
                    : cursor_ < from.first ? kNone
                                           : kLost;
    }
    ++cursor_;
    if (row.view() == View::Unknown) ++counts_.seenByNone;
    judge(std::move(row));
  }
}

// ---- rails

void TriggerLine::judge(Row row) {
  const View view = row.view();
  if (!inRail_) {
    if (view == View::Rail) {
      ++run_;
      held_.push_back(std::move(row));
      if (run_ >= settings_.beginAfter) beginRail();
    } else if (view == View::Unknown && !held_.empty()) {
      held_.push_back(std::move(row));
    } else {
      held_.push_back(std::move(row));
      dropHeld();
    }
    return;
  }
  if (settings_.lengthMm > 0) {
    const auto most =
        static_cast<std::uint64_t>(std::max(1.0, std::floor(settings_.lengthMm / settings_.spacingMm + 1e-9)));
    if (row.trigger - railFirst_ >= most) {
      emitHeld();
      endRail(railFirst_ + most);
      if (!ended_) judge(std::move(row));
      return;
    }
  }
  if (view == View::Rail) {
    emitHeld();
    emit(std::move(row));
  } else if (view == View::Unknown && held_.empty()) {
    emit(std::move(row));
  } else {
    if (view == View::Nothing) ++run_;
    held_.push_back(std::move(row));
    if (run_ >= settings_.endAfter) {
      endRail(held_.front().trigger);
      dropHeld();
    }
  }
}

void TriggerLine::dropHeld() {
  counts_.outsideRails += held_.size();
  held_.clear();
  run_ = 0;
}

void TriggerLine::beginRail() {
  inRail_ = true;
  railFirst_ = held_.front().trigger;
  RailBegin begin;
  begin.id = settings_.railId(++counts_.rails);
  begin.heat = settings_.heat;
  begin.sectionName = settings_.sectionName;
  begin.firstTrigger = railFirst_;
  begin.spacingMm = settings_.spacingMm;
  begin.speedMmPerS = triggersPerS() * settings_.spacingMm;
  begin.temperatureC = settings_.temperatureC;
  begin.temperatureUncertaintyC = settings_.temperatureUncertaintyC;
  tellAll(begin);
  emitHeld();
}

void TriggerLine::endRail(std::uint64_t endTrigger) {
  inRail_ = false;
  run_ = 0;
  tellAll(RailEnd{endTrigger});
  if (settings_.rails == 0 || counts_.rails < settings_.rails) return;
  ended_ = true;
  waiting_.clear();
  tellAll(SourceEnd{});
}

void TriggerLine::emitHeld() {
  run_ = 0;
  for (Row& row : held_) emit(std::move(row));
  held_.clear();
}

void TriggerLine::emit(Row row) {
  ++counts_.inRails;
  for (std::size_t c = 0; c < kCameras; ++c) {
    Slot& slot = row.slots[c];
    if (slot.frame) {
      cameras_[c].out.emplace_back(std::move(*slot.frame));
    } else {
      cameras_[c].out.emplace_back(FrameLost{static_cast<int>(c), row.trigger, std::move(slot.reason)});
    }
  }
}

void TriggerLine::tellAll(const FrameMessage& message) {
  for (Camera& c : cameras_) c.out.push_back(message);
}

std::optional<FrameMessage> TriggerLine::take(int camera) {
  auto& out = at(camera).out;
  if (out.empty()) return {};
  FrameMessage message = std::move(out.front());
  out.pop_front();
  return message;
}

}  // namespace vignole
