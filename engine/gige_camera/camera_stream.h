#pragma once
// One stream of a camera, from one start to the next: buffers, Aravis' receiving thread and what is done in it. Only
// for this room.

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>

#include "engine/geometry/expected.h"
#include "engine/gige_camera/arv_objects.h"
#include "engine/gige_camera/camera_counters.h"
#include "engine/gige_camera/camera_inbox.h"

namespace vignole::gige {

struct StreamSettings {
  std::uint64_t epoch = 0;
  CountSource count = CountSource::FrameId;
  std::uint64_t tickHz = 1'000'000'000;  ///< of the timestamp
  bool railLineFromChunk = false;
  std::string where;  ///< "camera 1 (127.0.0.11)"
};

/// Kept alive by every frame that is out. In the receiving thread only: take the buffer, look at its status and
/// numbers, hand it over.
class CameraStream : public std::enable_shared_from_this<CameraStream> {
 public:
  [[nodiscard]] static Expected<std::shared_ptr<CameraStream>> open(ArvCamera* camera,
                                                                    const GigeCameraSettings& camera_,
                                                                    StreamSettings settings,
                                                                    std::shared_ptr<CameraInbox> inbox);
  ~CameraStream();
  CameraStream(const CameraStream&) = delete;
  CameraStream& operator=(const CameraStream&) = delete;

  /// Ends the receiving thread: nothing is handed over any more. Frames that are out stay valid.
  void close();
  /// How long a frame whose packets are missing is waited for, and all behind it with it.
  void setRetention(int ms);
  /// Adds what this stream counted.
  void addTo(CameraCounters& counters) const;
  [[nodiscard]] double lastFrameS() const { return lastFrameS_.load(std::memory_order_relaxed); }

 private:
  CameraStream(const GigeCameraSettings& camera, StreamSettings settings, std::shared_ptr<CameraInbox> inbox);
  static void called(void* self, ArvStreamCallbackType type, ArvBuffer* buffer);
  void done();
  void handOver(ArvBuffer* buffer);
  [[nodiscard]] std::optional<std::uint64_t> countOf(ArvBuffer* buffer);
  [[nodiscard]] bool railLineOf(ArvBuffer* buffer);
  void countFailure(ArvBufferStatus status);

  const GigeCameraSettings camera_;
  const StreamSettings settings_;
  std::shared_ptr<CameraInbox> inbox_;
  Owned<ArvStream> stream_;
  Owned<ArvChunkParser> chunks_;
  FrameTagger tagger_;
  bool closed_ = false;
  std::atomic<double> lastFrameS_ = -1;
  mutable std::mutex countersMutex_;
  CameraCounters counters_;
};

}  // namespace vignole::gige
