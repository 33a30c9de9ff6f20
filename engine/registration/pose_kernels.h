#pragma once
// The inner loops of the registration, as vector code chosen at run time. Single precision: within a metre of the
// anchor it resolves 0.01 um.

#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/registration/normal_equations.h"

namespace vignole {

/// A line (a = normal, c = offset, side = 0) or circle (a = centre, c = radius, side = +1 where outwards is away from
/// the centre, else -1). Section frame, mm.
struct FlatCarrier {
  float ax = 0, ay = 0, c = 0, side = 0;
};

/// A rigid motion that is applied to points as they are loaded.
struct Motion {
  float cosine = 1, sine = 0, x = 0, y = 0;
};

struct Points {
  const float* x = nullptr;
  const float* y = nullptr;
  std::size_t count = 0;
};

/// Cells of a grid in the section frame, x fastest.
struct CellFrame {
  float x0 = 0, y0 = 0, perCell = 1;
  int columns = 0, rows = 0;
};

/// Points [from, to) of a list that belong to one primitive.
struct Run {
  std::uint32_t primitive = 0, from = 0, to = 0;
};

struct Tukey {
  float centreY = 0;  ///< turns are about (0, centreY)
  float scaleMm = 1;  ///< distance at which a weight vanishes
};

/// Lists are read up to this many floats beyond their end.
constexpr std::size_t kSlack = 64;

/// The cell of every point after the motion; points outside get the nearest cell of the rim.
void locate(const Points& points, const Motion& motion, const CellFrame& frame, std::int32_t* cells);

/// One carrier a point, by index; indices >= kFarAway count as far from the outline (less kFarAway: the carrier).
constexpr std::int32_t kFarAway = 1 << 15;
/// Adds to the sums; returns the sum of min(distance^2 / 1 mm^2, 1).
double sumScattered(const Points& points, const Motion& motion, const FlatCarrier* carriers,
                    const std::int32_t* carrierOf, const Tukey& tukey, NormalEquations& sums);

/// The same for points that are laid out primitive by primitive.
void sumRuns(const Points& points, const Motion& motion, const FlatCarrier* carriers, std::span<const Run> runs,
             const Tukey& tukey, NormalEquations& sums);

struct ResidualLimits {
  float assignMm = 3, inlierMm = 0.1F, nearMm = 1;
};
struct RunResiduals {
  double assigned = 0, sum = 0, squares = 0, chi2 = 0;  ///< over |residual| <= assignMm
  double near = 0, nearChi2 = 0;                        ///< over |residual| < nearMm
  double inliers = 0, inlierSquares = 0, inlierVariance = 0;
};
/// Signed distances of a run to its carrier, > 0 outside, and their sums. residuals has room for kSlack more.
RunResiduals residualsOf(const Points& points, const float* sigmaMm, const Motion& motion, const FlatCarrier& carrier,
                         const Run& run, const ResidualLimits& limits, float* residuals);

}  // namespace vignole
