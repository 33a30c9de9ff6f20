#include "engine/registration/normal_equations.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace vignole {
namespace {

double tukey(double r, double perScaleSquared) {
  const double u = std::fmax(0.0, 1 - r * r * perScaleSquared);
  return u * u;
}

}  // namespace

void NormalEquations::add(const Carrier& c, const double* x, const double* y, std::size_t count, double centreX,
                          double centreY, double scaleMm) {
  const double perScale2 = 1 / (scaleMm * scaleMm);
  if (!c.isArc) {  // one normal for all: a third of the sums
    double w0 = 0, w1 = 0, w2 = 0, r0 = 0, r1 = 0, rr = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double r = c.nx * x[i] + c.ny * y[i] - c.offset;
      const double w = tukey(r, perScale2);
      const double turn = (x[i] - centreX) * c.ny - (y[i] - centreY) * c.nx;
      w0 += w;
      w1 += w * turn;
      w2 += w * turn * turn;
      r0 += w * r;
      r1 += w * r * turn;
      rr += w * r * r;
    }
    xx += w0 * c.nx * c.nx;
    xy += w0 * c.nx * c.ny;
    yy += w0 * c.ny * c.ny;
    xa += w1 * c.nx;
    ya += w1 * c.ny;
    aa += w2;
    bx += r0 * c.nx;
    by += r0 * c.ny;
    ba += r1;
    weight += w0;
    weightedSquares += rr;
    return;
  }
  NormalEquations s;
  for (std::size_t i = 0; i < count; ++i) {
    const double dx = x[i] - c.x, dy = y[i] - c.y;
    const double distance = std::sqrt(dx * dx + dy * dy) + 1e-300;  // the centre itself has no normal
    const double nx = c.outward * dx / distance, ny = c.outward * dy / distance;
    const double r = c.outward * (distance - c.radius);
    const double w = tukey(r, perScale2);
    const double turn = (x[i] - centreX) * ny - (y[i] - centreY) * nx;
    s.xx += w * nx * nx;
    s.xy += w * nx * ny;
    s.xa += w * nx * turn;
    s.yy += w * ny * ny;
    s.ya += w * ny * turn;
    s.aa += w * turn * turn;
    s.bx += w * nx * r;
    s.by += w * ny * r;
    s.ba += w * turn * r;
    s.weight += w;
    s.weightedSquares += w * r * r;
  }
  xx += s.xx;
  xy += s.xy;
  xa += s.xa;
  yy += s.yy;
  ya += s.ya;
  aa += s.aa;
  bx += s.bx;
  by += s.by;
  ba += s.ba;
  weight += s.weight;
  weightedSquares += s.weightedSquares;
}

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
