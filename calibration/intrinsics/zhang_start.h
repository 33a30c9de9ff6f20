#pragma once
// A first guess of a camera and of its poses before a flat target, after Zhang (homographies -> camera matrix).

#include <optional>
#include <vector>

#include "calibration/intrinsics/target_adjustment.h"

namespace vignole {

/// Of the plane z = 0 of the target to pixels, up to a factor whose sign makes the depth positive; by least medians, so
/// that a few gross errors do no harm. Nothing for fewer than 4 points, or points on one line.
[[nodiscard]] std::optional<Eigen::Matrix3d> homography(const std::vector<Eigen::Vector3d>& points,
                                                        const ObservedView& view);

/// The target is seen as in a mirror: from behind, or in a picture that is flipped.
[[nodiscard]] bool mirrored(const Eigen::Matrix3d& homography, const Intrinsics& in);

[[nodiscard]] Extrinsics poseFromHomography(const Eigen::Matrix3d& homography, const Intrinsics& in);

/// Cameras without distortion to start from, the likeliest first: Zhang's closed form, the same with the principal
/// point in the middle, and focal lengths of ordinary lenses should the views not fix any. `like` gives pixel pitch and
/// size of the picture.
[[nodiscard]] std::vector<Intrinsics> zhangStarts(const std::vector<Eigen::Matrix3d>& homographies,
                                                  const Intrinsics& like);

}  // namespace vignole
