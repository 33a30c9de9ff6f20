#include "calibration/range_finders/ellipse_fit.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace vignole {

namespace {

using Conic = Eigen::Matrix<double, 6, 1>;  // a x^2 + b x y + c y^2 + d x + e y + f

Eigen::Matrix<double, Eigen::Dynamic, 6> design(std::span<const Point2> points) {
  Eigen::Matrix<double, Eigen::Dynamic, 6> d(static_cast<Eigen::Index>(points.size()), 6);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = points[i].x(), y = points[i].y();
    d.row(static_cast<Eigen::Index>(i)) << x * x, x * y, y * y, x, y, 1;
  }
  return d;
}

/// S a = lambda C a with a^T C a = 1: the one positive eigenvalue (Fitzgibbon et al., theorem 1).
Expected<Conic> fitzgibbon(std::span<const Point2> points) {
  const auto d = design(points);
  const Eigen::Matrix<double, 6, 6> scatter = d.transpose() * d;
  Eigen::Matrix<double, 6, 6> constraint = Eigen::Matrix<double, 6, 6>::Zero();
  constraint(0, 2) = constraint(2, 0) = 2;
  constraint(1, 1) = -1;
  const Eigen::FullPivLU<Eigen::Matrix<double, 6, 6>> lu(scatter);
  if (!lu.isInvertible()) return inputError("ellipse", "the points lie on a line");
  const Eigen::EigenSolver<Eigen::Matrix<double, 6, 6>> solver(lu.inverse() * constraint);
  int best = -1;
  for (int i = 0; i < 6; ++i) {
    const double value = solver.eigenvalues()[i].real();
    if (std::isfinite(value) && value > 0 && (best < 0 || value > solver.eigenvalues()[best].real())) best = i;
  }
  if (best < 0) return inputError("ellipse", "no ellipse fits the points");
  return Conic(solver.eigenvectors().col(best).real());
}

/// The same with the linear part eliminated, so that nothing singular is inverted.
Expected<Conic> halirFlusser(std::span<const Point2> points) {
  const auto d = design(points);
  const auto d1 = d.leftCols<3>(), d2 = d.rightCols<3>();
  const Eigen::Matrix3d s1 = d1.transpose() * d1, s2 = d1.transpose() * d2, s3 = d2.transpose() * d2;
  const Eigen::FullPivLU<Eigen::Matrix3d> lu(s3);
  if (!lu.isInvertible()) return inputError("ellipse", "the points lie on a line");
  const Eigen::Matrix3d linearOfQuadratic = -lu.inverse() * s2.transpose();
  const Eigen::Matrix3d reduced = s1 + s2 * linearOfQuadratic;
  Eigen::Matrix3d m;  // C1^-1 * reduced
  m.row(0) = reduced.row(2) / 2;
  m.row(1) = -reduced.row(1);
  m.row(2) = reduced.row(0) / 2;
  const Eigen::EigenSolver<Eigen::Matrix3d> solver(m);
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d a = solver.eigenvectors().col(i).real();
    if (std::abs(solver.eigenvalues()[i].imag()) > 0 || !(4 * a[0] * a[2] - a[1] * a[1] > 0)) continue;
    Conic conic;
    conic << a, linearOfQuadratic * a;
    return conic;
  }
  return inputError("ellipse", "no ellipse fits the points");
}

Expected<Ellipse> ellipseOf(const Conic& conic) {
  const double a = conic[0], b = conic[1], c = conic[2];
  const double det = 4 * a * c - b * b;
  const auto none = [] { return inputError("ellipse", "no ellipse fits the points"); };
  if (!(det > 0)) return none();
  Ellipse ellipse;
  ellipse.centre = {(b * conic[4] - 2 * c * conic[3]) / det, (b * conic[3] - 2 * a * conic[4]) / det};
  const double constant = conic[5] + (conic[3] * ellipse.centre.x() + conic[4] * ellipse.centre.y()) / 2;
  Eigen::Matrix2d quadratic;
  quadratic << a, b / 2, b / 2, c;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(quadratic);
  const Eigen::Array2d squares = -constant / solver.eigenvalues().array();
  if (!(squares > 0).all() || !squares.isFinite().all()) return none();
  const int major = squares[0] > squares[1] ? 0 : 1;
  ellipse.majorPx = std::sqrt(squares[major]);
  ellipse.minorPx = std::sqrt(squares[1 - major]);
  ellipse.angleRad = std::atan2(solver.eigenvectors()(1, major), solver.eigenvectors()(0, major));
  return ellipse;
}

struct Named {
  EllipseFitVariant variant;
  std::string_view name;
};
constexpr std::array<Named, 3> kNames = {Named{EllipseFitVariant::Fitzgibbon, "fitzgibbon"},
                                         Named{EllipseFitVariant::HalirFlusser, "halir-flusser"},
                                         Named{EllipseFitVariant::Normalised, "normalised"}};

}  // namespace

std::string_view name(EllipseFitVariant variant) {
  for (const Named& n : kNames)
    if (n.variant == variant) return n.name;
  return {};
}

Expected<EllipseFitVariant> ellipseFitNamed(std::string_view name) {
  for (const Named& n : kNames)
    if (n.name == name) return n.variant;
  return inputError("fit", "'" + std::string(name) + "' is none of fitzgibbon, halir-flusser, normalised");
}

// Ramanujan's second approximation.
double Ellipse::perimeterPx() const {
  const double h = std::pow((majorPx - minorPx) / (majorPx + minorPx), 2);
  return std::numbers::pi * (majorPx + minorPx) * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h)));
}

Expected<Ellipse> fitEllipse(std::span<const Point2> points, EllipseFitVariant variant) {
  if (points.size() < 6) return inputError("ellipse", "needs at least 6 points");
  if (variant == EllipseFitVariant::HalirFlusser) return halirFlusser(points).and_then(ellipseOf);
  Point2 mean(0, 0);
  for (const Point2& p : points) mean += p / static_cast<double>(points.size());
  if (variant == EllipseFitVariant::Fitzgibbon) {
    // The constraint does not change with the origin; far from it the scatter matrix cannot be inverted in doubles.
    std::vector<Point2> about;
    about.reserve(points.size());
    for (const Point2& p : points) about.emplace_back(p - mean);
    auto ellipse = fitzgibbon(about).and_then(ellipseOf);
    if (ellipse) ellipse->centre += mean;
    return ellipse;
  }
  double square = 0;
  for (const Point2& p : points) square += (p - mean).squaredNorm() / static_cast<double>(points.size());
  const double scale = std::sqrt(square / 2);
  if (!(scale > 0)) return inputError("ellipse", "the points lie on a line");
  std::vector<Point2> unit;
  unit.reserve(points.size());
  for (const Point2& p : points) unit.emplace_back((p - mean) / scale);
  auto ellipse = halirFlusser(unit).and_then(ellipseOf);
  if (!ellipse) return ellipse;
  ellipse->centre = mean + scale * ellipse->centre;
  ellipse->majorPx *= scale;
  ellipse->minorPx *= scale;
  return ellipse;
}

}  // namespace vignole
