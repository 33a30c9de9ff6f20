#pragma once
// Uncertainty of a rig's calibration: over all parameters of its four cameras at once, since a plate's error moves them
// together.

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "engine/geometry/transform2.h"
#include "engine/optics/calibration.h"

namespace vignole {

/// Parameters of one camera that calibration estimates: the paper's 16 (section III-A) but for s^x, which is fixed
/// (only f / s^x is observable), and with kappa of the division model. Units as in Intrinsics; rotation: a small turn
/// about the camera's own x, y, z, rad (rotation' = exp([w]x) rotation); translation: added to translationMm.
enum class CameraParameter { F, PixelHeight, U0, V0, Kappa, K1, K2, K3, P1, P2, TurnX, TurnY, TurnZ, T1, T2, T3 };
inline constexpr int kCameraParameters = 16;
inline constexpr int kRigParameters = kCameraCount * kCameraParameters;
using CameraChange = Eigen::Matrix<double, kCameraParameters, 1>;
using RigChange = Eigen::Matrix<double, kRigParameters, 1>;  ///< camera 1 first

/// "f", "s_y", "u_0", "v_0", "kappa", "k_1" ... "turn_x" ... "t_3".
[[nodiscard]] std::string_view name(CameraParameter parameter);
/// For people: "focal length", "principal point u_0" ...
[[nodiscard]] std::string_view longName(CameraParameter parameter);

/// Adds a small change.
void apply(const CameraChange& change, RangeFinderCalibration& finder);
void apply(const RigChange& change, RigCalibration& rig);

/// The same rig in a world that lies elsewhere in the plane: poses, light planes, pins and the covariance go along (the
/// translation of a camera is that of the world's origin, so its error is another one there).
[[nodiscard]] RigCalibration inWorld(const RigCalibration& rig, const Transform2& otherFromWorld);

/// A cause of error that is independent of all others. Each column is what one standard deviation of one of its
/// independent parts does to the rig's parameters: its covariance is effects * effects^T.
struct ErrorSource {
  std::string name;  ///< "pin 7", "camera 3 focal length", "camera 2 lines" ...
  Eigen::Matrix<double, kRigParameters, Eigen::Dynamic> effects;
};

/// The rig's covariance as one source; empty where it is unknown or the calibration is exact.
[[nodiscard]] ErrorSource errorSource(const RigCalibration& rig);

}  // namespace vignole
