#pragma once
// One Ceres solve of the arcs with what is expected of their points held.

#include <array>
#include <vector>

#include "calibration/range_finders/arc_adjustment.h"

namespace vignole {

/// The numbers that Ceres moves.
struct ArcUnknowns {
  std::array<std::array<double, kIntrinsicsUnknowns>, kCameraCount> intrinsics{};
  std::array<std::array<double, kPoseUnknowns>, kCameraCount> pose{};
  std::vector<std::array<double, kPinUnknowns>> pins;
  std::vector<std::array<double, kPlacementUnknowns>> placements;
};

/// False: cancelled.
[[nodiscard]] bool solveArcs(const std::vector<ArcObservation>& arcs,
                             const std::array<CameraLight, kCameraCount>& lights,
                             const std::array<CameraBase, kCameraCount>& base, const PinPlate& plate,
                             const ArcFreedom& freedom, int referencePlacement, int maxSteps, ArcUnknowns& unknowns,
                             const Job& job);

/// Information and noise of every camera's points at the unknowns.
[[nodiscard]] ArcNormals normalsOf(const std::vector<ArcObservation>& arcs,
                                   const std::array<CameraLight, kCameraCount>& lights,
                                   const std::array<CameraBase, kCameraCount>& base, const ArcUnknowns& unknowns);

}  // namespace vignole
