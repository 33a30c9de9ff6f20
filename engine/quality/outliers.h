#pragma once
// Outlier tests and consistency statistics of ISO 5725-2: beyond the 5 % critical value a straggler, beyond the 1 % an
// outlier. They find; nothing is ever removed by them.

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace vignole {

enum class Standout { None, Straggler, Outlier };
[[nodiscard]] std::string_view name(Standout standout);  ///< "none", "straggler", "outlier"

struct OutlierTest {
  double statistic = 0;
  double critical5 = 0, critical1 = 0;
  std::vector<std::size_t> where;  ///< of the suspects in the span that was given
  Standout standout = Standout::None;
};

/// Grubbs for the value furthest from the mean, max |x - mean| / s, two-sided critical values as in ISO 5725-2. Empty
/// below three values or where nothing varies.
[[nodiscard]] std::optional<OutlierTest> grubbs(std::span<const double> values);
/// Grubbs for the two largest or the two smallest: the remaining sum of squares over the whole; small is suspicious.
/// Table 5 of ISO 5725-2, 4 to 40 values; empty elsewhere or where nothing varies.
[[nodiscard]] std::optional<OutlierTest> doubleGrubbs(std::span<const double> values);
/// Cochran: the largest variance over the sum of all, each of `n` values. Empty below two variances, n < 2, or where
/// all are 0.
[[nodiscard]] std::optional<OutlierTest> cochran(std::span<const double> variances, std::size_t n);

[[nodiscard]] double grubbsCritical(std::size_t values, double alpha);
[[nodiscard]] double cochranCritical(std::size_t variances, std::size_t n, double alpha);

/// Mandel's h: deviation of each mean from their mean over their standard deviation; k: each s over the pooled s.
struct Mandel {
  std::vector<double> h, k;
  double h5 = 0, h1 = 0, k5 = 0, k1 = 0;  ///< indicators at 5 % and 1 %
};
/// `n` values in each group; at least three groups. k is left 0 where every s is 0, h where every mean is the same.
[[nodiscard]] std::optional<Mandel> mandel(std::span<const double> means, std::span<const double> sds, std::size_t n);

}  // namespace vignole
