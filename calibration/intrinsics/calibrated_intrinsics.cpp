#include "calibration/intrinsics/calibrated_intrinsics.h"

#include <Eigen/Eigenvalues>
#include <optional>
#include <sstream>
#include <vector>

#include "engine/files/atomic_file.h"
#include "engine/files/toml_reader.h"
#include "engine/optics/intrinsics_toml.h"

namespace vignole {

namespace {

constexpr int kIntrinsicParameters = 10;
using Covariance = Eigen::Matrix<double, kIntrinsicParameters, kIntrinsicParameters>;

std::string inQuotes(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return out + "\"";
}

std::optional<int> parameterNamed(std::string_view word) {
  for (int i = 0; i < kIntrinsicParameters; ++i)
    if (word == name(static_cast<CameraParameter>(i))) return i;
  return {};
}

std::string uncertaintyToml(const Covariance& covariance) {
  std::vector<int> estimated;
  for (int i = 0; i < kIntrinsicParameters; ++i)
    if (covariance(i, i) > 0) estimated.push_back(i);
  if (estimated.empty()) return {};
  std::string names;
  std::vector<double> triangle;
  for (const int row : estimated) {
    names += (names.empty() ? "" : " ") + std::string(name(static_cast<CameraParameter>(row)));
    for (const int column : estimated)
      if (column <= row) triangle.push_back(covariance(row, column));
  }
  return "\n[uncertainty]\nparameters = " + inQuotes(names) + "\ncovariance = " + list(triangle) + "\n";
}

/// Units differ by orders of magnitude, so the correlations are judged.
bool isCovariance(const Covariance& covariance, const std::vector<int>& estimated) {
  constexpr double kRounding = 1e-9;
  const auto n = static_cast<Eigen::Index>(estimated.size());
  Eigen::MatrixXd correlation(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      const int row = estimated[static_cast<std::size_t>(i)], column = estimated[static_cast<std::size_t>(j)];
      const double scale = std::sqrt(covariance(row, row)) * std::sqrt(covariance(column, column));
      if (!(scale > 0)) return false;
      correlation(i, j) = covariance(row, column) / scale;
    }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(correlation, Eigen::EigenvaluesOnly);
  return solver.eigenvalues().minCoeff() > -kRounding;
}

Covariance readUncertainty(TomlReader& toml) {
  Covariance covariance = Covariance::Zero();
  const std::string key = "uncertainty.parameters";
  std::istringstream words(toml.text(key));
  std::vector<int> estimated;
  for (std::string word; words >> word;) {
    const auto parameter = parameterNamed(word);
    if (!parameter || (!estimated.empty() && *parameter <= estimated.back())) {
      toml.refuse(key, "has '" + word + "'; give names out of f s_y u_0 v_0 kappa k_1 k_2 k_3 p_1 p_2 in this order");
      return covariance;
    }
    estimated.push_back(*parameter);
  }
  const std::vector<double> triangle =
      toml.numbers("uncertainty.covariance", estimated.size() * (estimated.size() + 1) / 2);
  std::size_t next = 0;
  for (std::size_t row = 0; row < estimated.size(); ++row)
    for (std::size_t column = 0; column <= row; ++column)
      covariance(estimated[row], estimated[column]) = covariance(estimated[column], estimated[row]) = triangle[next++];
  if (!estimated.empty() && !isCovariance(covariance, estimated))
    toml.refuse("uncertainty.covariance", "is no covariance (lower triangle row by row); calibrate again");
  return covariance;
}

}  // namespace

std::string toToml(const CalibratedIntrinsics& camera) {
  return "format = 1\nserial = " + inQuotes(camera.serial) + "\ncreated = " + inQuotes(camera.created) +
         "\nrms_px = " + number(camera.rmsPx) + "\nmean_px = " + number(camera.meanPx) + "\n\n[intrinsics]\n" +
         toToml(camera.intrinsics) + uncertaintyToml(camera.covariance);
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
  if (toml.has("uncertainty")) camera.covariance = readUncertainty(toml);
  if (auto done = toml.finish(); !done) return tl::unexpected<Error>(done.error());
  return camera;
}

Expected<void> saveIntrinsics(const CalibratedIntrinsics& camera, const std::filesystem::path& file) {
  return writeFile(file, toToml(camera), true);
}

}  // namespace vignole
