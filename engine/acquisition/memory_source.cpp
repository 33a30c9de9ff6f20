#include "engine/acquisition/memory_source.h"

#include <cassert>
#include <utility>

namespace vignole {

MemorySource::MemorySource(std::vector<FrameSet> sets, std::shared_ptr<const void> owner, MemorySourceSettings settings)
    : sets_(std::move(sets)), owner_(std::move(owner)), settings_(std::move(settings)) {
  assert(!sets_.empty());
}

bool MemorySource::waitForTrigger(std::uint64_t trigger, const std::stop_token& stop) {
  if (settings_.rateHz <= 0) return !stop.stop_requested();
  std::call_once(started_, [this] { start_ = std::chrono::steady_clock::now(); });
  const auto due = start_ + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                std::chrono::duration<double>(static_cast<double>(trigger) / settings_.rateHz));
  std::unique_lock lock(mutex_);
  stopped_.wait_until(lock, stop, due, [] { return false; });
  return !stop.stop_requested();
}

FrameMessage MemorySource::next(int camera, std::stop_token stop) {
  Stream& stream = streams_[static_cast<std::size_t>(camera)];
  if (stop.stop_requested() || stream.rail >= settings_.rails) return SourceEnd{};
  if (!stream.inRail) {
    stream.inRail = true;
    RailBegin begin = settings_.rail;
    begin.firstTrigger = stream.trigger;
    if (settings_.rails > 1) begin.id += "-" + std::to_string(stream.rail + 1);
    return begin;
  }
  if (stream.trigger == (stream.rail + 1) * settings_.profiles) {
    stream.inRail = false;
    ++stream.rail;
    return RailEnd{stream.trigger};
  }
  if (!waitForTrigger(stream.trigger, stop)) return SourceEnd{};
  const std::uint64_t trigger = stream.trigger++;
  return Frame{camera, trigger, sets_[trigger % sets_.size()][static_cast<std::size_t>(camera)], owner_};
}

}  // namespace vignole
