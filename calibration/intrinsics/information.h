#pragma once
// What views of a target tell of a camera when their poses are unknown: the normal equations of the adjustment with the
// poses eliminated.

#include "calibration/intrinsics/target_adjustment.h"

namespace vignole {

class Information {
 public:
  /// `freePoints`: the target's points are unknowns as well (x and y).
  Information(const LensVariant& variant, std::size_t freePoints);
  /// Points that the camera cannot see at the fit add nothing.
  void add(const Intrinsics& in, const Extrinsics& cameraFromTarget, const std::vector<Eigen::Vector3d>& points,
           double radiusMm, const ObservedView& view);
  void addPointPriors(double sigmaMm);
  /// Of the ten intrinsic parameters, zero where they are not estimated; what the views leave open gets a standard
  /// deviation that is absurdly large.
  [[nodiscard]] Eigen::Matrix<double, kIntrinsicParameters, kIntrinsicParameters> covariance() const;

 private:
  std::vector<int> free_;  ///< rows of the intrinsics
  Eigen::MatrixXd matrix_;
};

[[nodiscard]] Information informationOf(const TargetObservations& observations, const LensVariant& variant,
                                        const TargetFit& fit, double pointSigmaMm);

}  // namespace vignole
