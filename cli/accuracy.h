#pragma once
// How far the measured dimensions are from the truth of the virtual rig, over single profiles.

#include <cstdint>
#include <optional>

#include "engine/measurement/measurement.h"
#include "engine/simulator/virtual_rig.h"

namespace vignole::cli {

/// Errors (measured - true) of one dimension; HF is judged on the signed value of HF_max, FC on its signed value.
class DimensionAccuracy {
 public:
  void add(double errorMm, double uMm);
  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] double biasMm() const { return sum_ / static_cast<double>(count_); }
  [[nodiscard]] double rmsMm() const;
  [[nodiscard]] double maxMm() const { return max_; }
  /// 1 if the stated uncertainties are right. Over the profiles that state one: HF is exactly 0 +- 0 where the whole
  /// crown lies below the nominal one. Empty if none does.
  [[nodiscard]] std::optional<double> meanSquareErrorOverU() const {
    if (countWithU_ == 0) return {};
    return sumOverU_ / static_cast<double>(countWithU_);
  }

 private:
  std::uint64_t count_ = 0, countWithU_ = 0;
  double sum_ = 0, sum2_ = 0, max_ = 0, sumOverU_ = 0;
};

class Accuracy {
 public:
  void add(const Measurement& measured, const Truth& truth);
  [[nodiscard]] const DimensionAccuracy& of(Dimension dimension) const { return dimensions_[index(dimension)]; }

 private:
  PerDimension<DimensionAccuracy> dimensions_;
};

}  // namespace vignole::cli
