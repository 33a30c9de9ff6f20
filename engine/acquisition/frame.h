#pragma once
// Frames and where they come from. Frames of the four cameras belong together by their trigger count, never by time.

#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>
#include <variant>

#include "engine/geometry/expected.h"
#include "engine/geometry/image_view.h"

namespace vignole {

/// One picture of one camera. The pixels stay valid as long as `lease` lives; releasing it gives the buffer back.
struct Frame {
  int camera = 0;             ///< 0..3 (people see 1..4)
  std::uint64_t trigger = 0;  ///< count of the trigger since the source started, 0 is the first
  ImageView image;
  std::shared_ptr<const void> lease;
};

/// A trigger whose frame this camera knows to be lost or damaged.
struct FrameLost {
  int camera = 0;
  std::uint64_t trigger = 0;
  std::string reason;  ///< one of few words, counted as such: "frame lost", "incomplete", "queue overflow"
};

/// A rail begins at `firstTrigger`. Sent by every camera's stream before the first frame of the rail.
struct RailBegin {
  std::string id, heat, sectionName;
  std::uint64_t firstTrigger = 0;
  double spacingMm = 15;   ///< travel between triggers
  double lengthMm = 0;     ///< 0: not known yet
  double speedMmPerS = 0;  ///< 0: not known
  double temperatureC = 20;
  double temperatureUncertaintyC = 1;
  double beginsAtMm = 0;  ///< where on the rail the first trigger lies: not its head if only a part of it comes
};

/// All triggers of the rail up to `endTrigger` (exclusive) have been issued. Sent by every camera's stream.
struct RailEnd {
  std::uint64_t endTrigger = 0;
};

/// Nothing more will come; with an error if the source failed.
struct SourceEnd {
  std::string error;
};

using FrameMessage = std::variant<Frame, FrameLost, RailBegin, RailEnd, SourceEnd>;

/// Four streams of frames. next(camera, stop) is called by one thread per camera, blocks until there is a message,
/// returns SourceEnd soon after a stop request, and keeps each camera's messages in the order of their triggers.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  [[nodiscard]] virtual FrameMessage next(int camera, std::stop_token stop) = 0;
  /// Live sources cannot wait: a full queue behind them drops and counts. Others are held back.
  [[nodiscard]] virtual bool live() const = 0;
};

}  // namespace vignole
