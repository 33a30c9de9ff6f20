#pragma once
// What views of a target tell of a camera when their poses are unknown: the normal equations of the adjustment with the
// poses eliminated.

#include "calibration/intrinsics/target_adjustment.h"

namespace vignole {

class Information {
 public:
  /// `freePoints`: so many points of the target are unknowns as well.
  Information(const LensVariant& variant, std::size_t freePoints);
  /// Of the intrinsics alone, that leaves this covariance.
  Information(const LensVariant& variant,
              const Eigen::Matrix<double, kIntrinsicParameters, kIntrinsicParameters>& covariance);
  /// Points that the camera cannot see at the fit add nothing.
  void add(const Intrinsics& in, const Extrinsics& cameraFromTarget, const std::vector<Eigen::Vector3d>& points,
           double radiusMm, const ObservedView& view);
  void add(const TargetPrior& prior);
  /// Of the ten intrinsic parameters, zero where they are not estimated; what the views leave open gets a standard
  /// deviation that is absurdly large.
  [[nodiscard]] Eigen::Matrix<double, kIntrinsicParameters, kIntrinsicParameters> covariance() const;

 private:
  std::vector<int> free_;  ///< rows of the intrinsics
  Eigen::MatrixXd matrix_;
};

[[nodiscard]] Information informationOf(const TargetObservations& observations, const LensVariant& variant,
                                        const TargetFit& fit, const TargetPrior& prior);

}  // namespace vignole
