#include "engine/quality/outliers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "engine/quality/distributions.h"
#include "engine/quality/sample.h"

namespace vignole {

namespace {

Standout judged(double statistic, double critical5, double critical1) {
  return statistic > critical1 ? Standout::Outlier : statistic > critical5 ? Standout::Straggler : Standout::None;
}

struct DoubleGrubbsRow {
  double lower1, lower5;
};
/// ISO 5725-2:1994, Table 5, p = 4 ... 40 (no closed form is known).
constexpr std::size_t kFirstRow = 4;
constexpr std::array<DoubleGrubbsRow, 37> kDoubleGrubbs = {{
    {0.0000, 0.0002}, {0.0018, 0.0090}, {0.0116, 0.0349}, {0.0308, 0.0708}, {0.0563, 0.1101}, {0.0851, 0.1492},
    {0.1150, 0.1864}, {0.1448, 0.2213}, {0.1738, 0.2537}, {0.2016, 0.2836}, {0.2280, 0.3112}, {0.2530, 0.3367},
    {0.2767, 0.3603}, {0.2990, 0.3822}, {0.3200, 0.4025}, {0.3398, 0.4214}, {0.3585, 0.4391}, {0.3761, 0.4556},
    {0.3927, 0.4711}, {0.4085, 0.4857}, {0.4234, 0.4994}, {0.4376, 0.5123}, {0.4510, 0.5245}, {0.4638, 0.5360},
    {0.4759, 0.5470}, {0.4875, 0.5574}, {0.4985, 0.5672}, {0.5091, 0.5766}, {0.5192, 0.5856}, {0.5288, 0.5941},
    {0.5381, 0.6023}, {0.5469, 0.6101}, {0.5554, 0.6175}, {0.5636, 0.6247}, {0.5714, 0.6316}, {0.5789, 0.6382},
    {0.5862, 0.6445},
}};

double sumOfSquaresWithout(std::span<const double> values, std::size_t a, std::size_t b) {
  std::vector<double> rest;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (i != a && i != b) rest.push_back(values[i]);
  return describe(rest).sumOfSquares;
}

}  // namespace

std::string_view name(Standout standout) {
  constexpr std::array<std::string_view, 3> kNames = {"none", "straggler", "outlier"};
  return kNames.at(static_cast<std::size_t>(standout));
}

double grubbsCritical(std::size_t values, double alpha) {
  const auto p = static_cast<double>(values);
  const double t = studentQuantile(1 - alpha / (2 * p), p - 2);
  return (p - 1) * t / std::sqrt(p * (p - 2 + t * t));
}

std::optional<OutlierTest> grubbs(std::span<const double> values) {
  const Sample s = describe(values);
  if (s.n < 3 || !(s.sumOfSquares > 0)) return {};
  OutlierTest test;
  const auto furthest = std::max_element(
      values.begin(), values.end(), [&](double a, double b) { return std::abs(a - s.mean) < std::abs(b - s.mean); });
  test.where = {static_cast<std::size_t>(furthest - values.begin())};
  test.statistic = std::abs(*furthest - s.mean) / s.sd();
  test.critical5 = grubbsCritical(s.n, 0.05);
  test.critical1 = grubbsCritical(s.n, 0.01);
  test.standout = judged(test.statistic, test.critical5, test.critical1);
  return test;
}

std::optional<OutlierTest> doubleGrubbs(std::span<const double> values) {
  const Sample s = describe(values);
  if (s.n < kFirstRow || s.n >= kFirstRow + kDoubleGrubbs.size() || !(s.sumOfSquares > 0)) return {};
  std::vector<std::size_t> order(s.n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  const double low = sumOfSquaresWithout(values, order[0], order[1]) / s.sumOfSquares;
  const double high = sumOfSquaresWithout(values, order[s.n - 1], order[s.n - 2]) / s.sumOfSquares;
  OutlierTest test;
  test.statistic = std::min(low, high);
  test.where = low < high ? std::vector{order[0], order[1]} : std::vector{order[s.n - 2], order[s.n - 1]};
  const DoubleGrubbsRow& row = kDoubleGrubbs.at(s.n - kFirstRow);
  test.critical5 = row.lower5;
  test.critical1 = row.lower1;
  test.standout = test.statistic < row.lower1   ? Standout::Outlier
                  : test.statistic < row.lower5 ? Standout::Straggler
                                                : Standout::None;
  return test;
}

double cochranCritical(std::size_t variances, std::size_t n, double alpha) {
  const auto p = static_cast<double>(variances);
  const double nu = static_cast<double>(n) - 1;
  const double f = fisherQuantile(1 - alpha / p, nu, (p - 1) * nu);
  return f / (f + p - 1);
}

std::optional<OutlierTest> cochran(std::span<const double> variances, std::size_t n) {
  if (variances.size() < 2 || n < 2) return {};
  const double sum = std::accumulate(variances.begin(), variances.end(), 0.0);
  if (!(sum > 0)) return {};
  OutlierTest test;
  const auto largest = std::max_element(variances.begin(), variances.end());
  test.where = {static_cast<std::size_t>(largest - variances.begin())};
  test.statistic = *largest / sum;
  test.critical5 = cochranCritical(variances.size(), n, 0.05);
  test.critical1 = cochranCritical(variances.size(), n, 0.01);
  test.standout = judged(test.statistic, test.critical5, test.critical1);
  return test;
}

std::optional<Mandel> mandel(std::span<const double> means, std::span<const double> sds, std::size_t n) {
  if (means.size() < 3 || sds.size() != means.size() || n < 2) return {};
  const Sample s = describe(means);
  const auto p = static_cast<double>(means.size());
  const double nu = static_cast<double>(n) - 1;
  double squares = 0;
  for (const double sd : sds) squares += sd * sd;
  const double pooled = std::sqrt(squares / p);
  Mandel m;
  for (std::size_t i = 0; i < means.size(); ++i) {
    m.h.push_back(s.sumOfSquares > 0 ? (means[i] - s.mean) / s.sd() : 0.0);
    m.k.push_back(pooled > 0 ? sds[i] / pooled : 0.0);
  }
  const auto hIndicator = [&](double alpha) {
    const double t = studentQuantile(1 - alpha / 2, p - 2);
    return (p - 1) * t / std::sqrt(p * (t * t + p - 2));
  };
  const auto kIndicator = [&](double alpha) {
    const double f = fisherQuantile(1 - alpha, nu, (p - 1) * nu);
    return std::sqrt(p * f / (f + p - 1));
  };
  m.h5 = hIndicator(0.05);
  m.h1 = hIndicator(0.01);
  m.k5 = kIndicator(0.05);
  m.k1 = kIndicator(0.01);
  return m;
}

}  // namespace vignole
