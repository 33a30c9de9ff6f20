#include "engine/recording/recording_source.h"

#include <array>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <utility>

#include "engine/acquisition/frame_pool.h"

namespace vignole {

namespace {

using Clock = std::chrono::steady_clock;

class RecordingSource final : public FrameSource {
 public:
  RecordingSource(std::shared_ptr<const Recording> recording, const RecordingSourceSettings& settings)
      : recording_(std::move(recording)), settings_(settings) {
    for (const ChunkPlace& chunk : recording_->chunks())
      if (chunk.head.kind == ChunkKind::Frame && (!firstUs_ || chunk.head.timeUs < *firstUs_))
        firstUs_ = chunk.head.timeUs;
  }

  FrameMessage next(int camera, std::stop_token stop) override {
    Stream& stream = streams_[static_cast<std::size_t>(camera)];
    const std::vector<RecordedEvent>& events = recording_->events(camera);
    if (stop.stop_requested()) return SourceEnd{};
    if (stream.next >= events.size()) return SourceEnd{recording_->endError(camera)};
    const RecordedEvent& event = events[stream.next++];
    switch (event.kind) {
      case RecordedEvent::Kind::RailBegin:
        return recording_->rails()[event.chunk].begin.rail;
      case RecordedEvent::Kind::RailEnd:
        return RailEnd{event.trigger};
      case RecordedEvent::Kind::Dropped:
        return FrameLost{camera, event.trigger, "not recorded"};
      case RecordedEvent::Kind::Lost: {
        const auto reason = recording_->read(recording_->chunks()[event.chunk]);
        const bool known = reason && reason->size() <= kLongestReason;
        return FrameLost{camera, event.trigger,
                         known ? std::string(reason->begin(), reason->end()) : std::string("damaged recording")};
      }
      case RecordedEvent::Kind::Frame:
        break;
    }
    return frame(camera, stream, event, stop);
  }

  [[nodiscard]] bool live() const override { return false; }

 private:
  static constexpr std::size_t kLongestReason = 200;
  struct Stream {
    std::size_t next = 0;
    std::shared_ptr<FramePool> pool;
    FrameUnpacker unpacker;
  };

  FrameMessage frame(int camera, Stream& stream, const RecordedEvent& event, const std::stop_token& stop) {
    const ChunkPlace& chunk = recording_->chunks()[event.chunk];
    if (settings_.paced && !waitUntil(due(chunk.head.timeUs), stop)) return SourceEnd{};
    const FrameLost damaged{camera, event.trigger, "damaged recording"};
    const auto packed = recording_->read(chunk);
    const auto size = packed ? packedSize(*packed) : Expected<FrameSize>(tl::unexpected(packed.error()));
    if (!size) return damaged;
    const std::size_t bytes = static_cast<std::size_t>(size->width) * static_cast<std::size_t>(size->height);
    if (!stream.pool || stream.pool->bytes() < bytes)
      stream.pool = std::make_shared<FramePool>(std::max<std::size_t>(1, settings_.buffers), bytes);
    const std::shared_ptr<std::uint8_t[]> buffer = stream.pool->take(stop);
    if (!buffer) return SourceEnd{};
    const MutableImageView image{buffer.get(), size->width, size->height, size->width};
    if (!stream.unpacker.unpack(*packed, image)) return damaged;
    return Frame{camera, event.trigger, image, buffer};
  }

  Clock::time_point due(std::int64_t timeUs) {
    const std::lock_guard lock(mutex_);
    if (!start_) start_ = Clock::now();
    // A clock that was set meanwhile must not hold the replay up for ever.
    constexpr std::int64_t kLongestUs = std::int64_t{3600} * 1'000'000;
    const std::int64_t since = std::clamp<std::int64_t>(timeUs / 2 - firstUs_.value_or(timeUs) / 2, 0, kLongestUs) * 2;
    return *start_ + std::chrono::microseconds(since);
  }

  bool waitUntil(Clock::time_point time, const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    never_.wait_until(lock, stop, time, [] { return false; });
    return !stop.stop_requested();
  }

  std::shared_ptr<const Recording> recording_;
  RecordingSourceSettings settings_;
  std::array<Stream, kCameraCount> streams_;  // each by its camera's thread only
  std::mutex mutex_;
  std::condition_variable_any never_;
  std::optional<Clock::time_point> start_;
  std::optional<std::int64_t> firstUs_;
};

}  // namespace

std::unique_ptr<FrameSource> makeRecordingSource(std::shared_ptr<const Recording> recording,
                                                 const RecordingSourceSettings& settings) {
  return std::make_unique<RecordingSource>(std::move(recording), settings);
}

}  // namespace vignole
