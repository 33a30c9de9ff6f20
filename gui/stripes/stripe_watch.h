#pragma once
// Frames and their lines for the screen, extracted again in a thread of its own with the settings in use and, where
// asked, with others on trial: the engine is not slowed and nothing that is tried touches what is measured.

#include <QImage>
#include <array>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "engine/optics/calibration.h"
#include "engine/recipe/recipe.h"
#include "engine/stripe/stripe.h"
#include "gui/bridge/frame_tap.h"

namespace vignole {

struct ExtractedLine {
  StripeResult stripe;
  double ms = 0;
};

struct StripePicture {
  int camera = 0;
  std::uint64_t trigger = 0;
  QImage image;  ///< as the camera gave it
  ExtractedLine inUse;
  std::optional<ExtractedLine> trial;
};

class StripeWatch {
 public:
  /// Looks at `frames` from now on; calibration and section give the lines their field.
  StripeWatch(std::shared_ptr<LatestFrames> frames, RigCalibration calibration, Section section, StripeSettings inUse);
  ~StripeWatch();

  void setInUse(const StripeSettings& settings);
  void setTrial(const std::optional<StripeSettings>& settings);
  void setFrozen(bool frozen);  ///< the pictures stay, settings on trial still act on them
  void setLooking(bool looking);
  /// The newest picture of a camera if it has not been taken before, else null.
  [[nodiscard]] std::shared_ptr<const StripePicture> take(int camera);

 private:
  void run(const std::stop_token& stop);

  std::shared_ptr<LatestFrames> frames_;
  RigCalibration calibration_;
  Section section_;
  std::array<LatestValue<StripePicture>, kCameraCount> pictures_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  StripeSettings inUse_;
  std::optional<StripeSettings> trial_;
  bool frozen_ = false, looking_ = false, changed_ = false;
  std::jthread thread_;
};

}  // namespace vignole
