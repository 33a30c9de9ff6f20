#pragma once
// The intrinsic parameters of one camera as calibration hands them on: values and covariance, in a file.

#include <Eigen/Core>
#include <filesystem>
#include <string>

#include "engine/optics/rig_uncertainty.h"

namespace vignole {

struct CalibratedIntrinsics {
  std::string serial;   ///< of the camera; may be empty
  std::string created;  ///< ISO date and time, UTC
  Intrinsics intrinsics;
  /// Over the first ten CameraParameters (F ... P2), units as in Intrinsics; zero rows for what was not estimated.
  Eigen::Matrix<double, 10, 10> covariance = Eigen::Matrix<double, 10, 10>::Zero();
  double rmsPx = 0, meanPx = 0;  ///< reprojection error over all points
};

/// TOML, format = 1: serial, created, rms_px, mean_px (each may be missing), the keys of [range_finder.intrinsics] of a
/// calibration under [intrinsics], and an optional [uncertainty] with `parameters` (their names as name() of
/// rig_uncertainty.h in one text, separated by blanks, in their order) and `covariance` (lower triangle row by row).
/// Unknown keys, values out of range and what is no covariance are refused.
[[nodiscard]] Expected<CalibratedIntrinsics> loadIntrinsics(const std::filesystem::path& file);
/// Written whole or not at all; the previous version is kept as FILE~.
[[nodiscard]] Expected<void> saveIntrinsics(const CalibratedIntrinsics& camera, const std::filesystem::path& file);
[[nodiscard]] std::string toToml(const CalibratedIntrinsics& camera);

}  // namespace vignole
