#include "engine/optics/calibration.h"

#include <Eigen/LU>
#include <cmath>

#include "engine/files/atomic_file.h"
#include "engine/files/toml_reader.h"
#include "engine/optics/calibration_age.h"
#include "engine/optics/covariance_toml.h"
#include "engine/optics/intrinsics_toml.h"
#include "engine/optics/rig_uncertainty.h"

namespace vignole {

namespace {

constexpr double kRotationTolerance = 1e-6;
constexpr int kMaxIntervalDays = 36500;

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return out + "\"";
}

template <int N>
Eigen::Matrix<double, N, 1> readVector(TomlReader& toml, const std::string& key, double limit) {
  const std::vector<double> values = toml.numbers(key, N);
  Eigen::Matrix<double, N, 1> v = Eigen::Matrix<double, N, 1>::Zero();
  if (values.size() != N) return v;  // the reader has noted the error
  for (int i = 0; i < N; ++i) v(i) = values[static_cast<std::size_t>(i)];
  if (!(v.cwiseAbs().maxCoeff() <= limit)) toml.refuse(key, "has a value beyond +-" + number(limit));
  return v;
}

Extrinsics readExtrinsics(TomlReader& toml, const std::string& at) {
  Extrinsics pose;
  const Eigen::Matrix<double, 9, 1> m = readVector<9>(toml, at + "rotation", 1 + kRotationTolerance);
  pose.rotation << m(0), m(1), m(2), m(3), m(4), m(5), m(6), m(7), m(8);
  const double error = (pose.rotation * pose.rotation.transpose() - Eigen::Matrix3d::Identity()).norm();
  if (!(error < kRotationTolerance) || pose.rotation.determinant() < 0)
    toml.refuse(at + "rotation", "is no rotation (9 numbers row by row, orthonormal, determinant +1); calibrate again");
  pose.translationMm = readVector<3>(toml, at + "translation_mm", 1e5);
  return pose;
}

LightPlane readLightPlane(TomlReader& toml, const std::string& at) {
  LightPlane plane;
  plane.normal = readVector<3>(toml, at + "normal", 1 + kRotationTolerance);
  if (!(std::abs(plane.normal.norm() - 1) < kRotationTolerance))
    toml.refuse(at + "normal", "is not of length 1; calibrate again");
  plane.distanceMm = toml.number(at + "distance_mm", -1e4, 1e4);
  plane.thicknessMm = toml.number(at + "thickness_mm", 0, 5, 0);
  return plane;
}

std::vector<CalibratedPin> readPins(TomlReader& toml) {
  std::vector<CalibratedPin> pins(toml.size("pin"));
  for (std::size_t i = 0; i < pins.size(); ++i) {
    const std::string at = "pin." + std::to_string(i) + ".";
    CalibratedPin& pin = pins[i];
    pin.number = toml.integer(at + "number", 1, 10000);
    pin.xMm = toml.number(at + "x_mm", -1e4, 1e4);
    pin.yMm = toml.number(at + "y_mm", -1e4, 1e4);
    pin.radiusMm = toml.number(at + "radius_mm", 0.1, 1000);
    pin.uMm = toml.number(at + "u_mm", 0, 100);
    pin.uRadiusMm = toml.number(at + "u_radius_mm", 0, 100);
    for (std::size_t j = 0; j < i; ++j)
      if (pins[j].number == pin.number)
        toml.refuse(at + "number", "is " + std::to_string(pin.number) + ", which another pin has, too");
  }
  return pins;
}

std::string toToml(const CalibratedPin& pin) {
  return "\n[[pin]]\nnumber = " + std::to_string(pin.number) + "\nx_mm = " + number(pin.xMm) +
         "\ny_mm = " + number(pin.yMm) + "\nradius_mm = " + number(pin.radiusMm) + "\nu_mm = " + number(pin.uMm) +
         "\nu_radius_mm = " + number(pin.uRadiusMm) + "\n";
}

/// "camera1.f" ... in the order of rig_uncertainty.h.
std::vector<std::string> parameterNames() {
  std::vector<std::string> names;
  for (int camera = 1; camera <= kCameraCount; ++camera)
    for (int p = 0; p < kCameraParameters; ++p)
      names.push_back("camera" + std::to_string(camera) + "." + std::string(name(static_cast<CameraParameter>(p))));
  return names;
}

}  // namespace

std::string toToml(const RigCalibration& calibration) {
  std::string text = "format = 1\nid = " + quoted(calibration.id) + "\ncreated = " + quoted(calibration.created) +
                     "\nmethod = " + quoted(calibration.method) + "\n";
  if (calibration.intervalDays > 0) text += "interval_days = " + std::to_string(calibration.intervalDays) + "\n";
  if (!calibration.plate.empty()) text += "plate = " + quoted(calibration.plate) + "\n";
  for (const RangeFinderCalibration& finder : calibration.rangeFinders) {
    const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rotation = finder.cameraFromWorld.rotation;
    text += "\n[[range_finder]]\nserial = " + quoted(finder.serial) + "\n";
    if (finder.blurPx > 0) text += "blur_px = " + number(finder.blurPx) + "\n";
    text += "[range_finder.intrinsics]\n" + toToml(finder.intrinsics);
    text += "[range_finder.camera_from_world]\nrotation = " + list({rotation.data(), 9}) +
            "\ntranslation_mm = " + list({finder.cameraFromWorld.translationMm.data(), 3}) + "\n";
    text += "[range_finder.light_plane]\nnormal = " + list({finder.lightPlane.normal.data(), 3}) +
            "\ndistance_mm = " + number(finder.lightPlane.distanceMm) + "\n";
    if (finder.lightPlane.thicknessMm > 0) text += "thickness_mm = " + number(finder.lightPlane.thicknessMm) + "\n";
  }
  for (const CalibratedPin& pin : calibration.pins) text += toToml(pin);
  if (calibration.covariance.size() > 0)
    if (const std::string keys = covarianceToToml(parameterNames(), calibration.covariance); !keys.empty())
      text += "\n[uncertainty]\n" + keys;
  return text;
}

namespace {
Expected<RigCalibration> readCalibration(Expected<TomlReader> opened) {
  if (!opened) return tl::unexpected<Error>(opened.error());
  TomlReader& toml = *opened;
  RigCalibration calibration;
  calibration.id = toml.text("id");
  calibration.created = toml.text("created");
  calibration.method = toml.text("method");
  calibration.intervalDays = toml.integer("interval_days", 0, kMaxIntervalDays, 0);
  if (calibration.intervalDays > 0 && !secondsSinceEpoch(calibration.created))
    toml.refuse("created",
                "is no date and time like 2026-01-31T12:00:00Z, so its age against interval_days is unknown");
  calibration.plate = toml.text("plate", "");
  const std::size_t count = toml.size("range_finder");
  if (count != kCameraCount)
    toml.refuse("range_finder", "appears " + std::to_string(count) + " times; a rig has " +
                                    std::to_string(kCameraCount) + " range finders");
  for (std::size_t i = 0; i < kCameraCount && i < count; ++i) {
    const std::string at = "range_finder." + std::to_string(i) + ".";
    RangeFinderCalibration& finder = calibration.rangeFinders[i];
    finder.serial = toml.text(at + "serial");
    finder.blurPx = toml.number(at + "blur_px", 0, 20, 0);
    finder.intrinsics = readIntrinsics(toml, at + "intrinsics.");
    finder.cameraFromWorld = readExtrinsics(toml, at + "camera_from_world.");
    finder.lightPlane = readLightPlane(toml, at + "light_plane.");
  }
  calibration.pins = readPins(toml);
  calibration.covariance = readCovariance(toml, "uncertainty", parameterNames());
  if (auto done = toml.finish(); !done) return tl::unexpected<Error>(done.error());
  return calibration;
}
}  // namespace

Expected<RigCalibration> loadCalibration(const std::filesystem::path& file) {
  return readCalibration(TomlReader::load(file));
}

Expected<RigCalibration> parseCalibration(std::string_view text, const std::string& nameInErrors) {
  return readCalibration(TomlReader::parse(text, nameInErrors));
}

Expected<void> saveCalibration(const RigCalibration& calibration, const std::filesystem::path& file) {
  return writeFile(file, toToml(calibration), true);
}

}  // namespace vignole
