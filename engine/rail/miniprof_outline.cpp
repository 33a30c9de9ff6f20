#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

#include "engine/files/atomic_file.h"
#include "engine/rail/outline.h"

namespace vignole {

namespace {

/// "A cx cy r a0 a1" (degrees, counter-clockwise) or "L x0 y0 x1 y1"; nothing if it is neither.
std::optional<Primitive> readPrimitive(const std::string& text) {
  std::istringstream words(text);
  std::string kind;
  words >> kind;
  std::array<double, 5> v{};
  const std::size_t count = kind == "A" ? 5 : kind == "L" ? 4 : 0;
  for (std::size_t i = 0; i < count; ++i)
    if (!(words >> v.at(i)) || !std::isfinite(v.at(i))) return std::nullopt;
  std::string rest;
  if (count == 0 || words >> rest) return std::nullopt;
  if (kind == "L") return Segment{{v[0], v[1]}, {v[2], v[3]}};
  const double degree = std::numbers::pi / 180;
  const double sweep = (v[4] - v[3]) * degree;
  if (!(v[2] > 0) || std::abs(sweep) >= 2 * std::numbers::pi) return std::nullopt;
  return Arc{{v[0], v[1]}, v[2], v[3] * degree, sweep};
}

bool isNumbered(const std::string& key) {
  return key.size() > 3 && key.starts_with("MPD") && key.find_first_not_of("0123456789", 3) == std::string::npos;
}

}  // namespace

Expected<std::vector<Piece>> readMiniprofDesign(const std::filesystem::path& file) {
  const auto text = readFile(file);
  if (!text) return tl::unexpected(text.error());
  std::vector<Piece> pieces;
  std::istringstream lines(*text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty()) break;  // the header ends; what follows are points
    const std::size_t equals = line.find('=');
    const std::string key = line.substr(0, equals);
    if (equals == std::string::npos || !isNumbered(key)) continue;
    const auto shape = readPrimitive(line.substr(equals + 1));
    if (!shape)
      return inputError(file.string() + ":" + std::to_string(number) + ": " + key,
                        "is neither \"A cx cy r a0 a1\" nor \"L x0 y0 x1 y1\" with numbers");
    pieces.push_back({*shape, key});
  }
  if (pieces.empty())
    return inputError(file.string(), "holds no MPDn lines: it is a record of points, not a MiniProf design");
  return pieces;
}

}  // namespace vignole
