#pragma once
// The parameters of one camera by the paper's names (section III-A), with their standard uncertainties.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "engine/optics/rig_uncertainty.h"

namespace vignole {

/// Euler angles (alpha, beta, gamma), rad: rotation = Rx(alpha) Ry(beta) Rz(gamma), each a right-handed turn about an
/// axis of the camera's frame as it stands before the turns that are applied first; beta within +- pi/2.
[[nodiscard]] Eigen::Vector3d eulerAngles(const Eigen::Matrix3d& rotation);
inline constexpr const char* kEulerOrder = "cameraFromWorld = Rx(alpha) Ry(beta) Rz(gamma)";

struct PaperParameter {
  std::string name;  ///< "f", "s^x", "s^y", "u_0", "v_0", "k_1" ... or "kappa", "alpha" ... "t_3"
  double value = 0;
  double u = 0;  ///< standard uncertainty; 0 where nothing was estimated
  std::string unit;
};

/// `covariance`: of the camera's parameters, kCameraParameters square in the order of CameraParameter; empty: every u
/// is 0. The division model has kappa in place of k_1 ... p_2. Angles in degrees.
[[nodiscard]] std::vector<PaperParameter> paperParameters(const RangeFinderCalibration& finder,
                                                          const Eigen::MatrixXd& covariance);
/// The ten intrinsic ones alone (or six).
[[nodiscard]] std::vector<PaperParameter> paperParameters(const Intrinsics& intrinsics,
                                                          const Eigen::MatrixXd& covariance);

}  // namespace vignole
