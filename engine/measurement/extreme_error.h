#pragma once
// The error of an extreme (HF_max, HF_min): of several places whose deviations cannot be told apart, noise picks the
// most extreme, so the error of the extreme is the extreme of their errors.

#include <array>
#include <vector>

#include "engine/measurement/primitive_fits.h"

namespace vignole {

class ExtremeError {
 public:
  ExtremeError();
  void begin(const Reading& extreme, const PrimitiveFits& fits);
  /// Counts a place in if it lies within 2.5 standard uncertainties of its difference from the extreme; sign +1:
  /// maximum.
  void consider(const Reading& place, double sign);
  /// E[(max of the errors of all places)^2], by fixed normal deviates: the same input, the same bits.
  [[nodiscard]] double meanSquareError() const;

 private:
  static constexpr std::size_t kMaxPlaces = 16;
  static constexpr std::size_t kDraws = 256;
  using Draws = std::array<double, kDraws>;
  const PrimitiveFits* fits_ = nullptr;
  double extremeMm_ = 0;
  std::vector<Deviations> places_;
  std::array<Draws, kMaxPlaces> deviates_;
};

}  // namespace vignole
