#pragma once
// Count, mean, variance, extremes of a stream of numbers in constant memory (Welford 1962).

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "engine/quality/distributions.h"

namespace vignole {

class RunningStatistics {
 public:
  RunningStatistics() = default;
  /// As it was when these numbers were taken from it.
  RunningStatistics(std::uint64_t count, double mean, double sd, double min, double max) : count_(count) {
    if (count == 0) return;
    mean_ = mean;
    m2_ = sd * sd * static_cast<double>(count - 1);
    min_ = min;
    max_ = max;
  }
  void add(double x) {
    ++count_;
    const double d = x - mean_;
    mean_ += d / static_cast<double>(count_);
    m2_ += d * (x - mean_);
    min_ = std::min(min_, x);
    max_ = std::max(max_, x);
  }
  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] double mean() const { return mean_; }
  /// Sample standard deviation (n - 1); 0 below two values.
  [[nodiscard]] double sd() const { return count_ < 2 ? 0.0 : std::sqrt(m2_ / static_cast<double>(count_ - 1)); }
  [[nodiscard]] double min() const { return count_ == 0 ? 0.0 : min_; }
  [[nodiscard]] double max() const { return count_ == 0 ? 0.0 : max_; }

 private:
  std::uint64_t count_ = 0;
  double mean_ = 0, m2_ = 0;
  double min_ = std::numeric_limits<double>::infinity(), max_ = -std::numeric_limits<double>::infinity();
};

/// The paper's Table VII: upper limit of the 99 % confidence interval of the mean, mean + t(0.995, n-1) s / sqrt(n).
[[nodiscard]] double ucl99(const RunningStatistics& statistics);

}  // namespace vignole
