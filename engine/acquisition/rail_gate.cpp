#include "engine/acquisition/rail_gate.h"

#include <algorithm>
#include <utility>

namespace vignole {

void RailGate::close() {
  const std::scoped_lock lock(mutex_);
  closing_ = true;
}

void RailGate::open() {
  const std::scoped_lock lock(mutex_);
  closing_ = false;
  closedAt_.reset();
  held_ = {};
}

FrameMessage RailGate::next(int camera, std::stop_token stop) {
  const auto c = static_cast<std::size_t>(camera);
  {
    const std::scoped_lock lock(mutex_);
    if (held_[c]) return SourceEnd{};
  }
  FrameMessage message = source_.next(camera, std::move(stop));
  const RailEnd* end = std::get_if<RailEnd>(&message);
  if (end == nullptr) return message;
  const std::scoped_lock lock(mutex_);
  if (closing_ && !closedAt_ && end->endTrigger > *std::max_element(passed_.begin(), passed_.end()))
    closedAt_ = end->endTrigger;
  passed_[c] = end->endTrigger;
  held_[c] = closedAt_ && end->endTrigger >= *closedAt_;
  return message;
}

}  // namespace vignole
