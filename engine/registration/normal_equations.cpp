#include "engine/registration/normal_equations.h"

#include <Eigen/Cholesky>

namespace vignole {

Eigen::Matrix3d NormalEquations::matrix() const {
  Eigen::Matrix3d m;
  m << xx, xy, xa, xy, yy, ya, xa, ya, aa;
  return m;
}

bool NormalEquations::solve(Eigen::Vector3d& step) const {
  if (weight < 3) return false;
  Eigen::Matrix3d m = matrix();
  // A head alone, or a lost camera, may leave a direction weak: a breath of damping keeps the step finite there.
  const double damping = 1e-9 * (xx + yy);
  m(0, 0) += damping;
  m(1, 1) += damping;
  m(2, 2) += damping * 1e3;
  const Eigen::LLT<Eigen::Matrix3d> llt(m);
  if (llt.info() != Eigen::Success) return false;
  step = -llt.solve(Eigen::Vector3d(bx, by, ba));
  return step.allFinite();
}

}  // namespace vignole
