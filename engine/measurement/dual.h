#pragma once
// Numbers that carry their gradient: the definitions of the dimensions are written once and evaluated with double for
// nominals and with Dual for measured values, whose gradient then carries the covariance of the fits through.

#include <array>
#include <cmath>
#include <cstddef>

namespace vignole {

/// Value and gradient with respect to N parameters (forward-mode differentiation).
template <std::size_t N>
struct Dual {
  double value = 0;
  std::array<double, N> gradient{};

  Dual() = default;
  Dual(double v) : value(v) {}  // NOLINT(google-explicit-constructor): a constant is a Dual without gradient
  static Dual variable(double v, std::size_t parameter) {
    Dual d(v);
    d.gradient[parameter] = 1;
    return d;
  }
  /// f(value) with slope df: the chain rule for functions of one argument.
  [[nodiscard]] Dual chain(double f, double df) const {
    Dual r(f);
    for (std::size_t i = 0; i < N; ++i) r.gradient[i] = df * gradient[i];
    return r;
  }
  /// f(a, b) with slopes fa and fb.
  [[nodiscard]] static Dual combine(double f, double fa, const Dual& a, double fb, const Dual& b) {
    Dual r(f);
    for (std::size_t i = 0; i < N; ++i) r.gradient[i] = fa * a.gradient[i] + fb * b.gradient[i];
    return r;
  }
  friend Dual operator+(const Dual& a, const Dual& b) { return combine(a.value + b.value, 1, a, 1, b); }
  friend Dual operator-(const Dual& a, const Dual& b) { return combine(a.value - b.value, 1, a, -1, b); }
  friend Dual operator*(const Dual& a, const Dual& b) { return combine(a.value * b.value, b.value, a, a.value, b); }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const double q = a.value / b.value;
    return combine(q, 1 / b.value, a, -q / b.value, b);
  }
  friend Dual operator+(const Dual& a, double b) { return a.chain(a.value + b, 1); }
  friend Dual operator+(double a, const Dual& b) { return b.chain(a + b.value, 1); }
  friend Dual operator-(const Dual& a, double b) { return a.chain(a.value - b, 1); }
  friend Dual operator-(double a, const Dual& b) { return b.chain(a - b.value, -1); }
  friend Dual operator*(const Dual& a, double b) { return a.chain(a.value * b, b); }
  friend Dual operator*(double a, const Dual& b) { return b.chain(a * b.value, a); }
  friend Dual operator/(const Dual& a, double b) { return a.chain(a.value / b, 1 / b); }
  friend Dual operator/(double a, const Dual& b) { return b.chain(a / b.value, -a / (b.value * b.value)); }
  friend Dual operator-(const Dual& a) { return a.chain(-a.value, -1); }
  friend Dual sqrt(const Dual& a) {
    const double r = std::sqrt(a.value);
    return a.chain(r, 0.5 / r);
  }
  friend Dual sin(const Dual& a) { return a.chain(std::sin(a.value), std::cos(a.value)); }
  friend Dual cos(const Dual& a) { return a.chain(std::cos(a.value), -std::sin(a.value)); }
};

[[nodiscard]] inline double valueOf(double a) { return a; }
template <std::size_t N>
[[nodiscard]] double valueOf(const Dual<N>& a) {
  return a.value;
}

}  // namespace vignole
