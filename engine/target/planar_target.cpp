#include "engine/target/planar_target.h"

#include <array>
#include <charconv>
#include <vector>

namespace vignole {

namespace {

struct PatternName {
  TargetPattern pattern;
  std::string_view name;
};
constexpr std::array<PatternName, 4> kPatterns = {
    PatternName{TargetPattern::Chessboard, "chessboard"}, PatternName{TargetPattern::Circles, "circles"},
    PatternName{TargetPattern::AsymmetricCircles, "acircles"}, PatternName{TargetPattern::DotPlate, "dotplate"}};

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(separator, from), text.size());
    parts.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return parts;
}

template <typename T>
bool parse(std::string_view text, T& value) {
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  return problem == std::errc{} && end == text.data() + text.size();
}

}  // namespace

std::vector<Point2> PlanarTarget::points() const {
  std::vector<Point2> all;
  all.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      all.emplace_back(pitchMm * (pattern == TargetPattern::AsymmetricCircles ? 2 * column + row % 2 : column),
                       pitchMm * row);
  return all;
}

namespace {

/// About the points, so much wider on each side.
TargetRectangle around(const PlanarTarget& target, double marginMm) {
  const bool shifted = target.pattern == TargetPattern::AsymmetricCircles;
  const double width = target.pitchMm * (shifted ? 2 * target.columns - 1 : target.columns - 1);
  return {Point2(-marginMm, -marginMm), Point2(width + marginMm, target.pitchMm * (target.rows - 1) + marginMm)};
}

}  // namespace

TargetRectangle board(const PlanarTarget& target) {
  switch (target.pattern) {
    case TargetPattern::Chessboard:
      return around(target, 2 * target.pitchMm);
    case TargetPattern::DotPlate:
      return around(target, 1.125 * target.pitchMm);
    default:
      return around(target, target.pitchMm);
  }
}

DotPlateFrame frame(const PlanarTarget& target) {
  return {around(target, target.pitchMm), target.pitchMm / 4, target.pitchMm};
}

Expected<PlanarTarget> parseTarget(std::string_view words) {
  const auto refuse = [&](const std::string& what) {
    return inputError("target " + std::string(words),
                      what +
                          "; write chessboard:COLSxROWS:MM, circles:COLSxROWS:PITCH[:DIAMETER], acircles:... or "
                          "dotplate:...");
  };
  const auto parts = split(words, ':');
  PlanarTarget target;
  const PatternName* found = nullptr;
  for (const PatternName& p : kPatterns)
    if (parts.front() == p.name) found = &p;
  if (found == nullptr) return refuse("is no known pattern");
  target.pattern = found->pattern;
  const bool circles = target.pattern != TargetPattern::Chessboard;
  if (parts.size() < 3 || parts.size() > (circles ? 4U : 3U)) return refuse("has not the parts that it should");
  const auto size = split(parts[1], 'x');
  if (size.size() != 2 || !parse(size[0], target.columns) || !parse(size[1], target.rows))
    return refuse("has no size such as 7x5");
  if (target.columns < 2 || target.rows < 2 || target.columns > 200 || target.rows > 200)
    return refuse("must have between 2 and 200 columns and rows");
  if (!parse(parts[2], target.pitchMm) || !(target.pitchMm > 0 && target.pitchMm < 1e4))
    return refuse("has no distance in mm between 0 and 10,000");
  if (circles) target.diameterMm = target.pitchMm / 2;
  const double room = target.pitchMm * (target.pattern == TargetPattern::AsymmetricCircles ? 1.41421356 : 1);
  if (parts.size() == 4 &&
      (!parse(parts[3], target.diameterMm) || !(target.diameterMm > 0 && target.diameterMm < room)))
    return refuse("has no diameter in mm that leaves room between the circles");
  return target;
}

std::string words(const PlanarTarget& target) {
  const auto text = [](double value) {
    std::array<char, 40> buffer{};
    return std::string(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr);
  };
  std::string all;
  for (const PatternName& p : kPatterns)
    if (p.pattern == target.pattern) all = p.name;
  all += ":" + std::to_string(target.columns) + "x" + std::to_string(target.rows) + ":" + text(target.pitchMm);
  if (target.pattern != TargetPattern::Chessboard) all += ":" + text(target.diameterMm);
  return all;
}

}  // namespace vignole
