#pragma once
// The seam between cameras on the pins: a pin that two of them see stands in one place, whatever the plate is worth.

#include <span>
#include <vector>

#include "calibration/assessment/check.h"
#include "calibration/assessment/pin_centres.h"

namespace vignole {

struct PairSeam {
  int first = 0, second = 0;  ///< cameras
  int pins = 0;
  double rmsMm = 0;       ///< of the two places of a pin, weighted by their certainty
  double expectedMm = 0;  ///< by the noise of the points and the calibration's covariance
  Point2 meanMm{0, 0};    ///< of first - second
};
/// All pairs that share pins, by this calibration (which need not be the one that the pixels are from). Of `pins` the
/// radii count.
[[nodiscard]] std::vector<PairSeam> pairSeams(std::span<const PinPixels> arcs, const RigCalibration& calibration,
                                              std::span<const CalibratedPin> pins);
[[nodiscard]] Check seamCheck(std::span<const PairSeam> seams);

}  // namespace vignole
