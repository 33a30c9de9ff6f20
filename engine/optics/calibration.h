#pragma once
// Calibration of the four range finders: what the paper's section III calls the 16 parameters of each camera, and the
// plane of its laser. The world frame is the section's: x right, y up, z along the rail's motion, mm; the light plane
// of an ideal rig is z = 0. Pixel convention, stated once for the whole program: the centre of the top-left pixel is
// (0, 0).

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/geometry/expected.h"

namespace vignole {

inline constexpr int kCameraCount = 4;

/// The paper's two models (Table III): Division is "analytical" (kappa), Polynomial is "numerical" (k1-k3, p1, p2).
enum class DistortionModel { Division, Polynomial };

/// Intrinsic parameters of section III-A. Lenz/HALCON direction: distorted -> undistorted is the closed form, in mm on
/// the sensor (kappa 1/mm^2, k1 1/mm^2, k2 1/mm^4, k3 1/mm^6, p1, p2 1/mm). Only focal/pitch is observable.
struct Intrinsics {
  double focalMm = 16;
  double pixelWidthMm = 0.0074;   ///< s^x
  double pixelHeightMm = 0.0074;  ///< s^y
  double cxPx = 699.5;            ///< u_0
  double cyPx = 511.5;            ///< v_0
  int widthPx = 1400;
  int heightPx = 1024;
  DistortionModel model = DistortionModel::Division;
  double kappa = 0;
  double k1 = 0, k2 = 0, k3 = 0, p1 = 0, p2 = 0;
};

/// Rigid transform cameraFromWorld: pointInCamera = rotation * pointInWorld + translationMm; camera x right, y down,
/// z forward.
struct Extrinsics {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translationMm = Eigen::Vector3d::Zero();
};

/// normal . pointInWorld = distanceMm, |normal| = 1.
struct LightPlane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double distanceMm = 0;
  double thicknessMm =
      0;  ///< standard deviation of the light across the plane; 0: unknown, nothing is corrected for it
};

struct RangeFinderCalibration {
  std::string serial;  ///< of the camera it belongs to
  Intrinsics intrinsics;
  Extrinsics cameraFromWorld;
  LightPlane lightPlane;
  double blurPx = 0;  ///< standard deviation of the blur by lens and pixel; 0: unknown, nothing is corrected for it
};

/// A pin of the plate as the calibration found it, in the world.
struct CalibratedPin {
  int number = 0;
  double xMm = 0, yMm = 0, radiusMm = 0;
  double uMm = 0, uRadiusMm = 0;  ///< standard uncertainty, of each coordinate and of the radius
};

struct RigCalibration {
  std::string id;       ///< recorded with every result
  std::string created;  ///< ISO date and time, UTC
  std::string method;   ///< "exact (virtual rig)", "joint", ...
  std::array<RangeFinderCalibration, kCameraCount> rangeFinders;
  int intervalDays = 0;  ///< after which it is to be repeated; 0: never
  std::string plate;     ///< id of the pin plate; empty: none was used
  std::vector<CalibratedPin> pins;
  /// Covariance of all parameters of all cameras, kRigParameters square in the order of rig_uncertainty.h; empty: exact
  /// or unknown.
  Eigen::MatrixXd covariance;
};

/// TOML, format = 1. Refuses unknown keys, values out of range, rotations that are none (file, key, reason).
[[nodiscard]] Expected<RigCalibration> loadCalibration(const std::filesystem::path& file);
/// The same from a text; `nameInErrors` stands for the file.
[[nodiscard]] Expected<RigCalibration> parseCalibration(std::string_view text, const std::string& nameInErrors);
/// Written atomically: temporary file, fsync, rename; the previous version is kept as FILE~.
[[nodiscard]] Expected<void> saveCalibration(const RigCalibration& calibration, const std::filesystem::path& file);
[[nodiscard]] std::string toToml(const RigCalibration& calibration);

}  // namespace vignole
