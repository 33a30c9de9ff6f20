#pragma once
// A sample in a few numbers, by stable formulas: sums of deviations from the first value, then corrected two-pass
// (Chan, Golub, LeVeque 1983). The certified NIST StRD sets come out as far as double precision holds their values.

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vignole {

struct Sample {
  std::size_t n = 0;
  double mean = 0;
  double sumOfSquares = 0;  ///< of the deviations from the mean
  double min = 0, max = 0;

  [[nodiscard]] double degrees() const { return n < 2 ? 0.0 : static_cast<double>(n - 1); }
  [[nodiscard]] double variance() const { return n < 2 ? 0.0 : sumOfSquares / degrees(); }
  [[nodiscard]] double sd() const;
  [[nodiscard]] double range() const { return max - min; }
};

/// All zero for an empty span. Values must be finite.
[[nodiscard]] Sample describe(std::span<const double> values);
[[nodiscard]] double meanOf(std::span<const double> values);
/// Correlation of neighbours in the order given (NIST StRD); 0 where nothing varies.
[[nodiscard]] double autocorrelation(std::span<const double> values);

/// An interval at some confidence, or limits.
struct ValueRange {
  double low = 0, high = 0;
};
/// Of the mean of normal values, Student's t; needs n >= 2.
[[nodiscard]] ValueRange meanInterval(const Sample& sample, double alpha);
/// Of a standard deviation with `degrees` of freedom, chi squared.
[[nodiscard]] ValueRange sdInterval(double sd, double degrees, double alpha);

/// What stands beside every result: how it was computed and with which constants.
struct StudyNotes {
  std::vector<std::string> formulas;
  std::vector<std::pair<std::string, double>> constants;
};

}  // namespace vignole
