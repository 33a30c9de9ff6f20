#include "calibration/range_finders/error_sources.h"

#include <Eigen/SVD>
#include <algorithm>

namespace vignole {

namespace {

void append(std::vector<ErrorSource>& sources, std::string name, const Eigen::MatrixXd& effects) {
  if (effects.cols() == 0 || effects.topRows(kRigParameters).isZero(0)) return;
  sources.push_back({std::move(name), effects.topRows(kRigParameters)});
}

}  // namespace

Eigen::Matrix<double, kRigParameters, Eigen::Dynamic> compressed(const Eigen::MatrixXd& effects) {
  // Units of the rows differ by orders of magnitude.
  Eigen::VectorXd scale = effects.rowwise().norm();
  const Eigen::VectorXd inverse = scale.unaryExpr([](double s) { return s > 0 ? 1 / s : 0.0; });
  // Not BDCSVD: Eigen 3.4's stops with an assertion on some matrices with singular values that are about equal, such as
  // those of cameras without uncertain intrinsics.
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(inverse.asDiagonal() * effects, Eigen::ComputeThinU);
  constexpr double kNothing = 1e-9;
  Eigen::Index rank = 0;
  while (rank < svd.singularValues().size() && svd.singularValues()[rank] > kNothing) ++rank;
  return scale.asDiagonal() * svd.matrixU().leftCols(rank) * svd.singularValues().head(rank).asDiagonal();
}

std::vector<ErrorSource> errorSources(const Influence& influence, const PinPlate& plate, std::span<const int> cameras) {
  std::vector<ErrorSource> sources;
  for (std::size_t p = 0; p < plate.pins.size(); ++p)
    append(sources, "pin " + std::to_string(plate.pins[p].number), influence.ofPin[p]);
  for (const int c : cameras) {
    const auto camera = static_cast<std::size_t>(c);
    const std::string name = "camera " + std::to_string(c + 1) + " ";
    for (int k = 0; k < kIntrinsicsUnknowns; ++k)
      append(sources, name + std::string(longName(static_cast<CameraParameter>(k))),
             influence.ofIntrinsics[camera].col(k));
    append(sources, name + "lines", compressed(influence.ofLines[camera].topRows(kRigParameters)));
  }
  return sources;
}

void addSources(std::vector<ErrorSource>& all, std::vector<ErrorSource> more) {
  for (ErrorSource& source : more) {
    const auto same = std::find_if(all.begin(), all.end(), [&](const ErrorSource& s) { return s.name == source.name; });
    if (same == all.end())
      all.push_back(std::move(source));
    else
      same->effects += source.effects;
  }
}

Eigen::MatrixXd covarianceOf(std::span<const ErrorSource> sources) {
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(kRigParameters, kRigParameters);
  for (const ErrorSource& source : sources) covariance += source.effects * source.effects.transpose();
  return covariance;
}

}  // namespace vignole
