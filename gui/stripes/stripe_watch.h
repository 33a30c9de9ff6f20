#pragma once
// The four cameras' pictures for the screen, at display rate, from a thread of its own: what the engine took and the
// lines it measures with; where asked, the same pictures extracted with settings on trial. Nothing that is tried
// touches what is measured, and the engine waits for nothing.

#include <QSize>
#include <array>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "engine/optics/calibration.h"
#include "engine/recipe/recipe.h"
#include "gui/bridge/latest_value.h"
#include "gui/bridge/line.h"
#include "gui/stripes/stripe_picture.h"

namespace vignole {

struct LineTrial {
  StripeSettings stripe;  ///< checked()
  double exposureMs = 0;  ///< 0: as the picture was taken
};

class StripeWatch {
 public:
  /// Calibration and section give the lines their field, as they do in the engine.
  StripeWatch(std::shared_ptr<LatestFrames> frames, const RigCalibration& calibration, const Section& section,
              const StripeSettings& inUse);
  ~StripeWatch();
  StripeWatch(const StripeWatch&) = delete;
  StripeWatch& operator=(const StripeWatch&) = delete;

  void setLooking(bool looking);
  void setFrozen(bool frozen);  ///< the pictures stay; settings on trial still act on them
  /// The pictures of this trigger, held or made again; frozen from then on. A camera that has none shows none.
  void showTrigger(std::uint64_t trigger, PictureAgain again);
  void setInUse(const StripeSettings& settings);
  /// Another exposure needs `again`.
  void setTrial(const std::optional<LineTrial>& settings, PictureAgain again = {});
  void setViewSize(int camera, const QSize& pixels);
  /// Where the light plane can be seen, px.
  [[nodiscard]] QPolygonF field(int camera) const;
  /// Of each camera its newest picture, all from one look at the cameras; null if nothing has changed since it was
  /// taken. A camera's is null before its first, and without pixels where there is none of the trigger asked for.
  using Pictures = std::array<std::shared_ptr<const StripePicture>, kCameraCount>;
  [[nodiscard]] std::shared_ptr<const Pictures> takeNew() { return pictures_.takeNew(); }

 private:
  using PerCamera = std::array<LatestFrames::Held, kCameraCount>;
  struct Orders {
    bool looking = false, frozen = false;
    std::optional<std::uint64_t> trigger;  ///< to be shown
    StripeSettings inUse;
    std::optional<LineTrial> trial;
    PictureAgain again;
    std::array<QSize, kCameraCount> sizes;
  };
  void order(const std::function<void(Orders&)>& change);
  void run(const std::stop_token& stop);
  [[nodiscard]] PerCamera ofTrigger(const Orders& orders) const;
  [[nodiscard]] LatestFrames::Held extracted(int camera, Frame frame, const StripeSettings& settings) const;
  [[nodiscard]] std::optional<StripeTrial> tried(const Orders& orders, const LatestFrames::Held& taken,
                                                 double stepPx) const;

  const std::shared_ptr<LatestFrames> frames_;
  std::optional<FramesWatcher> watcher_;
  std::array<StripeOptics, kCameraCount> optics_;
  LatestValue<Pictures> pictures_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  Orders orders_;
  bool changed_ = false;
  std::jthread thread_;
};

}  // namespace vignole
