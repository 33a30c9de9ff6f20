#pragma once
// Pictures by camera and trigger, for whoever shows them as if cameras took them: rendered, or out of a recording.

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>

#include "engine/geometry/image_view.h"

namespace vignole {

/// The pixels stay valid and unchanged as long as `lease` lives. Empty: there is no picture of this trigger.
struct ProvidedFrame {
  ImageView image;
  std::shared_ptr<const void> lease;
};

/// Any thread, any order; the triggers of a run are mostly asked for one after the other.
class FrameProvider {
 public:
  virtual ~FrameProvider() = default;
  FrameProvider() = default;
  FrameProvider(const FrameProvider&) = delete;
  FrameProvider& operator=(const FrameProvider&) = delete;

  /// Waits until the pictures of that trigger are at hand in all cameras, so that frame() will not wait, and goes on
  /// with those behind it meanwhile. False if stopped before.
  virtual bool prepare(std::uint64_t trigger, std::stop_token stop) = 0;
  /// Takes as long as it takes if it was not prepared. Empty soon after a stop request.
  [[nodiscard]] virtual ProvidedFrame frame(int camera, std::uint64_t trigger, std::stop_token stop) = 0;
  /// Whether a rail is in the rig at that trigger: what a light barrier says.
  [[nodiscard]] virtual bool railPresent(std::uint64_t /*trigger*/) const { return true; }
  /// How many triggers there are; nothing: without end.
  [[nodiscard]] virtual std::optional<std::uint64_t> triggers() const { return {}; }
};

}  // namespace vignole
