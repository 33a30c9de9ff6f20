#include "engine/stripe/line_smoothing.h"

#include <Eigen/Dense>
#include <cmath>
#include <vector>

namespace vignole {
namespace {

constexpr double kSpacingPx = 1.13;  // of ridge points, averaged over all directions of a line

struct Member {
  double at = 0, weight = 0;
};

/// Variances of the parabola's coefficients for points whose errors are correlated by exp(-d^2 / 4 variance).
void propagate(const std::vector<Member>& members, double variancePx2, SmoothingWindow& window) {
  const auto n = static_cast<Eigen::Index>(members.size());
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::MatrixXd design(3, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Member& m = members[static_cast<std::size_t>(i)];
    const Eigen::Vector3d row(1, m.at, m.at * m.at);
    normal += m.weight * row * row.transpose();
    design.col(i) = m.weight * row;
  }
  const Eigen::MatrixXd coefficients = normal.inverse() * design;
  Eigen::MatrixXd correlation(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index k = 0; k < n; ++k) {
      const double d = members[static_cast<std::size_t>(i)].at - members[static_cast<std::size_t>(k)].at;
      correlation(i, k) = std::exp(-d * d / (4 * variancePx2));
    }
  const Eigen::Matrix3d covariance = coefficients * correlation * coefficients.transpose();
  window.ofPlace = static_cast<float>(covariance(0, 0));
  window.ofBend = static_cast<float>(covariance(2, 2));
  window.covariance = static_cast<float>(covariance(0, 2));
  double quartic = 0, square = 0, total = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Member& m = members[static_cast<std::size_t>(i)];
    quartic += coefficients(0, i) * std::pow(m.at, 4);
    square += m.weight * m.at * m.at;
    total += m.weight;
  }
  window.ofCircle = static_cast<float>(quartic / std::pow(square / total, 2));
  // Residuals' quadratic form W - W X (X' W X)^-1 X' W.
  Eigen::MatrixXd form = -design.transpose() * coefficients;
  for (Eigen::Index i = 0; i < n; ++i) form(i, i) += members[static_cast<std::size_t>(i)].weight;
  const Eigen::MatrixXd product = form * correlation;
  window.scatter = static_cast<float>(product.trace());
  window.scatterSd = static_cast<float>(std::sqrt(2 * (product * product).trace()));
}

}  // namespace

LineSmoothing lineSmoothing(double filterVariancePx2, double blurVariancePx2, bool applied) {
  LineSmoothing smoothing;
  smoothing.pullPx2 = static_cast<float>(filterVariancePx2 + blurVariancePx2);
  smoothing.applied = applied;
  // Neighbouring points share their error: every second one tells as much, far out every fifth.
  smoothing.windows[0] = {{2, 4, 6}, 3, 2, 6};
  smoothing.windows[1] = {{8, 10}, 2, 2, 10};
  smoothing.windows[2] = {{13, 16}, 2, 3, 16};
  smoothing.windows[3] = {{20, 24}, 2, 4, 24};
  smoothing.windows[4] = {{29, 34}, 2, 5, 34};
  std::vector<Member> members{{0, 1}};
  for (SmoothingWindow& window : smoothing.windows) {
    for (int k = 0; k < window.count; ++k)
      for (const double side : {-1.0, 1.0})
        members.push_back(
            {side * kSpacingPx * window.offsets[static_cast<std::size_t>(k)], static_cast<double>(window.weight)});
    propagate(members, filterVariancePx2, window);
  }
  return smoothing;
}

}  // namespace vignole
