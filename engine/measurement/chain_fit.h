#pragma once
// Least-squares fit of a chain of tangent primitives to points, by Gauss-Newton with outliers weighted away.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "engine/measurement/chain_plan.h"
#include "engine/measurement/curve_piece.h"
#include "engine/profile/profile.h"

namespace vignole {

inline constexpr std::size_t kMaxUnknowns = 8;
using LocalDual = Dual<kMaxUnknowns>;
using UnknownVector = Eigen::Matrix<double, static_cast<int>(kMaxUnknowns), 1>;
using UnknownMatrix = Eigen::Matrix<double, static_cast<int>(kMaxUnknowns), static_cast<int>(kMaxUnknowns)>;

/// Section frame, mm; weight 1 / sigma^2. `pullMm2` times the curvature is how far the line filter has pulled the point
/// to the inside of the bend (ProfilePoint::smoothingMm^2 / 2): the fit is of the curve that the filter saw, so that
/// the curve itself comes out, with the curvature of the data and not of the section.
struct FitPoint {
  double x = 0, y = 0, weight = 1, pullMm2 = 0;
  std::uint8_t camera = 0;
};

/// How well the points of each camera lie on a fit: sum of (residual / sigma)^2 over the points that were kept.
struct FitScatter {
  std::array<double, kCameraCount> chi2{};
  std::array<int, kCameraCount> points{};
  [[nodiscard]] int total() const {
    int n = 0;
    for (const int p : points) n += p;
    return n;
  }
  [[nodiscard]] double sum() const {
    double s = 0;
    for (const double c : chi2) s += c;
    return s;
  }
};

/// Unknowns of the fit and their covariance for independent points of the given sigmas.
struct FitSolution {
  bool valid = false;
  std::size_t unknowns = 0;
  UnknownMatrix covariance = UnknownMatrix::Zero();
  FitScatter scatter;
  double meanSquareMm2 = 0;  ///< of the residuals of the points that were kept
};

class ChainFit {
 public:
  ChainFit(const Section& section, ChainPlan plan);

  [[nodiscard]] const ChainPlan& plan() const { return plan_; }
  std::vector<FitPoint>& points() { return points_; }
  /// Fits primitives `first` .. `last` of the plan (the anchor among them) to points().
  void solve(std::size_t first, std::size_t last);
  [[nodiscard]] const FitSolution& solution() const { return solution_; }
  /// After solve: primitive `k` of the plan, its range between the breaks; the ends of the chain stand at the nominal
  /// ends. Gradient with respect to the unknowns.
  [[nodiscard]] const CurvePiece<LocalDual>& piece(std::size_t k) const { return pieces_[k]; }

 private:
  struct Unknowns {
    std::size_t count = 0;
    std::vector<int> curvature, breakAfter;  ///< per primitive: index of the unknown or -1
  };
  void layOut(std::size_t first, std::size_t last);
  void walk();
  double accumulate(double cut, bool hard, std::size_t stride, UnknownMatrix& a, UnknownVector& b);
  [[nodiscard]] double robustScale();
  [[nodiscard]] std::size_t pieceAt(double x, double y) const;

  ChainPlan plan_;
  std::vector<CurvePiece<double>> nominal_;  ///< origin at each primitive's start
  std::vector<double> startMm_;              ///< nominal arc length of each primitive's start, 0 at the anchor's middle
  CurvePiece<double> anchorNominal_;
  std::vector<FitPoint> points_;
  std::vector<double> sorted_;
  Unknowns unknowns_;
  std::size_t first_ = 0, last_ = 0;
  UnknownVector state_ = UnknownVector::Zero();
  std::vector<CurvePiece<LocalDual>> pieces_;
  struct Break {
    double x = 0, y = 0, tx = 0, ty = 0;
  };
  std::vector<CurvePiece<double>> plain_;
  std::vector<Break> breaks_;
  /// Normal equations of one piece in x, y, angle and curvature of its frame.
  struct FrameSums {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    Eigen::Vector4d vector = Eigen::Vector4d::Zero();
  };
  std::vector<FrameSums> sums_;
  FitSolution solution_;
};

/// Parabola y = c0 + c1 u + c2 u^2 with u = x / kFootScaleMm, fitted likewise; the unknowns are c0, c1, c2.
class FootBottomFit {
 public:
  std::vector<FitPoint>& points() { return points_; }
  void solve();
  [[nodiscard]] const FitSolution& solution() const { return solution_; }
  [[nodiscard]] const Eigen::Vector3d& coefficients() const { return c_; }
  static constexpr double kFootScaleMm = 60;

 private:
  double accumulate(double cut, bool hard, std::size_t stride, Eigen::Matrix3d& a, Eigen::Vector3d& b);
  std::vector<FitPoint> points_;
  std::vector<double> sorted_;
  Eigen::Vector3d c_ = Eigen::Vector3d::Zero();
  FitSolution solution_;
};

}  // namespace vignole
