#include "engine/synchronisation/frame_tagger.h"

#include <algorithm>

namespace vignole {

namespace {
constexpr std::uint64_t kShortIds = 65535;   // 1 .. 65535, 0 is not used
constexpr std::uint64_t kMostMissed = 1000;  // more at once is no missed trigger but a wrong number
constexpr int kBelieved = 3;
}  // namespace

std::int64_t FrameIds::step(std::uint64_t id) const {
  if (!any_) return 1;
  const auto d = static_cast<std::int64_t>(id) - static_cast<std::int64_t>(last_);
  constexpr auto kPeriod = static_cast<std::int64_t>(kShortIds);
  if (last_ > kShortIds || id > kShortIds) return d;
  // Both may be short: the nearer way round. 64-bit ids pass here once, from 65535 to 65536.
  if (d < -kPeriod / 2) return d + kPeriod;
  if (d > kPeriod / 2) return d - kPeriod;
  return d;
}

std::int64_t FrameIds::take(std::uint64_t id) {
  place_ = any_ ? place_ + step(id) : 0;
  any_ = true;
  last_ = id;
  return place_;
}

FrameTag FrameTagger::goOn(std::int64_t place, std::uint64_t between, std::uint64_t notSent) {
  FrameTag tag;
  tag.place = place;
  tag.missed = std::min(notSent, between);
  tag.incomplete = std::min(damaged_, between - tag.missed);
  tag.lost = between - tag.missed - tag.incomplete;
  damaged_ = 0;
  doubt_ = {};
  return tag;
}

void FrameTagger::start(std::uint64_t id, std::uint64_t count) {
  ids_ = {};
  ids_.take(id);
  count_ = count;
}

FrameTag FrameTagger::doubt(std::uint64_t id, std::uint64_t count) {
  const bool goesOn = doubt_.frames > 0 && count > doubt_.count && count - doubt_.count <= kMostMissed;
  doubt_ = {id, count, goesOn ? doubt_.frames + 1 : 1};
  FrameTag tag;
  tag.kind = FrameTag::Kind::Implausible;
  if (doubt_.frames < kBelieved) return tag;
  start(id, count);
  tag = goOn(static_cast<std::int64_t>(count), 0, 0);
  tag.kind = FrameTag::Kind::Restarted;
  return tag;
}

FrameTag FrameTagger::add(std::uint64_t id, std::optional<std::uint64_t> count) {
  if (!count) {
    const std::int64_t step = ids_.step(id);
    FrameTag tag;
    if (ids_.any() && step <= 0) {
      tag.kind = FrameTag::Kind::Repeated;
      return tag;
    }
    const bool first = !ids_.any();
    const std::int64_t place = ids_.take(id);
    return goOn(place, first ? 0 : static_cast<std::uint64_t>(step - 1), 0);
  }
  if (!ids_.any()) {
    start(id, *count);
    // What arrived damaged before the first good frame was of the triggers before it.
    return goOn(static_cast<std::int64_t>(*count), std::min(damaged_, *count), 0);
  }
  const std::int64_t step = ids_.step(id);
  if (*count == count_ && step == 0) {
    FrameTag tag;
    tag.kind = FrameTag::Kind::Repeated;
    return tag;
  }
  if (*count <= count_) return doubt(id, *count);
  const std::uint64_t between = *count - count_ - 1;
  // Ids may begin anew while the count goes on (a stream that was restarted): then only the count is believed.
  const std::uint64_t sent = step >= 1 ? std::min(static_cast<std::uint64_t>(step - 1), between) : 0;
  if (between - sent > kMostMissed) return doubt(id, *count);
  ids_.take(id);
  count_ = *count;
  // Without a step of the ids that explains them, damaged frames are what is known to have been sent.
  return goOn(static_cast<std::int64_t>(*count), between, between - sent);
}

}  // namespace vignole
