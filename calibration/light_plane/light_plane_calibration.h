#pragma once
// The plane of one camera's laser, in the camera's frame, from views of a flat target on which the laser's line is
// seen: each line lies in the target's plane and in that of the light.

#include <span>
#include <string>
#include <vector>

#include "calibration/intrinsics/calibrated_intrinsics.h"
#include "calibration/job.h"
#include "calibration/light_plane/line_choice.h"

namespace vignole {

struct LightPlaneSettings {
  std::size_t minPoses = 2;     ///< different ones, with the line seen
  double maxUNormalMrad = 3;    ///< largest standard uncertainty of the plane's direction
  double samePoseShare = 0.01;  ///< of the target's size: points that moved less are the same pose
  LineChoiceSettings choice;
};

struct LightPlaneView {
  std::string file;
  bool used = false;
  std::string reason;  ///< why not used, and what to do
  int points = 0;
  double rmsMm = 0;                    ///< of the line's points about the plane
  double offsetMm = 0;                 ///< mean of them, along the normal
  std::vector<Point3> pointsInCamera;  ///< mm, to be drawn
  std::vector<Point2> linePx;          ///< the same in the picture
};

struct LightPlaneCalibration {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< camera's frame, away from the camera
  double distanceMm = 0;                              ///< normal . point = distance, of the camera's centre: >= 0
  double rmsMm = 0;                                   ///< of all used points about the plane
  std::size_t points = 0;
  /// Of the normal's three components and the distance: noise of the lines, poses of the target, intrinsics.
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
  double uNormalMrad = 0;  ///< about the worst axis
  double uDistanceMm = 0;
  double uAtTargetMm = 0;  ///< of the plane along its normal, in the middle of the lines
  double chi2PerDof = 0;   ///< of the views' lines about the plane, by the lines' and the poses' uncertainties
  std::vector<LightPlaneView> views;  ///< in the order given
  std::vector<std::string> refusals;  ///< "refused, because ..., do ..."; empty: may be used
  [[nodiscard]] bool accepted() const { return refusals.empty(); }
};

/// Error: cancelled.
[[nodiscard]] Expected<LightPlaneCalibration> calibrateLightPlane(std::span<const TargetStripe> stripes,
                                                                  const PlanarTarget& target,
                                                                  const CalibratedIntrinsics& camera,
                                                                  const LightPlaneSettings& settings = {},
                                                                  const Job& job = {});

}  // namespace vignole
