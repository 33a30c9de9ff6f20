#include "engine/quality/gauge_cells.h"

#include <algorithm>

namespace vignole {

namespace {

/// Index of a name, appended where it is new.
std::size_t indexOf(std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  names.push_back(name);
  return names.size() - 1;
}

template <typename T>
T& grown(std::vector<T>& values, std::size_t i) {
  if (values.size() <= i) values.resize(i + 1);
  return values[i];
}

std::string cellName(const GaugeCells& cells, std::size_t o, std::size_t p) {
  return "part " + cells.parts[o][p] + ", operator " + cells.operators[o];
}

Expected<void> checkBalance(const GaugeCells& cells) {
  for (std::size_t o = 0; o < cells.operators.size(); ++o) {
    if (cells.parts[o].size() != cells.partsPerOperator())
      return inputError("operator " + cells.operators[o],
                        "has " + std::to_string(cells.parts[o].size()) + " parts, operator " + cells.operators.front() +
                            " has " + std::to_string(cells.partsPerOperator()) + "; all need the same number");
    for (std::size_t p = 0; p < cells.parts[o].size(); ++p)
      if (cells.values[o][p].size() != cells.trials)
        return inputError(cellName(cells, o, p), "has " + std::to_string(cells.values[o][p].size()) + " trials, " +
                                                     cellName(cells, 0, 0) + " has " + std::to_string(cells.trials) +
                                                     "; every cell needs the same number");
  }
  if (cells.trials < 2)
    return inputError(cellName(cells, 0, 0),
                      "has one trial; repeatability needs two or more of every part and operator");
  if (cells.partsPerOperator() < 2) return inputError("", "a gauge study needs at least two parts");
  return {};
}

}  // namespace

Expected<GaugeCells> gaugeCells(const std::vector<GaugeReading>& readings, bool nested) {
  if (readings.empty()) return inputError("", "a gauge study needs readings; there are none");
  GaugeCells cells;
  cells.shift = readings.front().value;
  std::vector<std::string> common;  // crossed: one list of parts
  for (const GaugeReading& r : readings) {
    const std::size_t o = indexOf(cells.operators, r.operatorName);
    std::vector<std::string>& names = nested ? grown(cells.parts, o) : common;
    grown(grown(cells.values, o), indexOf(names, r.part)).push_back(r.value - cells.shift);
  }
  if (!nested) {
    cells.parts.assign(cells.operators.size(), common);
    for (auto& row : cells.values) row.resize(common.size());
  }
  cells.trials = cells.values.front().front().size();
  if (auto balanced = checkBalance(cells); !balanced) return tl::unexpected(balanced.error());
  if (nested && cells.operators.size() < 2) return inputError("", "a nested study needs at least two operators");
  return cells;
}

}  // namespace vignole
