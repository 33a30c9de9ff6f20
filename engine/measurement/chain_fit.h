#pragma once
// Least-squares fit of a chain of tangent primitives to points, by Gauss-Newton with outliers weighted away.

#include <array>
#include <vector>

#include "engine/measurement/chain_plan.h"
#include "engine/measurement/curve_piece.h"
#include "engine/measurement/robust_rounds.h"

namespace vignole {

/// A piece, and how its frame (x, y, angle, curvature) moves with the unknowns of its chain.
struct FittedPiece {
  CurvePiece piece;
  std::array<UnknownVector, 4> perUnknown{};
};

class ChainFit {
 public:
  ChainFit(const Section& section, ChainPlan plan);

  [[nodiscard]] const ChainPlan& plan() const { return plan_; }
  /// Where the points of the fit have their origin, section frame.
  [[nodiscard]] const Vec& origin() const { return origin_; }
  /// Fits primitives `first` .. `last` of the plan (the anchor among them).
  void solve(const FitPoints& points, std::size_t first, std::size_t last, double correlatedPoints);
  [[nodiscard]] const FitSolution& solution() const { return solution_; }
  /// After solve: primitive `k` of the plan in the frame of the points, its range between the breaks; the ends of the
  /// chain stand at the nominal ends.
  [[nodiscard]] const FittedPiece& piece(std::size_t k) const { return pieces_[k]; }

 private:
  void layOut(std::size_t first, std::size_t last);
  void walk();
  void step(std::size_t from, std::size_t to);
  double round(const FitPoints& points, const Weighting& weighting, bool free);
  [[nodiscard]] std::size_t pieceAt(double x, double y) const;
  [[nodiscard]] double residual(const FitPoints& points, std::size_t i) const;
  [[nodiscard]] UnknownVector slopes(const FitPoints& points, std::size_t i) const;

  ChainPlan plan_;
  Vec origin_;
  std::vector<CurvePiece> nominal_;  ///< origin at each primitive's start, frame of the points
  std::vector<double> startMm_;      ///< nominal arc length of each primitive's start, 0 at the anchor's middle
  CurvePiece anchorNominal_;
  std::vector<int> curvatureUnknown_, breakUnknown_;  ///< per primitive (break after it): which unknown, or -1
  std::size_t first_ = 0, last_ = 0;
  UnknownVector state_{};
  std::vector<FittedPiece> pieces_;
  std::vector<Stretch> stretches_;
  FitSolution solution_;
  RobustRounds rounds_;
};

}  // namespace vignole
