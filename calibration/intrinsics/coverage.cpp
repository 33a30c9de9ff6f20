#include "calibration/intrinsics/coverage.h"

#include <algorithm>
#include <cmath>

namespace vignole {

double Coverage::share() const {
  if (cells.empty()) return 0;
  const auto seen = std::count_if(cells.begin(), cells.end(), [](const CoverageCell& c) { return c.points > 0; });
  return static_cast<double>(seen) / static_cast<double>(cells.size());
}

Coverage coverageOf(const std::vector<CoveragePoint>& points, int widthPx, int heightPx) {
  constexpr double kAlongLongerSide = 12;
  const double cellPx = std::max(widthPx, heightPx) / kAlongLongerSide;
  Coverage coverage;
  coverage.columns = std::max(1, static_cast<int>(std::lround(widthPx / cellPx)));
  coverage.rows = std::max(1, static_cast<int>(std::lround(heightPx / cellPx)));
  coverage.cells.resize(static_cast<std::size_t>(coverage.columns) * static_cast<std::size_t>(coverage.rows));
  for (const CoveragePoint& p : points) {
    const auto cellAlong = [](double at, int size, int count) {
      return std::clamp(static_cast<int>((at + 0.5) / size * count), 0, count - 1);
    };
    const int column = cellAlong(p.px.x(), widthPx, coverage.columns),
              row = cellAlong(p.px.y(), heightPx, coverage.rows);
    CoverageCell& cell = coverage.cells[static_cast<std::size_t>(row * coverage.columns + column)];
    cell.points += 1;
    cell.meanErrorPx += p.errorPx;
    cell.rmsPx += p.errorPx.squaredNorm();
  }
  for (CoverageCell& cell : coverage.cells)
    if (cell.points > 0) {
      cell.meanErrorPx /= cell.points;
      cell.rmsPx = std::sqrt(cell.rmsPx / cell.points);
    }
  return coverage;
}

}  // namespace vignole
