#pragma once
// Four GigE Vision cameras as one source of frames: opened together, matched by trigger, each watched and opened again
// by itself while the others go on.

#include <array>
#include <memory>
#include <vector>

#include "engine/acquisition/frame.h"
#include "engine/gige_camera/camera_counters.h"
#include "engine/gige_camera/gige_settings.h"
#include "engine/synchronisation/camera_watch.h"
#include "engine/synchronisation/rail_presence.h"
#include "engine/synchronisation/trigger_line.h"

namespace vignole {

struct GigeSourceSettings {
  std::array<GigeCameraSettings, 4> cameras;
  TriggerLineSettings line;
  RailPresenceSettings presence;
  CameraWatchSettings watch;
  std::size_t inboxFrames = 24;  ///< of a camera, before one more is an overflow
  bool allAtStart = true;        ///< a camera that cannot be opened ends open(); false: it is opened when it comes
};

/// next() as FrameSource says. Everything else from any thread. Frames that are out stay valid after it is gone.
class GigeSource : public FrameSource {
 public:
  /// Opens all four at once, arms them, then lets them be triggered: takes about a second, and as long as a camera's
  /// heartbeat timeout if the last program that controlled it died. Errors name the camera.
  [[nodiscard]] static Expected<std::unique_ptr<GigeSource>> open(GigeSourceSettings settings);
  ~GigeSource() override;

  [[nodiscard]] FrameMessage next(int camera, std::stop_token stop) override;
  [[nodiscard]] bool live() const override { return true; }

  [[nodiscard]] std::vector<CameraReport> cameras() const;
  [[nodiscard]] TriggerLineCounts counts() const;
  [[nodiscard]] double triggersPerS() const;

 private:
  struct Impl;
  explicit GigeSource(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Opens the four as far as their identity, checks the serials, and gives them back.
[[nodiscard]] std::array<Expected<GigeIdentity>, 4> identify(const std::array<GigeCameraSettings, 4>& cameras);

/// Everything that answers on the networks of this computer: asks by broadcast, takes a second.
[[nodiscard]] std::vector<GigeIdentity> discover();

}  // namespace vignole
