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
  for (Draws& row : deviates_) {
    double mean = 0, squares = 0;
    for (std::size_t draw = 0; draw < kDraws; draw += 2) {
      const double r = std::sqrt(-2 * std::log(uniform())), a = 2 * std::numbers::pi * uniform();
      row[draw] = r * std::cos(a);
      row[draw + 1] = r * std::sin(a);
    }
    for (const double d : row) mean += d / kDraws;
    for (double& d : row) d -= mean;
    for (const double d : row) squares += d * d;
    for (double& d : row) d *= std::sqrt(kDraws / squares);
  }
  places_.reserve(kMaxPlaces);
}

void ExtremeError::begin(const Reading& extreme, const PrimitiveFits& fits) {
  fits_ = &fits;
  extremeMm_ = extreme.value;
  places_.assign(1, fits.deviations(extreme));
}

void ExtremeError::consider(const Reading& place, double sign) {
  if (places_.size() >= kMaxPlaces) return;
  const Deviations deviations = fits_->deviations(place);
  double variance = 0;
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    const double d = deviations[i] - places_.front()[i];
    variance += d * d;
  }
  const double u = std::sqrt(variance), behind = sign * (extremeMm_ - place.value);
  const bool same = u < 1e-9 && std::abs(behind) < 1e-9;
  if (!same && behind < kTellApart * u) places_.push_back(deviations);
}

double ExtremeError::meanSquareError() const {
  const std::size_t n = places_.size();
  std::array<std::array<double, kMaxPlaces>, kMaxPlaces> lower;
  for (std::size_t i = 0; i < n; ++i)  // Cholesky that bears places without a variance of their own
    for (std::size_t j = 0; j <= i; ++j) {
      double c = covariance(places_[i], places_[j]);
      for (std::size_t k = 0; k < j; ++k) c -= lower[i][k] * lower[j][k];
      if (i == j)
        lower[i][i] = c > 1e-18 ? std::sqrt(c) : 0;
      else
        lower[i][j] = lower[j][j] > 0 ? c / lower[j][j] : 0;
    }
  Draws largest;
  largest.fill(-1e300);
  for (std::size_t i = 0; i < n; ++i) {
    Draws error{};
    for (std::size_t k = 0; k <= i; ++k)
      for (std::size_t draw = 0; draw < kDraws; ++draw) error[draw] += lower[i][k] * deviates_[k][draw];
    for (std::size_t draw = 0; draw < kDraws; ++draw)
      largest[draw] = largest[draw] > error[draw] ? largest[draw] : error[draw];
  }
  double sum = 0;
  for (const double e : largest) sum += e * e;
  return sum / kDraws;
}

}  // namespace vignole
