#pragma once
// Cholesky factor of the normal equations of a fit with a few unknowns.

#include <array>
#include <cmath>
#include <cstddef>

namespace vignole {

inline constexpr std::size_t kMaxUnknowns = 8;
using UnknownVector = std::array<double, kMaxUnknowns>;
using UnknownMatrix = std::array<UnknownVector, kMaxUnknowns>;

class NormalFactor {
 public:
  /// Of the leading n by n of a symmetric matrix, lower triangle read. False if an unknown is not determined.
  bool decompose(const UnknownMatrix& a, std::size_t n) {
    n_ = n;
    for (std::size_t j = 0; j < n; ++j) {
      double d = a[j][j];
      for (std::size_t k = 0; k < j; ++k) d -= l_[j][k] * l_[j][k];
      if (!(d > kLeastPivot * a[j][j])) return false;
      l_[j][j] = std::sqrt(d);
      perPivot_[j] = 1 / l_[j][j];
      for (std::size_t i = j + 1; i < n; ++i) {
        double s = a[i][j];
        for (std::size_t k = 0; k < j; ++k) s -= l_[i][k] * l_[j][k];
        l_[i][j] = s * perPivot_[j];
      }
    }
    return true;
  }
  /// L^-1 g: the squares of this add up to g^T A^-1 g, the variance of a quantity with gradient g.
  [[nodiscard]] UnknownVector whitened(UnknownVector g) const {
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t k = 0; k < i; ++k) g[i] -= l_[i][k] * g[k];
      g[i] *= perPivot_[i];
    }
    return g;
  }
  /// A^-1 b.
  [[nodiscard]] UnknownVector solve(const UnknownVector& b) const {
    UnknownVector x = whitened(b);
    for (std::size_t i = n_; i-- > 0;) {
      for (std::size_t k = i + 1; k < n_; ++k) x[i] -= l_[k][i] * x[k];
      x[i] *= perPivot_[i];
    }
    return x;
  }

  /// L of A = L L^T.
  [[nodiscard]] const UnknownMatrix& lower() const { return l_; }

 private:
  static constexpr double kLeastPivot = 1e-13;  // of the diagonal: below, rounding is all there is
  std::size_t n_ = 0;
  UnknownMatrix l_{};
  UnknownVector perPivot_{};
};

}  // namespace vignole
