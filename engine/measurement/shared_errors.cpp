#include "engine/measurement/shared_errors.h"

#include <cmath>
#include <numbers>

namespace vignole {
namespace {

constexpr double kIndependent = 1.01;  // points that share so little are independent

/// Second antiderivative of the correlation exp(-x^2 / 4 s^2): its second differences are covariances of sums over
/// blocks.
double twiceIntegrated(double x, double s) {
  const double z = x / (2 * s);
  return s * (std::sqrt(std::numbers::pi) * x * std::erf(z) + 2 * s * std::exp(-z * z));
}

}  // namespace

void SharedErrors::add(const std::array<UnknownVector, kMaxBlocks>& slopes, std::size_t blocks, double size) {
  const double s = correlated_ / (2 * std::sqrt(std::numbers::pi));
  std::array<double, kMaxBlocks> covariance;
  double before = twiceIntegrated(size, s), here = twiceIntegrated(0, s), beyond = before;
  std::size_t lags = 0;
  do {
    covariance[lags] = before - 2 * here + beyond;
    before = here;
    here = beyond;
    ++lags;
    beyond = twiceIntegrated(static_cast<double>(lags + 1) * size, s);
  } while (lags < blocks && before - 2 * here + beyond > 1e-3 * covariance[0]);

  for (std::size_t a = 0; a < blocks; ++a) {
    UnknownVector around{};
    for (std::size_t b = a + 1 < lags ? 0 : a + 1 - lags; b < std::min(blocks, a + lags); ++b) {
      const double c = covariance[a < b ? b - a : a - b];
      for (std::size_t i = 0; i < unknowns_; ++i) around[i] += c * slopes[b][i];
    }
    for (std::size_t i = 0; i < unknowns_; ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        shared_[i][j] += slopes[a][i] * around[j];
        independent_[i][j] += size * slopes[a][i] * slopes[a][j];
      }
  }
}

UnknownMatrix SharedErrors::factor(const NormalFactor& normal) const {
  const UnknownMatrix& lower = normal.lower();
  NormalFactor own;
  if (correlated_ < kIndependent || !own.decompose(independent_, unknowns_)) return lower;
  // Cholesky factor of B; it may be of lower rank where all points share one error.
  UnknownMatrix root{};
  for (std::size_t j = 0; j < unknowns_; ++j)
    for (std::size_t i = j; i < unknowns_; ++i) {
      double c = shared_[i][j];
      for (std::size_t k = 0; k < j; ++k) c -= root[i][k] * root[j][k];
      if (i == j)
        root[j][j] = c > 1e-12 * shared_[j][j] ? std::sqrt(c) : 0;
      else
        root[i][j] = root[j][j] > 0 ? c / root[j][j] : 0;
    }
  // What the blocks say of A is rough, and holds points that the fit left out: B counts in relation to it.
  UnknownMatrix factor{};
  for (std::size_t j = 0; j < unknowns_; ++j) {
    UnknownVector column{};
    for (std::size_t i = j; i < unknowns_; ++i) column[i] = root[i][j];
    column = own.whitened(column);
    for (std::size_t i = j; i < unknowns_; ++i)
      for (std::size_t k = j; k <= i; ++k) factor[i][j] += lower[i][k] * column[k];
  }
  return factor;
}

}  // namespace vignole
