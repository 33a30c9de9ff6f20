#pragma once
// The pose of a camera from points of a plane and their pictures, by least squares in the picture.

#include <span>

#include "engine/geometry/expected.h"
#include "engine/geometry/transform2.h"
#include "engine/optics/calibration.h"

namespace vignole {

struct PlaneCorrespondence {
  Point2 planeMm{0, 0};  ///< in the plane z = 0
  Point2 px{0, 0};
};

struct CameraPose {
  Extrinsics cameraFromPlane;
  double rmsPx = 0;  ///< of the distances, over the degrees of freedom
  Eigen::Matrix<double, 6, 6> information = Eigen::Matrix<double, 6, 6>::Zero();  ///< TurnX .. T3, for errors of 1 px
};

/// Levenberg-Marquardt from `start`; at least 4 points that are not on a line.
[[nodiscard]] Expected<CameraPose> poseFromCentres(std::span<const PlaneCorrespondence> points,
                                                   const Intrinsics& intrinsics, const Extrinsics& start);

}  // namespace vignole
