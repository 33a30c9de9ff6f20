#pragma once
// The paper's Fig. 2: acquire, extract, translate four times in parallel, then assemble, then measure; fourteen
// elements with bounded queues between them. The only place in the measuring path where a thread starts.

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "engine/acquisition/frame.h"
#include "engine/measurement/measurement.h"
#include "engine/optics/calibration.h"
#include "engine/profile/profile.h"
#include "engine/recipe/recipe.h"
#include "engine/registration/registration.h"

namespace vignole {

/// One stage of the pipeline with the queue in front of it. Names: acquire.1 .. translate.4, profile, measure.
/// Times are those of the work on one item, without waiting for the next; acquire's is what the source took for a
/// frame.
struct StageStatistics {
  std::string name;
  std::uint64_t count = 0;
  double meanMs = 0, sdMs = 0, ucl99Ms = 0, maxMs = 0;
  std::size_t queueCapacity = 0;  ///< 0 for acquire: nothing in front of it
  std::size_t queueHighWater = 0;
  std::uint64_t overflows = 0;  ///< dropped because the queue was full (live only)
  double cpuMs = 0;             ///< CPU time of the stage's thread so far
  std::size_t queueDepth = 0;   ///< in the queue now
};

/// Every trigger is accounted for: seen = measured + incomplete + lost.
struct TriggerLedger {
  std::uint64_t seen = 0;
  std::uint64_t measured = 0;    ///< complete: four contours, registered
  std::uint64_t incomplete = 0;  ///< a profile was made, but a camera or the registration was missing
  std::uint64_t lost = 0;        ///< no profile at all
  /// "camera 3: frame lost" -> triggers. A trigger may have several; "repeated frame" and "late frame" count frames.
  std::map<std::string, std::uint64_t> reasons;
};

/// What comes out at the end for every trigger of a rail, in the order of the triggers.
struct ProfileResult {
  std::shared_ptr<const RailBegin> rail;
  Profile profile;
  Registration registration;
  Measurement measurement;
};

/// Called by the last stage's thread, in order; must be quick and must not throw. May call stop(), running(), stages()
/// and triggers(); wait() returns at once from here, and the inspection must not be destroyed from here.
/// A rail that a stop or a failure cuts short ends as well: railEnded is called with what came of it.
struct InspectionObserver {
  std::function<void(const RailBegin&)> railBegan;
  std::function<void(const ProfileResult&)> profileMeasured;
  std::function<void(const RailBegin&, const TriggerLedger& ofThisRail)> railEnded;
  std::function<void(const std::string& error)> ended;  ///< after the last; error empty if all went well
};

/// What an inspection tells the extraction of a camera (0..3): who extracts with it again gets the same lines.
[[nodiscard]] StripeOptics extractionOptics(const RigCalibration& calibration, const Section& section, int camera);

struct InspectionSettings {
  std::size_t queueCapacity = 16;
  int pendingProfiles = 64;  ///< how far one camera may run ahead before a trigger is given up as incomplete (live)
};

/// Runs until the source ends or stop() is called. Thread-safe: start once, stop from any thread in any state.
class Inspection {
 public:
  /// The source must outlive it. Settings of the recipe's stages are those that its loader checked.
  Inspection(FrameSource& source, Recipe recipe, RigCalibration calibration, InspectionObserver observer,
             InspectionSettings settings = {});
  ~Inspection();  ///< stops and joins
  Inspection(const Inspection&) = delete;
  Inspection& operator=(const Inspection&) = delete;

  void start();  ///< once; later calls do nothing. After a stop() it ends without a frame
  void stop();   ///< asks and returns; what is under way is finished or counted as lost
  void wait();   ///< until everything has passed the last stage; returns at once if it was not started
  [[nodiscard]] bool running() const;
  [[nodiscard]] std::vector<StageStatistics> stages() const;  ///< fourteen, any time
  [[nodiscard]] TriggerLedger triggers() const;               ///< any time

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace vignole
