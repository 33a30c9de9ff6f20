#include "calibration/intrinsics/calibrated_intrinsics.h"

#include <vector>

#include "engine/files/atomic_file.h"
#include "engine/files/toml_reader.h"
#include "engine/optics/covariance_toml.h"
#include "engine/optics/intrinsics_toml.h"

namespace vignole {

namespace {

std::string inQuotes(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return out + "\"";
}

const std::vector<std::string>& parameterNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (int i = 0; i < kIntrinsicParameters; ++i) all.emplace_back(name(static_cast<CameraParameter>(i)));
    return all;
  }();
  return names;
}

}  // namespace

std::string toToml(const CalibratedIntrinsics& camera) {
  const std::string uncertainty = covarianceToToml(parameterNames(), camera.covariance);
  return "format = 1\nserial = " + inQuotes(camera.serial) + "\ncreated = " + inQuotes(camera.created) +
         "\nrms_px = " + number(camera.rmsPx) + "\nmean_px = " + number(camera.meanPx) + "\n\n[intrinsics]\n" +
         toToml(camera.intrinsics) + (uncertainty.empty() ? "" : "\n[uncertainty]\n" + uncertainty);
}

Expected<CalibratedIntrinsics> loadIntrinsics(const std::filesystem::path& file) {
  auto opened = TomlReader::load(file);
  if (!opened) return tl::unexpected<Error>(opened.error());
  TomlReader& toml = *opened;
  constexpr double kMaxErrorPx = 1e4;
  CalibratedIntrinsics camera;
  camera.serial = toml.text("serial", "");
  camera.created = toml.text("created", "");
  camera.rmsPx = toml.number("rms_px", 0, kMaxErrorPx, 0);
  camera.meanPx = toml.number("mean_px", 0, kMaxErrorPx, 0);
  camera.intrinsics = readIntrinsics(toml, "intrinsics.");
  if (const Eigen::MatrixXd covariance = readCovariance(toml, "uncertainty", parameterNames()); covariance.size() > 0)
    camera.covariance = covariance;
  if (auto done = toml.finish(); !done) return tl::unexpected<Error>(done.error());
  return camera;
}

Expected<void> saveIntrinsics(const CalibratedIntrinsics& camera, const std::filesystem::path& file) {
  return writeFile(file, toToml(camera), true);
}

}  // namespace vignole
