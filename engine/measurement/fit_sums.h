#pragma once
// Sums over the points of a fit: residuals from a curve, weighted against outliers, as normal equations of the curve's
// frame. The order of the additions is the same on every machine.

#include <array>
#include <cstddef>
#include <limits>

#include "engine/measurement/curve_piece.h"
#include "engine/measurement/fit_points.h"

namespace vignole {

/// Residuals whose square in variances reaches cut2 do not count; below it all alike (hard) or less and less.
struct Weighting {
  double cut2 = 0;
  bool hard = false;
};

/// Points between two lines across the chain, where its pieces meet: x * along.x + y * along.y within (from, to].
struct Stretch {
  struct Line {
    double x = 0, y = 0, at = 0;
  };
  bool bounded = false;  ///< false: all points
  Line from{0, 0, -std::numeric_limits<double>::infinity()}, to{0, 0, std::numeric_limits<double>::infinity()};
};

/// Residuals of the points that count.
struct ResidualSums {
  double chi2 = 0;     ///< square over variance
  double squares = 0;  ///< mm^2
  double count = 0;
  [[nodiscard]] ResidualSums since(const ResidualSums& before) const {
    return {chi2 - before.chi2, squares - before.squares, count - before.count};
  }
};

/// Normal equations J^T W J, J^T W r of a piece in x, y, angle and curvature of its frame; J: slopes of the residual.
struct FrameSums {
  std::array<std::array<double, 4>, 4> matrix{};  ///< upper triangle
  std::array<double, 4> vector{};
  ResidualSums residuals;
};
/// `piece` in the frame of the points. Adds; a straight piece has no sums for its curvature.
void addPiece(const FitPoints& points, const FitPoints::Run& run, const CurvePiece& piece, const Stretch& stretch,
              const Weighting& weighting, FrameSums& sums);

/// The same for y = c0 + c1 u + c2 u^2 with u = x / scale; J = (1, u, u^2), the residual is y less the parabola.
struct ParabolaSums {
  std::array<double, 5> powers{};  ///< sums of w u^k
  std::array<double, 3> vector{};  ///< sums of w r u^k
  ResidualSums residuals;
};
void addParabola(const FitPoints& points, const FitPoints::Run& run, const std::array<double, 3>& c, double scaleMm,
                 const Weighting& weighting, ParabolaSums& sums);

struct Interval {
  float low = 0, high = 0;
};
/// Of at least one value.
[[nodiscard]] Interval intervalOf(const float* values, std::size_t count);

}  // namespace vignole
