#pragma once
// Where pins stand by a calibration that need not be the one that their points were first found with.

#include <Eigen/Core>
#include <vector>

#include "calibration/range_finders/rig_adjustment.h"
#include "engine/optics/plane_map.h"

namespace vignole {

/// The points of one arc as pixels, freed of what the line filter pulls them by: any calibration can map them.
struct PinPixels {
  int pin = 0;  ///< number
  int camera = 0, placement = 0;
  std::vector<Point2> px;
  double sigmaPx = 0;           ///< of a point, along the normal
  double correlatedPoints = 1;  ///< neighbours that share their error
  double arcDeg = 0;
};
/// Of the views that were used.
[[nodiscard]] std::vector<PinPixels> pinPixels(const RigAdjustment& adjustment);

/// Centre of a circle of known radius through an arc of at most half of it, in the world; covariance by the noise of
/// the points alone. Not valid where the arc is too short for it.
struct PinCentre {
  bool valid = false;
  Point2 mm{0, 0};
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
};
[[nodiscard]] PinCentre centreOf(const PinPixels& arc, const RangeFinderCalibration& finder, double radiusMm);

/// The same with the radius free; its standard uncertainty by the noise of the points. For long arcs.
struct PinRadius {
  bool valid = false;
  double mm = 0, uMm = 0;
};
[[nodiscard]] PinRadius radiusOf(const PinPixels& arc, const RangeFinderCalibration& finder, double statedMm);

/// Differences of places, each by its own uncertainty: a short arc says much about one direction and little about the
/// other.
class PinMisfit {
 public:
  void add(const Point2& differenceMm, const Eigen::Matrix2d& covariance);
  [[nodiscard]] int count() const { return count_; }
  /// Root mean square, weighted by certainty, mm; and what it should be by the uncertainties.
  [[nodiscard]] double rmsMm() const;
  [[nodiscard]] double expectedMm() const;
  PinMisfit& operator+=(const PinMisfit& other);

 private:
  double chi2_ = 0, information_ = 0;  // of the latter the trace, 1/mm^2
  int count_ = 0;
};

/// How a place of the light plane that a camera maps moves with its parameters (finite differences at the pixel).
[[nodiscard]] Eigen::Matrix<double, 2, kCameraParameters> placeJacobian(const RangeFinderCalibration& finder,
                                                                        const Point2& px);
/// The pixel of a point of the light plane.
[[nodiscard]] Point2 pixelOf(const RangeFinderCalibration& finder, const Point2& mm);

}  // namespace vignole
