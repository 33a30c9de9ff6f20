#pragma once
// Plots of the studies as SVG or PNG: panels one below the other, axes with round numbers, no Qt.

#include <filesystem>
#include <string>
#include <vector>

#include "engine/geometry/expected.h"
#include "engine/geometry/transform2.h"

namespace vignole::cli {

enum class ChartColour { Value, Second, Third, Limit, Centre, Out };

struct ChartSeries {
  std::string name;  ///< in the key; empty: not in it
  std::vector<Point2> points;
  ChartColour colour = ChartColour::Value;
  enum class Look { Line, Dots, LineAndDots, Bars } look = Look::Line;
};
/// A horizontal line across the panel.
struct ChartLevel {
  double value = 0;
  std::string name;
  ChartColour colour = ChartColour::Limit;
};
struct Chart {
  std::string title, xLabel, yLabel;
  std::vector<ChartSeries> series;
  std::vector<ChartLevel> levels;
  std::vector<std::string> categories;  ///< names at x = 0, 1, 2 ... in place of numbers
};

[[nodiscard]] Expected<void> checkPlotFile(const std::filesystem::path& file);  ///< .svg or .png
[[nodiscard]] Expected<void> writePlot(const std::vector<Chart>& charts, const std::filesystem::path& file);

}  // namespace vignole::cli
