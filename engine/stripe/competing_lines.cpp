#include "engine/stripe/competing_lines.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vignole {
namespace {

constexpr std::uint32_t kSamples = 16;    // of a line that may be a ghost
constexpr std::uint32_t kBoxPoints = 32;  // a box of the other encloses
constexpr std::size_t kMostLines = 64;    // more are texture: no one can tell ghosts there

/// The k-th of kSamples places spread over a line.
std::size_t sampleOf(const LineRange& range, std::uint32_t k) {
  const std::uint32_t samples = std::min(kSamples, range.count);
  return range.first + (2 * k + 1) * range.count / (2 * samples);
}

bool inside(std::span<const PixelPosition> convex, float x, float y) {
  bool left = true, right = true;
  for (std::size_t k = 0; k < convex.size(); ++k) {
    const PixelPosition &a = convex[k], &b = convex[(k + 1) % convex.size()];
    const float side = (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
    left = left && side >= 0;
    right = right && side <= 0;
  }
  return left || right;
}

/// Median over a few places, px^2.
float widthOf(const LinePoints& points, const LineRange& range) {
  std::array<float, kSamples> widths{};
  const std::uint32_t samples = std::min(kSamples, range.count);
  for (std::uint32_t k = 0; k < samples; ++k) widths.at(k) = points.s2[sampleOf(range, k)];
  const auto middle = widths.begin() + samples / 2;
  std::nth_element(widths.begin(), middle, widths.begin() + samples);
  return *middle;
}

bool mostlyOutside(const LinePoints& points, const LineRange& range, std::span<const PixelPosition> field) {
  if (field.size() < 3) return false;
  const std::uint32_t samples = std::min(kSamples, range.count);
  std::uint32_t outside = 0;
  for (std::uint32_t k = 0; k < samples; ++k) {
    const std::size_t i = sampleOf(range, k);
    if (!inside(field, points.x[i], points.y[i])) ++outside;
  }
  return 2 * outside > samples;
}

}  // namespace

float Competition::Box::distance2(float x, float y) const {
  const float dx = std::max({left - x, 0.0F, x - right}), dy = std::max({top - y, 0.0F, y - bottom});
  return dx * dx + dy * dy;
}

void Competition::Box::include(const Box& other) {
  left = std::min(left, other.left);
  right = std::max(right, other.right);
  top = std::min(top, other.top);
  bottom = std::max(bottom, other.bottom);
}

void Competition::enclose(const LinePoints& points, const LineRange& range) {
  BoxesOfLine line{static_cast<std::uint32_t>(boxes_.size()), 0, {}};
  for (std::uint32_t first = range.first; first < range.end(); first += kBoxPoints) {
    Box box{points.x[first], points.y[first], points.x[first], points.y[first]};
    for (std::uint32_t i = first + 1; i < std::min(first + kBoxPoints, range.end()); ++i)
      box.include({points.x[i], points.y[i], points.x[i], points.y[i]});
    if (line.count++ == 0)
      line.all = box;
    else
      line.all.include(box);
    boxes_.push_back(box);
  }
  ofLine_.push_back(line);
}

std::size_t Competition::nearest(const LinePoints& points, const LineRange& range, const BoxesOfLine& boxes, float x,
                                 float y, float limitPx) const {
  float least = limitPx * limitPx;
  std::size_t best = range.end();
  for (std::uint32_t b = 0; b < boxes.count; ++b) {
    if (boxes_[boxes.first + b].distance2(x, y) > least) continue;
    const std::uint32_t first = range.first + b * kBoxPoints;
    for (std::uint32_t i = first; i < std::min(first + kBoxPoints, range.end()); ++i) {
      const float dx = points.x[i] - x, dy = points.y[i] - y, d2 = dx * dx + dy * dy;
      if (d2 > least) continue;
      least = d2;
      best = i;
    }
  }
  return best;
}

Rejection Competition::against(const LinePoints& points, const LineRange& doubtful, const LineRange& line,
                               const BoxesOfLine& boxes, const CompetitionSettings& settings) const {
  const std::uint32_t samples = std::min(kSamples, doubtful.count);
  std::uint32_t weak = 0, broad = 0;
  for (std::uint32_t k = 0; k < samples; ++k) {
    const std::size_t p = sampleOf(doubtful, k);
    const float x = points.x[p], y = points.y[p], nx = points.nx[p], ny = points.ny[p];
    if (boxes.all.distance2(x, y) > settings.distancePx * settings.distancePx) continue;
    const std::size_t q = nearest(points, line, boxes, x, y, settings.distancePx);
    if (q == line.end()) continue;
    const float dx = points.x[q] - x, dy = points.y[q] - y, along = dy * nx - dx * ny;
    const bool beside = along * along <= 0.25F * (dx * dx + dy * dy);
    const bool parallel = std::abs(nx * points.nx[q] + ny * points.ny[q]) >= settings.parallelCosine;
    if (!beside || !parallel) continue;
    const float share = points.strength[p] / points.strength[q];
    if (share < settings.weakShare) ++weak;
    const float broadness2 = settings.broadness * settings.broadness;
    if (share < settings.broadShare && points.s2[p] > broadness2 * points.s2[q]) ++broad;
  }
  const float needed = settings.leastShare * static_cast<float>(samples);
  if (static_cast<float>(weak) >= needed) return Rejection::Weaker;
  const bool shorter = static_cast<float>(doubtful.count) <= settings.continuity * static_cast<float>(line.count);
  return shorter && static_cast<float>(broad) >= needed ? Rejection::Broader : Rejection::None;
}

void Competition::rejectSpots(const LinePoints& points, std::span<Competitor> lines,
                              const CompetitionSettings& settings) {
  const auto longest = std::max_element(lines.begin(), lines.end(), [](const Competitor& a, const Competitor& b) {
    return a.range.count < b.range.count;
  });
  const float usual = widthOf(points, longest->range), broad = settings.spotBroadness * settings.spotBroadness * usual;
  for (Competitor& line : lines) {
    const bool shorter =
        static_cast<float>(line.range.count) <= settings.spotLength * static_cast<float>(longest->range.count);
    if (shorter && line.rejection == Rejection::None && widthOf(points, line.range) > broad)
      line.rejection = Rejection::Spot;
  }
}

void Competition::judge(const LinePoints& points, std::span<Competitor> lines, std::span<const PixelPosition> field,
                        const CompetitionSettings& settings) {
  for (Competitor& line : lines)
    if (mostlyOutside(points, line.range, field)) line.rejection = Rejection::OutOfField;
  if (lines.size() < 2 || lines.size() > kMostLines) return;
  rejectSpots(points, lines, settings);
  boxes_.clear();
  ofLine_.clear();
  for (const Competitor& line : lines) enclose(points, line.range);
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t k = 0; k < lines.size() && lines[i].rejection == Rejection::None; ++k)
      if (k != i && lines[k].rejection != Rejection::OutOfField)
        lines[i].rejection = against(points, lines[i].range, lines[k].range, ofLine_[k], settings);
}

}  // namespace vignole
