#include "engine/simulator/lens_blur.h"

#include <algorithm>
#include <cmath>

namespace vignole::simulator {

namespace {

constexpr float kMostPerPass = 0.5F;  // px^2; a kernel of 3 pixels stays without negative weights up to 1

}  // namespace

void blur(Canvas& canvas, const std::vector<float>& variancePx2) {
  const int width = canvas.width(), height = static_cast<int>(variancePx2.size()) / canvas.width();
  const float most = *std::max_element(variancePx2.begin(), variancePx2.end());
  const int passes = static_cast<int>(std::ceil(most / kMostPerPass));
  const auto columns = static_cast<std::size_t>(width);
  std::vector<float> padded(columns + 2), above(columns), here(columns);
  for (int pass = 0; pass < passes; ++pass) {
    const float share = 0.5F / static_cast<float>(passes);
    for (int y = 0; y < height; ++y) {
      float* row = canvas.row(y);
      const float* variance = variancePx2.data() + static_cast<std::size_t>(y) * columns;
      std::copy(row, row + width, padded.begin() + 1);
      padded.front() = row[0];
      padded.back() = row[width - 1];
      const float* p = padded.data();
      for (std::size_t x = 0; x < columns; ++x)
        row[x] = p[x + 1] + share * variance[x] * (p[x] + p[x + 2] - 2 * p[x + 1]);
    }
    std::copy(canvas.row(0), canvas.row(0) + width, above.begin());
    for (int y = 0; y < height; ++y) {
      float* row = canvas.row(y);
      const float* below = canvas.row(std::min(y + 1, height - 1));
      const float* variance = variancePx2.data() + static_cast<std::size_t>(y) * columns;
      std::copy(row, row + width, here.begin());
      for (std::size_t x = 0; x < columns; ++x)
        row[x] = here[x] + share * variance[x] * (above[x] + below[x] - 2 * here[x]);
      std::swap(above, here);
    }
  }
}

}  // namespace vignole::simulator
