#pragma once
// A line that is measured, as the screens see it: commands down, snapshots up. Everything here belongs to the window's
// thread; what comes from the engine's threads has passed a mailbox or a lock before.

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/acquisition/rail_announcement.h"
#include "engine/inspection/inspection.h"
#include "engine/inspection/latest_frames.h"
#include "engine/inspection/rail_summary.h"
#include "engine/recipe/recipe.h"
#include "gui/bridge/seam_watch.h"

namespace vignole {

enum class LineState {
  Idle,       ///< never started
  Armed,      ///< running, no rail in the gauge
  Measuring,  ///< profiles arrive
  Silent,     ///< a rail is in the gauge and no profile has come for a while
  Stopped,    ///< stopped by a person
  Fault,      ///< the source or the engine ended with an error
};

/// A camera that has given nothing for several triggers on end.
struct LostCamera {
  int camera = 0;  ///< 0..3 (people see 1..4)
  double fromM = 0;
  std::string reason;
};

/// A dimension that could not be measured for several profiles on end.
struct UnmeasuredDimension {
  Dimension dimension = Dimension::RH;
  double fromM = 0;
  std::string reason;
};

struct PassedRail {
  std::string id;
  Verdict verdict = Verdict::NotMeasured;
};

struct LineSnapshot {
  LineState state = LineState::Idle;
  std::string error;               ///< of Fault
  const Recipe* recipe = nullptr;  ///< never null
  std::string nextRecipe;          ///< "60E1 X/A v3", in force from the next rail; empty: the same
  std::string calibrationMethod;
  bool simulation = true;
  std::shared_ptr<const ProfileResult> latest;  ///< null: no profile yet
  double ageS = 0;                              ///< of `latest`
  std::shared_ptr<const RailSummary> rail;      ///< the rail of `latest` so far; null: no rail yet
  std::vector<LostCamera> lostCameras;
  std::vector<UnmeasuredDimension> unmeasured;
  std::vector<PassedRail> passed;                ///< oldest first, the last dozen
  std::uint64_t railsPassed = 0, railsGood = 0;  ///< since the program started
  double profilesPerS = 0, expectedPerS = 0;
  std::uint64_t recentIncomplete = 0;  ///< triggers not measured completely on this rail
  std::vector<StageStatistics> stages;
  TriggerLedger triggers;                    ///< like `stages`, since the line was started or its settings changed
  std::optional<StripeSettings> nextStripe;  ///< waits for the next rail
  std::shared_ptr<const DriftTrack> drift;   ///< null: nobody watches the seams

  /// Values are no longer live: they are shown grey, with their age.
  [[nodiscard]] bool held() const { return latest && state != LineState::Measuring && ageS > 1.0; }
};

/// Makes the picture that a camera took at a trigger once more, as it was (0 ms) or with another exposure: bit by bit
/// the same. Any thread; slow. Empty: there is none.
using PictureAgain = std::function<std::optional<Frame>(int camera, std::uint64_t trigger, double exposureMs)>;

/// How much a pull brings up to date: the newest profile, or summaries and counters as well.
enum class PullDetail { Profile, Everything };

class Line {
 public:
  virtual ~Line() = default;
  virtual void start() = 0;
  virtual void stop() = 0;  ///< asks and returns at once
  [[nodiscard]] virtual bool running() const = 0;
  /// Valid until the next pull. Cheap: called on every display tick.
  [[nodiscard]] virtual const LineSnapshot& pull(PullDetail detail) = 0;
  /// The cameras' latest frames with their lines; null: this line hands out none.
  [[nodiscard]] virtual std::shared_ptr<LatestFrames> frames() { return nullptr; }
  /// Of the rails since the last start; empty: what was not kept is gone.
  [[nodiscard]] virtual PictureAgain pictureAgain() { return {}; }
  [[nodiscard]] virtual std::optional<double> exposureMs() const { return {}; }  ///< empty: not told
  /// From the next start on. Only where pictures can be made again.
  virtual void useExposure(double /*exposureMs*/) {}
  /// The one that is measured with, or will be from the next rail on; without an id: the line does not tell.
  [[nodiscard]] virtual RigCalibration calibration() { return {}; }
  /// From the next rail on; the running rail keeps what it began with.
  virtual void useCalibration(const RigCalibration& /*calibration*/) {}
  /// Of the virtual rig that stands in for cameras; empty: there are cameras.
  [[nodiscard]] virtual std::optional<std::uint64_t> virtualRigSeed() const { return {}; }
  /// From the next rail on; the running rail keeps what it began with. Settings are checked().
  virtual void useStripeSettings(const StripeSettings& /*settings*/) {}
  /// From the next rail on; the running rail keeps what it began with. Refuses what the line cannot measure.
  [[nodiscard]] virtual Expected<void> useRecipe(const Recipe& /*recipe*/) {
    return inputError("recipe", "this line keeps the one it was started with");
  }
  /// Where the papers of the next rail are handed in; null: the line takes none.
  [[nodiscard]] virtual RailAnnouncements* announcements() { return nullptr; }
};

}  // namespace vignole
