#pragma once
// A number read off fitted curves together with its first-order change when the curves move: what a dimension is made
// of, and what carries the covariance of the fits through to it.

#include <array>
#include <cassert>
#include <cstddef>

namespace vignole {

/// What may move: the datum (along, up in mm, turn in rad), the foot bottom (its three coefficients) and the frame of
/// every primitive (x, y in mm, angle in rad, curvature in 1/mm; axes of the shapes).
using Mover = std::size_t;
inline constexpr Mover kDatumMover = 0, kFootBottomMover = 1;
[[nodiscard]] constexpr Mover moverOf(std::size_t primitive) { return primitive + 2; }
[[nodiscard]] constexpr std::size_t primitiveOf(Mover mover) { return mover - 2; }

/// Slopes of a reading with the numbers of one mover.
using Slopes = std::array<double, 4>;

class Reading {
 public:
  /// The fishing height takes most, eight: four primitives, the datum, and what that hangs on: foot bottom and edges.
  static constexpr std::size_t kMaxTerms = 8;
  struct Term {
    Mover mover = 0;
    Slopes slopes{};
  };
  double value = 0;

  Reading() = default;
  Reading(double v) : value(v) {}  // NOLINT(google-explicit-constructor): a constant is a reading that nothing moves

  [[nodiscard]] const Term* begin() const { return terms_.data(); }
  [[nodiscard]] const Term* end() const { return terms_.data() + count_; }
  [[nodiscard]] Slopes slopesWith(Mover mover) const {
    for (const Term& t : *this)
      if (t.mover == mover) return t.slopes;
    return {};
  }
  /// Adds `factor` times the slopes of a mover.
  void move(Mover mover, double factor, const Slopes& slopes) {
    std::size_t k = 0;
    while (k < count_ && terms_[k].mover != mover) ++k;
    if (k == count_) {
      assert(count_ < kMaxTerms);
      terms_[count_++] = {mover, {}};
    }
    for (std::size_t i = 0; i < slopes.size(); ++i) terms_[k].slopes[i] += factor * slopes[i];
  }
  /// Adds `factor` times another reading's change, not its value.
  void moveWith(const Reading& other, double factor) {
    for (const Term& t : other) move(t.mover, factor, t.slopes);
  }
  /// The reading without the change that one mover brings.
  [[nodiscard]] Reading without(Mover mover) const {
    Reading r(value);
    for (const Term& t : *this)
      if (t.mover != mover) r.move(t.mover, 1, t.slopes);
    return r;
  }

  friend Reading operator+(const Reading& a, const Reading& b) {
    Reading r = a;
    r.value += b.value;
    r.moveWith(b, 1);
    return r;
  }
  friend Reading operator-(const Reading& a, const Reading& b) {
    Reading r = a;
    r.value -= b.value;
    r.moveWith(b, -1);
    return r;
  }
  friend Reading operator*(const Reading& a, double factor) {
    Reading r(a.value * factor);
    r.moveWith(a, factor);
    return r;
  }

 private:
  std::array<Term, kMaxTerms> terms_;
  std::size_t count_ = 0;
};

}  // namespace vignole
