#pragma once
// A flat target before one camera of the virtual rig, held as a hand would, and what the camera makes of it.

#include <memory>
#include <string>
#include <vector>

#include "calibration/intrinsics/intrinsics_calibration.h"
#include "calibration/job.h"
#include "calibration/next_pose/next_pose.h"
#include "engine/acquisition/picture_file.h"
#include "engine/simulator/virtual_target.h"

namespace vignole {

/// Of the target's middle in the camera's frame (right, down, away), and its tilts and turn.
struct HeldTarget {
  double xMm = 0, yMm = 0, zMm = 400;
  double tiltXDeg = 0, tiltYDeg = 0, turnDeg = 0;
};
[[nodiscard]] Extrinsics extrinsicsOf(const HeldTarget& pose, const PlanarTarget& target);
[[nodiscard]] HeldTarget poseOf(const Extrinsics& cameraFromTarget, const PlanarTarget& target);

struct LensSight {
  HeldTarget pose;
  Picture picture;
  TargetView view;  ///< its refusal says why the picture is of no use
  int sameAs = 0;   ///< number of a picture taken before that shows the same pose; 0: none
  [[nodiscard]] bool usable() const { return view.usable() && sameAs == 0; }
};

struct LensStandSettings {
  PlanarTarget target;
  RangeFinderCalibration camera;  ///< the true one: what the virtual target stands before
  int number = 0;                 ///< of the camera, 0 ... 3
};

/// The camera of the virtual rig of that seed, as it truly is.
[[nodiscard]] RangeFinderCalibration virtualCamera(std::uint64_t rigSeed, int camera);

/// `taken`: views before, `take` draws the noise. For any thread.
[[nodiscard]] Expected<LensSight> lookAtTarget(const LensStandSettings& settings, const HeldTarget& pose, int take,
                                               const std::vector<TargetView>& taken);

/// Where to hold the target next, by what is known so far.
struct NextView {
  HeldTarget pose;
  std::vector<Point2> outlinePx;
  std::string words;
};
/// Before there is anything to go by: spread over picture and tilts. `lens`: roughly the camera's.
[[nodiscard]] NextView startingView(const PlanarTarget& target, const Intrinsics& lens, int number);
/// The one that would reduce the uncertainty of the section's dimensions most; error: too few pictures yet.
[[nodiscard]] Expected<NextView> mostTelling(const std::vector<TargetView>& taken, const PlanarTarget& target,
                                             const Section& section, const DimensionParameters& parameters,
                                             const Job& job);

}  // namespace vignole
