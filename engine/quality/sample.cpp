#include "engine/quality/sample.h"

#include <algorithm>
#include <cmath>

#include "engine/quality/distributions.h"

namespace vignole {

double Sample::sd() const { return std::sqrt(variance()); }

double meanOf(std::span<const double> values) {
  if (values.empty()) return 0;
  const auto n = static_cast<double>(values.size());
  const double first = values.front();
  double shift = 0;
  for (const double v : values) shift += v - first;
  const double mean = first + shift / n;
  double rest = 0;  // what rounding took from the first sum
  for (const double v : values) rest += v - mean;
  return mean + rest / n;
}

Sample describe(std::span<const double> values) {
  Sample s;
  if (values.empty()) return s;
  s.n = values.size();
  s.mean = meanOf(values);
  const auto [min, max] = std::minmax_element(values.begin(), values.end());
  s.min = *min;
  s.max = *max;
  double sum = 0, squares = 0;
  for (const double v : values) {
    const double d = v - s.mean;
    sum += d;
    squares += d * d;
  }
  s.sumOfSquares = std::max(0.0, squares - sum * sum / static_cast<double>(s.n));
  return s;
}

double autocorrelation(std::span<const double> values) {
  const Sample s = describe(values);
  if (!(s.sumOfSquares > 0)) return 0;
  double products = 0;
  for (std::size_t i = 1; i < values.size(); ++i) products += (values[i] - s.mean) * (values[i - 1] - s.mean);
  return products / s.sumOfSquares;
}

ValueRange meanInterval(const Sample& sample, double alpha) {
  const double half =
      studentQuantile(1 - alpha / 2, sample.degrees()) * sample.sd() / std::sqrt(static_cast<double>(sample.n));
  return {sample.mean - half, sample.mean + half};
}

ValueRange sdInterval(double sd, double degrees, double alpha) {
  return {sd * std::sqrt(degrees / chiSquareQuantile(1 - alpha / 2, degrees)),
          sd * std::sqrt(degrees / chiSquareQuantile(alpha / 2, degrees))};
}

}  // namespace vignole
