#include "cli/virtual_intrinsics.h"

#include <cmath>

#include "engine/simulator/hashing.h"

namespace vignole::cli {

namespace {

constexpr double kFocalShare = 5e-4, kPrincipalPx = 1.5, kKappaTimesFocal2 = 3e-3;
constexpr double kK2Share = 0.3, kK3Share = 0.1, kTangentialShare = 0.1;

/// Standard deviations in the order of CameraParameter.
Eigen::Matrix<double, 10, 1> deviations(const Intrinsics& in) {
  Eigen::Matrix<double, 10, 1> sd = Eigen::Matrix<double, 10, 1>::Zero();
  const auto of = [&](CameraParameter p) -> double& { return sd[static_cast<int>(p)]; };
  of(CameraParameter::F) = kFocalShare * in.focalMm;
  of(CameraParameter::U0) = of(CameraParameter::V0) = kPrincipalPx;
  const double kappa = kKappaTimesFocal2 / (in.focalMm * in.focalMm);
  if (in.model == DistortionModel::Division) {
    of(CameraParameter::Kappa) = kappa;
    return sd;
  }
  const double corner = std::hypot(in.widthPx * in.pixelWidthMm, in.heightPx * in.pixelHeightMm) / 2;
  of(CameraParameter::K1) = kappa;
  of(CameraParameter::K2) = kK2Share * kappa / std::pow(corner, 2);
  of(CameraParameter::K3) = kK3Share * kappa / std::pow(corner, 4);
  of(CameraParameter::P1) = of(CameraParameter::P2) = kTangentialShare * kappa * corner;
  return sd;
}

}  // namespace

CalibratedIntrinsics virtualIntrinsics(const RangeFinderCalibration& truth, int camera, std::uint64_t seed,
                                       bool exact) {
  CalibratedIntrinsics found;
  found.serial = truth.serial;
  found.created = "1970-01-01T00:00:00Z";  // the same seed is the same file, whenever it is drawn
  found.intrinsics = truth.intrinsics;
  if (exact) return found;
  const Eigen::Matrix<double, 10, 1> sd = deviations(truth.intrinsics);
  simulator::Draws draws(seed, simulator::Stream::IntrinsicsError, {static_cast<std::uint64_t>(camera)});
  CameraChange error = CameraChange::Zero();
  for (int i = 0; i < 10; ++i) error[i] = sd[i] * draws.normal();
  RangeFinderCalibration disturbed = truth;
  apply(error, disturbed);
  found.intrinsics = disturbed.intrinsics;
  found.covariance.diagonal() = sd.cwiseAbs2();
  return found;
}

}  // namespace vignole::cli
