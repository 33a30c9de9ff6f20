#pragma once
// The error of an extreme (HF_max, HF_min): of several places whose deviations cannot be told apart, noise picks the
// most extreme, so the error of the extreme is the extreme of their errors.

#include <Eigen/Core>
#include <vector>

#include "engine/measurement/primitive_fits.h"

namespace vignole {

class ExtremeError {
 public:
  ExtremeError();
  void begin(const GlobalDual& extreme, const PrimitiveFits& fits);
  /// Counts a place in if it lies within 2.5 standard uncertainties of its difference from the extreme; sign +1:
  /// maximum.
  void consider(const GlobalDual& place, double sign);
  /// E[(max of the errors of all places)^2], by fixed normal deviates: the same input, the same bits.
  [[nodiscard]] double meanSquareError() const;

 private:
  static constexpr int kMaxPlaces = 16;
  static constexpr int kDraws = 256;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxPlaces, kMaxPlaces>;
  const PrimitiveFits* fits_ = nullptr;
  std::vector<GlobalDual> places_;
  Eigen::Matrix<double, kMaxPlaces, kDraws> deviates_;
};

}  // namespace vignole
