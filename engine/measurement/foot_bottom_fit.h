#pragma once
// Least-squares parabola through the foot bottom: y = c0 + c1 u + c2 u^2 with u = x / kScaleMm, outliers weighted away.

#include "engine/measurement/definitions.h"
#include "engine/measurement/robust_rounds.h"

namespace vignole {

class FootBottomFit {
 public:
  /// Points in the section frame; their pull is left: what it does to so flat a curve is less than 0.1 micrometre.
  void solve(const FitPoints& points, double correlatedPoints);
  [[nodiscard]] const FitSolution& solution() const { return solution_; }
  [[nodiscard]] Parabola parabola() const { return {c_[0], c_[1] / kScaleMm, c_[2] / (kScaleMm * kScaleMm)}; }
  /// Slopes with the three unknowns from slopes with the parabola's coefficients.
  [[nodiscard]] static UnknownVector gradient(const Slopes& s) {
    return {s[0], s[1] / kScaleMm, s[2] / (kScaleMm * kScaleMm)};
  }

 private:
  static constexpr double kScaleMm = 60;
  double round(const FitPoints& points, const Weighting& weighting);

  std::array<double, 3> c_{};
  FitSolution solution_;
  RobustRounds rounds_;
};

}  // namespace vignole
