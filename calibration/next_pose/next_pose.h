#pragma once
// Where to hold the target next: the pose that would reduce the uncertainty of the dimensions most.

#include "calibration/intrinsics/intrinsics_calibration.h"
#include "calibration/next_pose/calibration_worth.h"

namespace vignole {

struct NextPoseSettings {
  std::vector<double> tiltsDeg = {0, 20, 35};
  int directions = 8;                           ///< in which it is tilted
  int columns = 3, rows = 3;                    ///< of places in the picture
  std::vector<double> turnsDeg = {0, 90};       ///< about its normal
  std::vector<double> distances = {0, 0.5, 1};  ///< between the nearest and the farthest that was sharp enough to use
  double minPointShare = 0.6;                   ///< of the target's points, inside the picture
};

struct ExpectedGain {
  std::optional<Dimension> dimension;  ///< nothing: RMS shift in the picture, px instead of mm
  double before = 0, after = 0;        ///< standard uncertainty that the intrinsics of four such cameras leave, mm
};

struct NextPose {
  Extrinsics cameraFromTarget;
  std::vector<Point2> outlinePx;  ///< the target's border, closed, to be drawn; may leave the picture
  std::string words;              ///< "tilt the left side away by 30 degrees, upper right of the picture, 420 mm away"
  std::vector<ExpectedGain> gains;
  double remainingShare = 1;  ///< mean over the dimensions of (after / before)^2
};

/// Error: the calibration has no covariance (too few pictures).
[[nodiscard]] Expected<NextPose> nextPose(const IntrinsicsCalibration& calibration, const PlanarTarget& target,
                                          const CalibrationWorth& worth, const NextPoseSettings& settings = {});

/// Mean distance of the target in the used views, mm; 0 without any.
[[nodiscard]] double usualDistanceMm(const IntrinsicsCalibration& calibration, const PlanarTarget& target);

}  // namespace vignole
