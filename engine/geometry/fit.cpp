#include "engine/geometry/fit.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace vignole {

namespace {

constexpr const char* kLine = "line fit";
constexpr const char* kCircle = "circle fit";

/// 1/sigma^2 of every point; the error says what is wrong with the input.
Expected<std::vector<double>> weightsOf(const char* where, std::span<const Point2> points,
                                        std::span<const double> sigmaMm, std::size_t least) {
  if (points.size() < least)
    return inputError(where,
                      "needs at least " + std::to_string(least) + " points, has " + std::to_string(points.size()));
  if (!sigmaMm.empty() && sigmaMm.size() != points.size())
    return inputError(where, "needs one standard deviation per point, or none");
  std::vector<double> weights(points.size(), 1.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) return inputError(where, "point " + std::to_string(i) + " is not a number");
    if (sigmaMm.empty()) continue;
    if (!(sigmaMm[i] > 0) || !std::isfinite(sigmaMm[i]))
      return inputError(where, "the standard deviation of point " + std::to_string(i) + " must be above 0");
    weights[i] = 1 / (sigmaMm[i] * sigmaMm[i]);
  }
  return weights;
}

double largestDistance(std::span<const Point2> points, const Point2& from) {
  double d2 = 0;
  for (const Point2& p : points) d2 = std::max(d2, (p - from).squaredNorm());
  return std::sqrt(d2);
}

/// Circle as A (x^2 + y^2) + D x + E y + F = 0 with D^2 + E^2 - 4 A F = 1, D and E by an angle (Chernov and Lesort
/// 2005). Unlike centre and radius this passes smoothly through the straight line A = 0, so that flat arcs converge.
struct AlgebraicCircle {
  double a = 0, f = 0, theta = 0;

  [[nodiscard]] double scale() const { return std::sqrt(std::max(1 + 4 * a * f, 0.0)); }
  /// Signed distance d, from P = d + A d^2, and its gradient by (A, F, theta).
  double distance(const Point2& p, Eigen::Vector3d* gradient) const {
    const double u = scale(), c = std::cos(theta), s = std::sin(theta);
    const double z2 = p.squaredNorm(), across = c * p.x() + s * p.y();
    const double value = a * z2 + u * across + f;
    const double q = std::sqrt(std::max(1 + 4 * a * value, 0.0));
    const double d = 2 * value / (1 + q);
    if (gradient != nullptr) {
      const double safeQ = std::max(q, 1e-12), safeU = std::max(u, 1e-12);
      *gradient = Eigen::Vector3d(z2 + 2 * f / safeU * across - d * d, 1 + 2 * a / safeU * across,
                                  u * (c * p.y() - s * p.x())) /
                  safeQ;
    }
    return d;
  }
};

/// Kasa's linear fit: close enough for the geometric one to start from. Points relative to one of them.
AlgebraicCircle kasa(const std::vector<Point2>& points, const std::vector<double>& weights) {
  Eigen::MatrixX3d m(static_cast<Eigen::Index>(points.size()), 3);
  Eigen::VectorXd right(m.rows());
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double w = std::sqrt(weights[k]);
    m.row(i) = w * Eigen::RowVector3d(points[k].x(), points[k].y(), 1);
    right(i) = -w * points[k].squaredNorm();
  }
  const Eigen::Vector3d solved = m.colPivHouseholderQr().solve(right);  // x^2 + y^2 + B x + C y + G = 0
  const double norm = std::sqrt(solved.x() * solved.x() + solved.y() * solved.y() - 4 * solved.z());
  if (!std::isfinite(norm) || norm == 0) return {};
  return {1 / norm, solved.z() / norm, std::atan2(solved.y(), solved.x())};
}

double squaredSum(const AlgebraicCircle& circle, const std::vector<Point2>& points,
                  const std::vector<double>& weights) {
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double d = circle.distance(points[i], nullptr);
    sum += weights[i] * d * d;
  }
  return sum;
}

/// Levenberg-Marquardt on the orthogonal distances.
AlgebraicCircle refine(AlgebraicCircle circle, const std::vector<Point2>& points, const std::vector<double>& weights) {
  double cost = squaredSum(circle, points, weights);
  double damping = 1e-6;
  for (int iteration = 0; iteration < 200 && damping < 1e12; ++iteration) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
      Eigen::Vector3d row;
      const double d = circle.distance(points[i], &row);
      normal += weights[i] * row * row.transpose();
      gradient += weights[i] * d * row;
    }
    normal.diagonal() *= 1 + damping;
    const Eigen::Vector3d step = normal.ldlt().solve(-gradient);
    const AlgebraicCircle next{circle.a + step(0), circle.f + step(1), circle.theta + step(2)};
    const double nextCost = 1 + 4 * next.a * next.f > 0 ? squaredSum(next, points, weights) : cost + 1;
    if (!(nextCost <= cost)) {
      damping *= 10;
      continue;
    }
    const bool done = cost - nextCost <= 1e-14 * cost;
    circle = next;
    cost = nextCost;
    damping = std::max(damping / 10, 1e-12);
    if (done) break;
  }
  return circle;
}

}  // namespace

Expected<LineFit> fitLine(std::span<const Point2> points, std::span<const double> sigmaMm) {
  const auto weights = weightsOf(kLine, points, sigmaMm, 2);
  if (!weights) return tl::unexpected(weights.error());

  double total = 0;
  Point2 centroid(0, 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    total += (*weights)[i];
    centroid += (*weights)[i] * points[i];
  }
  centroid /= total;

  double xx = 0, xy = 0, yy = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point2 d = points[i] - centroid;
    xx += (*weights)[i] * d.x() * d.x();
    xy += (*weights)[i] * d.x() * d.y();
    yy += (*weights)[i] * d.y() * d.y();
  }
  if (largestDistance(points, centroid) < 1e-9) return inputError(kLine, "all points are the same");

  LineFit fit;
  fit.centroid = centroid;
  fit.angleRad = 0.5 * std::atan2(2 * xy, xx - yy);
  fit.points = static_cast<int>(points.size());
  const Point2 along(std::cos(fit.angleRad), std::sin(fit.angleRad));
  const Point2 across(-along.y(), along.x());
  double squares = 0, spread = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point2 d = points[i] - centroid;
    squares += across.dot(d) * across.dot(d);
    spread += (*weights)[i] * along.dot(d) * along.dot(d);
  }
  fit.rmsMm = std::sqrt(squares / static_cast<double>(points.size()));
  fit.covariance(0, 0) = 1 / total;  // about the weighted centroid offset and angle do not correlate
  fit.covariance(1, 1) = 1 / spread;
  return fit;
}

Expected<CircleFit> fitCircle(std::span<const Point2> points, std::span<const double> sigmaMm) {
  const auto weights = weightsOf(kCircle, points, sigmaMm, 3);
  if (!weights) return tl::unexpected(weights.error());

  // An origin on the circle keeps D^2 + E^2 near 1; at the centre, where full circles have their centroid, it is 0.
  const Point2 origin = points[points.size() / 2];
  std::vector<Point2> local;
  local.reserve(points.size());
  for (const Point2& p : points) local.push_back(p - origin);
  const double extent = largestDistance(local, {0, 0});
  if (extent < 1e-9) return inputError(kCircle, "all points are the same");

  const AlgebraicCircle best = refine(kasa(local, *weights), local, *weights);
  if (std::abs(best.a) * extent < 1e-9) return inputError(kCircle, "the points lie on a straight line");

  CircleFit fit;
  fit.points = static_cast<int>(points.size());
  fit.radiusMm = 0.5 / std::abs(best.a);
  const Point2 centre = -best.scale() / (2 * best.a) * Point2(std::cos(best.theta), std::sin(best.theta));
  fit.centre = origin + centre;

  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  double squares = 0;
  for (std::size_t i = 0; i < local.size(); ++i) {
    const Point2 radial = local[i] - centre;
    const double distance = std::max(radial.norm(), 1e-12);
    const Eigen::Vector3d row(-radial.x() / distance, -radial.y() / distance, -1);
    information += (*weights)[i] * row * row.transpose();
    squares += (distance - fit.radiusMm) * (distance - fit.radiusMm);
  }
  fit.rmsMm = std::sqrt(squares / static_cast<double>(points.size()));
  const Eigen::FullPivLU<Eigen::Matrix3d> lu(information);
  if (!lu.isInvertible()) return inputError(kCircle, "the points determine no circle (fewer than 3 distinct places)");
  fit.covariance = lu.inverse();
  return fit;
}

}  // namespace vignole
