#pragma once
// What a circle's image is to its centre's (optics design, section 1.2): its centre, that of an ellipse, is not the
// image of the circle's centre. Templates over the scalar, for adjustments.

#include <Eigen/Core>

#include "engine/geometry/transform2.h"
#include "engine/optics/calibration.h"

namespace vignole {

/// The point of the target's plane whose image is the centre of the circle's image (in undistorted pixels): the pole of
/// the plane's vanishing line, centre - r^2 h / w with h the first two entries of the homography's third row and w its
/// value at the centre. For a target's plane z = 0 before a camera, (h, w) is the third row of cameraFromTarget:
/// h = (R20, R21), w = depth of the centre in the camera's frame.
template <typename T>
[[nodiscard]] Eigen::Matrix<T, 2, 1> circleCentreInPlane(const Eigen::Matrix<T, 2, 1>& centreMm, const T& radiusMm,
                                                         const T& h0, const T& h1, const T& w) {
  const T scale = radiusMm * radiusMm / w;
  return {centreMm.x() - scale * h0, centreMm.y() - scale * h1};
}

/// The lens bends the ellipse, whose fitted centre so lies off the distorted image of circleCentreInPlane(): by what
/// has to be added to the latter, px (to second order; 0.01 px for a dot of 30 px at the edge of a picture whose
/// distortion is 10 px there). It changes so little that an adjustment may hold it fixed and take it anew when it has
/// converged.
[[nodiscard]] Point2 circleImageShift(const Intrinsics& in, const Extrinsics& cameraFromTarget, const Point2& centreMm,
                                      double radiusMm);

}  // namespace vignole
