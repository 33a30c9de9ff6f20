#include "engine/measurement/extreme_error.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace vignole {

constexpr double kTellApart = 2.5;  // below, noise may have picked the extreme

ExtremeError::ExtremeError() {
  // std::normal_distribution differs between libraries: Box-Muller on the generator, whose sequence is standard.
  std::mt19937_64 random(20240229);
  const auto uniform = [&] { return (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53; };
  for (int row = 0; row < kMaxPlaces; ++row) {
    for (int draw = 0; draw < kDraws; draw += 2) {
      const double r = std::sqrt(-2 * std::log(uniform())), a = 2 * std::numbers::pi * uniform();
      deviates_(row, draw) = r * std::cos(a);
      deviates_(row, draw + 1) = r * std::sin(a);
    }
    const double mean = deviates_.row(row).mean();
    deviates_.row(row).array() -= mean;
    deviates_.row(row) *= std::sqrt(kDraws / deviates_.row(row).squaredNorm());
  }
  places_.reserve(kMaxPlaces);
}

void ExtremeError::begin(const GlobalDual& extreme, const PrimitiveFits& fits) {
  fits_ = &fits;
  places_.clear();
  places_.push_back(extreme);
}

void ExtremeError::consider(const GlobalDual& place, double sign) {
  if (places_.size() >= static_cast<std::size_t>(kMaxPlaces)) return;
  const GlobalDual difference = places_.front() - place;
  const double u = std::sqrt(std::max(0.0, fits_->variance(difference)));
  const bool same = u < 1e-9 && std::abs(difference.value) < 1e-9;
  if (!same && sign * difference.value < kTellApart * u) places_.push_back(place);
}

double ExtremeError::meanSquareError() const {
  const auto n = static_cast<int>(places_.size());
  Matrix lower = Matrix::Zero(n, n);
  for (int i = 0; i < n; ++i)  // Cholesky that bears places without a variance of their own
    for (int j = 0; j <= i; ++j) {
      double c = fits_->covariance(places_[static_cast<std::size_t>(i)], places_[static_cast<std::size_t>(j)]);
      for (int k = 0; k < j; ++k) c -= lower(i, k) * lower(j, k);
      if (i == j)
        lower(i, i) = c > 1e-18 ? std::sqrt(c) : 0;
      else
        lower(i, j) = lower(j, j) > 0 ? c / lower(j, j) : 0;
    }
  double sum = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    double largest = -1e300;
    for (int i = 0; i < n; ++i) {
      double e = 0;
      for (int k = 0; k <= i; ++k) e += lower(i, k) * deviates_(k, draw);
      largest = std::max(largest, e);
    }
    sum += largest * largest;
  }
  return sum / kDraws;
}

}  // namespace vignole
