#pragma once
// What the uncertainty of a lens is worth where it counts: in the dimensions of a section, after the camera's pose has
// been found anew with the pin plate; or, for a camera that no rig of ours has, in the picture.

#include <optional>
#include <string>
#include <vector>

#include "calibration/intrinsics/calibrated_intrinsics.h"
#include "calibration/job.h"
#include "engine/rail/dimension.h"
#include "engine/rail/section.h"

namespace vignole {

using IntrinsicCovariance = Eigen::Matrix<double, kIntrinsicParameters, kIntrinsicParameters>;

/// Linear effects of errors of the intrinsics (ten parameters, F ... P2), less what a new pose takes up.
struct CalibrationWorth {
  struct Effect {
    std::optional<Dimension> dimension;  ///< nothing: a shift in the picture
    /// Standard uncertainty^2 = the sum of row * covariance * row^T over the rows: of four such cameras, mm, or of the
    /// points of a grid over the picture (their mean), px.
    Eigen::Matrix<double, Eigen::Dynamic, kIntrinsicParameters> rows;
  };
  std::vector<Effect> effects;

  [[nodiscard]] static double uncertainty(const Effect& effect, const IntrinsicCovariance& covariance);
};

/// In the nominal rig with four such cameras: pins of the plate with 13 pins that lie in the picture fix the pose.
/// Error: fewer than four do, or the section cannot be measured: it is no camera for this rig.
[[nodiscard]] Expected<CalibrationWorth> worthInDimensions(const Intrinsics& in, const Section& section,
                                                           const DimensionParameters& parameters);
/// Shift of the image of points at `distanceMm` that a new pose does not take up, RMS over the picture.
[[nodiscard]] CalibrationWorth worthInPicture(const Intrinsics& in, double distanceMm);

}  // namespace vignole
