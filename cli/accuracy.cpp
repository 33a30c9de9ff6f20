#include "cli/accuracy.h"

#include <algorithm>
#include <cmath>

namespace vignole::cli {

void DimensionAccuracy::add(double errorMm, double uMm) {
  ++count_;
  sum_ += errorMm;
  sum2_ += errorMm * errorMm;
  max_ = std::max(max_, std::abs(errorMm));
  if (!(uMm > 0)) return;
  ++countWithU_;
  sumOverU_ += (errorMm / uMm) * (errorMm / uMm);
}

double DimensionAccuracy::rmsMm() const { return std::sqrt(sum2_ / static_cast<double>(count_)); }

void Accuracy::add(const Measurement& measured, const Truth& truth) {
  for (std::size_t d = 0; d < kDimensionCount; ++d) {
    const DimensionResult& result = measured.dimensions[d];
    if (result.valueMm) dimensions_[d].add(*result.valueMm - truth.valueMm[d], result.uMm);
  }
}

}  // namespace vignole::cli
