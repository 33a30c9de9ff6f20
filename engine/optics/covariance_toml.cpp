#include "engine/optics/covariance_toml.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cassert>
#include <vector>

#include "engine/optics/intrinsics_toml.h"

namespace vignole {

namespace {

constexpr double kRounding = 1e-8;  // of eigenvalues of the correlations: what inverting normal equations may leave

Eigen::Index triangle(Eigen::Index n) { return n * (n + 1) / 2; }

/// Where each of the file's parameters stands among `names`.
std::vector<Eigen::Index> readPlaces(TomlReader& toml, const std::string& key, std::span<const std::string> names) {
  std::vector<Eigen::Index> places;
  for (const std::string& text : toml.texts(key)) {
    const auto found = std::find(names.begin(), names.end(), text);
    if (found == names.end()) {
      toml.refuse(key, "names \"" + text + "\", which is no parameter; the first one is \"" + names.front() + "\"");
      return {};
    }
    const Eigen::Index place = found - names.begin();
    if (std::find(places.begin(), places.end(), place) != places.end()) {
      toml.refuse(key, "names \"" + text + "\" twice; remove one");
      return {};
    }
    places.push_back(place);
  }
  return places;
}

/// Empty, or why it cannot be a covariance.
std::string objection(const Eigen::MatrixXd& covariance) {
  if (!(covariance.diagonal().minCoeff() > 0)) return "has a variance that is not positive; calibrate again";
  // Units differ by orders of magnitude, so it is judged by its correlations.
  const Eigen::VectorXd inverse = covariance.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd correlation = inverse.asDiagonal() * covariance * inverse.asDiagonal();
  if (!(correlation.cwiseAbs().maxCoeff() <= 1 + kRounding)) return "has a correlation beyond +-1; calibrate again";
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(correlation, Eigen::EigenvaluesOnly);
  if (!(solver.eigenvalues().minCoeff() >= -kRounding * static_cast<double>(covariance.rows())))
    return "is not positive semi-definite, so no errors can have it; calibrate again";
  return {};
}

}  // namespace

std::string covarianceToToml(std::span<const std::string> names, const Eigen::MatrixXd& covariance) {
  assert(covariance.rows() == static_cast<Eigen::Index>(names.size()) && covariance.cols() == covariance.rows());
  std::vector<Eigen::Index> places;
  for (Eigen::Index i = 0; i < covariance.rows(); ++i)
    if (covariance(i, i) != 0) places.push_back(i);
  if (places.empty()) return {};
  std::string parameters, rows;
  for (std::size_t i = 0; i < places.size(); ++i) {
    parameters += (i == 0 ? "" : ", ") + ("\"" + names[static_cast<std::size_t>(places[i])] + "\"");
    rows += "  ";
    for (std::size_t j = 0; j <= i; ++j) rows += (j == 0 ? "" : " ") + number(covariance(places[i], places[j])) + ",";
    rows += "\n";
  }
  return "parameters = [" + parameters + "]\ncovariance = [\n" + rows + "]\n";
}

Eigen::MatrixXd readCovariance(TomlReader& toml, const std::string& table, std::span<const std::string> names) {
  if (!toml.has(table)) return {};
  const std::vector<Eigen::Index> places = readPlaces(toml, table + ".parameters", names);
  const auto n = static_cast<Eigen::Index>(places.size());
  const std::vector<double> values = toml.numbers(table + ".covariance", static_cast<std::size_t>(triangle(n)));
  if (n == 0) {
    toml.refuse(table + ".parameters", "names none; remove the table " + table);
    return {};
  }
  Eigen::MatrixXd given(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j <= i; ++j) given(i, j) = given(j, i) = values[static_cast<std::size_t>(triangle(i) + j)];
  if (const std::string why = objection(given); !why.empty()) {
    toml.refuse(table + ".covariance", why);
    return {};
  }
  Eigen::MatrixXd covariance =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(names.size()), static_cast<Eigen::Index>(names.size()));
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      covariance(places[static_cast<std::size_t>(i)], places[static_cast<std::size_t>(j)]) = given(i, j);
  return covariance;
}

}  // namespace vignole
