#include "engine/quality/running_statistics.h"

namespace vignole {

double ucl99(const RunningStatistics& statistics) {
  const std::uint64_t n = statistics.count();
  if (n < 2) return statistics.mean();
  const auto count = static_cast<double>(n);
  return statistics.mean() + studentQuantile(0.995, count - 1) * statistics.sd() / std::sqrt(count);
}

}  // namespace vignole
