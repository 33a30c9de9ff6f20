#include "engine/stripe/stripe_extractor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>

#include "engine/stripe/block_scan.h"
#include "engine/stripe/competing_lines.h"
#include "engine/stripe/gap_linking.h"
#include "engine/stripe/line_ends.h"
#include "engine/stripe/line_linking.h"
#include "engine/stripe/ridge_points.h"
#include "engine/stripe/uncertainty.h"

namespace vignole {
namespace {

constexpr int kClippedDn = 254;

bool clippedAt(const ImageView& image, int column, int row) {
  const int left = std::max(0, column - 1), right = std::min(image.width - 1, column + 1);
  const int above = std::max(0, row - 1), below = std::min(image.height - 1, row + 1);
  const std::uint8_t* middle = image.row(row);
  return std::max({middle[left], middle[column], middle[right], image.row(above)[column], image.row(below)[column]}) >=
         kClippedDn;
}

}  // namespace

Expected<StripeSettings> checked(const StripeSettings& settings) {
  const auto refuse = [](const char* field, const char* range, double value) {
    return inputError(std::string("stripe.") + field, "is " + std::to_string(value) + ", must be " + range);
  };
  // Written so that NaN is refused.
  if (!(settings.sigma >= 1 && settings.sigma <= 8)) return refuse("sigma", "1 .. 8 px", settings.sigma);
  if (!(settings.low > 0 && settings.low <= 255)) return refuse("low", "above 0 and at most 255 DN", settings.low);
  if (!(settings.high >= settings.low && settings.high <= 255))
    return refuse("high", "at least low and at most 255 DN", settings.high);
  if (!(settings.gapDistance >= 0 && settings.gapDistance <= 10000))
    return refuse("gapDistance", "0 .. 10000 px", settings.gapDistance);
  if (!(settings.gapAngle >= 0 && settings.gapAngle <= 90))
    return refuse("gapAngle", "0 .. 90 degrees", settings.gapAngle);
  if (settings.minLength < 3 || settings.minLength > 100000)
    return refuse("minLength", "3 .. 100000 points", settings.minLength);
  if (settings.maxBlocks < 1 || settings.maxBlocks > 65000)
    return refuse("maxBlocks", "1 .. 65000 blocks", settings.maxBlocks);
  return settings;
}

const char* stripeSimdTarget() { return simdTargetName(); }

struct StripeExtractor::Impl {
  explicit Impl(const StripeSettings& s);
  void extract(const ImageView& image, StripeResult& result);
  void setThresholds();
  void buildLine(const ImageView& image, const LineChain& chain);
  void addPoint(const ImageView& image, const RidgePoint& ridge);
  void orientNormals(std::size_t first);
  void flagEnds(std::size_t first);
  void turnRound(std::size_t first);
  void rankLines();
  void estimateUncertainty();
  void write(StripeResult& result) const;

  StripeSettings settings;
  RidgeFilter filter;
  BlockScanSettings scanSettings;
  LinkingSettings linking;
  GapSettings gaps;
  BlockScan scan;
  RidgePoints ridges;
  LineLinker linker;
  LineEnds lineEnds;
  GapLinker gapLinker;
  SpeckleMeter speckleMeter;
  std::vector<ChainPoint> points;
  std::vector<LineOfChain> lines;
  std::vector<std::size_t> gapStarts;  // of the line at work: first point behind each bridged gap
};

StripeExtractor::Impl::Impl(const StripeSettings& s) : settings(s), filter(ridgeFilter(s.sigma, 0)) {
  // Light reaches 3 sd of the stripe to both sides; the background is looked for beyond that.
  scanSettings.radius = std::clamp(static_cast<int>(std::ceil((4.5 * s.sigma + 4) / kBlock)), 2, 5);
  // A line of contrast t_l that runs along the border of two blocks raises the mean of each by at least 0.4 t_l.
  scanSettings.leastContrast = 0.4 * s.low;
  scanSettings.maxBlocks = s.maxBlocks;
  linking.minLength = s.minLength;
  gaps = {s.gapDistance, s.gapAngle, s.sigma};
}

// t_l and t_h as second derivatives; never so low that noise alone would make lines.
void StripeExtractor::Impl::setThresholds() {
  const double perDn = ridgePerContrast(settings.sigma, settings.sigma);
  const double noise = scan.noiseDn() * ridgeNoise(settings.sigma);
  filter.leastRidge = static_cast<float>(std::max(settings.low * perDn, kLowNoiseFactor * noise));
  linking.highRidge = static_cast<float>(std::max(settings.high * perDn, kHighNoiseFactor * noise));
}

void StripeExtractor::Impl::addPoint(const ImageView& image, const RidgePoint& r) {
  const auto variance = static_cast<float>(filter.variancePx2);
  const float light = std::max(1.0F, r.smoothed - scan.backgroundAt(r.column, r.row));
  const float dx = r.x - static_cast<float>(r.column), dy = r.y - static_cast<float>(r.row);
  const float t = dx * r.nx + dy * r.ny, p = r.nx * r.nx * r.ny * r.ny;
  // The smoothed line is L exp(-x^2 / 2 v), so v = L / ridge; seen at offset t and by differences instead of
  // derivatives that is too large by t^2 + (1 + p) / 4.
  const float v = std::max(light / r.ridge - t * t - 0.25F * (1 + p), variance + 0.25F);
  // The offset -f'/f'' overshoots by t^2 / v (third order of the profile) and falls short by (1 - 5 p) / (4 v)
  // (differences).
  const float correction = t * (0.25F * (1 - 5 * p) - t * t) / v;
  ChainPoint c;
  c.point.x = r.x + correction * r.nx;
  c.point.y = r.y + correction * r.ny;
  c.point.nx = r.nx;
  c.point.ny = r.ny;
  c.s2 = v - variance;
  c.point.widthPx = std::sqrt(c.s2);
  c.point.strength = light * std::sqrt(v / c.s2);
  if (clippedAt(image, r.column, r.row)) c.point.flags = kSaturated;
  c.ridge = r.ridge;
  points.push_back(c);
}

void StripeExtractor::Impl::buildLine(const ImageView& image, const LineChain& chain) {
  const std::size_t first = points.size();
  gapStarts.clear();
  for (std::uint32_t l = chain.first; l < chain.first + chain.count; ++l) {
    const ChainLink link = gapLinker.links()[l];
    const LinePiece piece = lineEnds.pieces()[link.piece];
    const std::size_t begin = points.size();
    for (std::uint32_t i = 0; i < piece.count; ++i) {
      const std::uint32_t at = piece.first + (link.reversed ? piece.count - 1 - i : i);
      addPoint(image, lineEnds.points()[at]);
    }
    if (l > chain.first) gapStarts.push_back(begin);
  }
  const StripePoint &a = points[first].point, &b = points.back().point;
  if (b.x < a.x || (b.x == a.x && b.y < a.y)) turnRound(first);
  float arc = 0;
  for (std::size_t i = first; i < points.size(); ++i) {
    if (i > first)
      arc += std::hypot(points[i].point.x - points[i - 1].point.x, points[i].point.y - points[i - 1].point.y);
    points[i].arcPx = arc;
  }
  orientNormals(first);
  flagEnds(first);
  lines.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(points.size() - first), false});
}

// All to the same side of the line: a quarter turn from x towards y when looking along it.
void StripeExtractor::Impl::orientNormals(std::size_t first) {
  for (std::size_t i = first; i < points.size(); ++i) {
    const StripePoint& a = points[i > first ? i - 1 : i].point;
    const StripePoint& b = points[std::min(i + 1, points.size() - 1)].point;
    StripePoint& p = points[i].point;
    if ((b.x - a.x) * p.ny - (b.y - a.y) * p.nx >= 0) continue;
    p.nx = -p.nx;
    p.ny = -p.ny;
  }
}

void StripeExtractor::Impl::turnRound(std::size_t first) {
  std::reverse(points.begin() + static_cast<std::ptrdiff_t>(first), points.end());
  for (std::size_t& start : gapStarts) start = first + points.size() - start;
  std::reverse(gapStarts.begin(), gapStarts.end());
}

void StripeExtractor::Impl::flagEnds(std::size_t first) {
  const auto reach = static_cast<float>(3 * settings.sigma);
  const float length = points.back().arcPx;
  for (std::size_t i = first; i < points.size(); ++i) {
    ChainPoint& c = points[i];
    c.edgePx = std::min(c.arcPx, length - c.arcPx);
    if (c.edgePx <= reach) c.point.flags |= kLineEnd;
  }
  const auto mark = [&](ChainPoint& c, float arcOfEdge) {
    const float distance = std::abs(c.arcPx - arcOfEdge);
    c.edgePx = std::min(c.edgePx, distance);
    if (distance <= reach) c.point.flags |= kGapEdge;
    return distance <= reach;
  };
  for (const std::size_t start : gapStarts) {
    for (std::size_t i = start; i-- > first && mark(points[i], points[start - 1].arcPx);) continue;
    for (std::size_t i = start; i < points.size() && mark(points[i], points[start].arcPx);) ++i;
  }
}

void StripeExtractor::Impl::rankLines() {
  rejectGhosts(points, lines, CompetitionSettings{});
  for (LineOfChain& line : lines)
    for (std::uint32_t i = line.first; line.rejected && i < line.first + line.count; ++i)
      points[i].point.flags |= kRejected;
  std::sort(lines.begin(), lines.end(), [](const LineOfChain& a, const LineOfChain& b) {
    if (a.rejected != b.rejected) return b.rejected;
    return a.count != b.count ? a.count > b.count : a.first < b.first;
  });
}

void StripeExtractor::Impl::estimateUncertainty() {
  speckleMeter.begin(filter, scan.noiseDn());
  const auto pointsOf = [this](const LineOfChain& line) { return std::span(points).subspan(line.first, line.count); };
  for (const LineOfChain& line : lines)
    if (!line.rejected) speckleMeter.add(pointsOf(line));
  const float speckle = speckleMeter.speckle();
  for (const LineOfChain& line : lines) setUncertainty(pointsOf(line), filter, scan.noiseDn(), speckle);
}

void StripeExtractor::Impl::write(StripeResult& result) const {
  result.points.clear();
  result.lines.clear();
  std::size_t kept = 0, saturated = 0, steps = 0;
  float length = 0;
  for (const LineOfChain& line : lines) {
    result.lines.push_back({static_cast<std::uint32_t>(result.points.size()), line.count, line.rejected});
    for (const ChainPoint& c : std::span(points).subspan(line.first, line.count)) {
      result.points.push_back(c.point);
      if (!line.rejected && (c.point.flags & kSaturated) != 0) ++saturated;
    }
    if (line.rejected) continue;
    kept += line.count;
    steps += line.count - 1;
    length += points[line.first + line.count - 1].arcPx;
  }
  result.noiseDn = scan.noiseDn();
  result.backgroundDn = scan.backgroundDn();
  result.saturatedShare = kept == 0 ? 0 : static_cast<float>(saturated) / static_cast<float>(kept);
  // White noise smoothed by sigma along the line: the sum of its correlation exp(-d^2 / 4 sigma^2) over the points.
  const double spacing = steps == 0 ? 1 : std::max(0.5, static_cast<double>(length) / static_cast<double>(steps));
  result.correlatedPoints =
      static_cast<float>(std::max(1.0, 2 * std::sqrt(std::numbers::pi) * settings.sigma / spacing));
  result.smoothingPx = static_cast<float>(settings.sigma);
  result.overloaded = scan.overloaded();
}

void StripeExtractor::Impl::extract(const ImageView& image, StripeResult& result) {
  points.clear();
  lines.clear();
  if (image.empty()) {
    result = {};
    return;
  }
  scan.scan(image, scanSettings);
  setThresholds();
  ridges.find(image, scan, filter);
  linker.link(ridges, linking);
  lineEnds.retrace(image, filter, linker);
  gapLinker.link(lineEnds.points(), lineEnds.pieces(), gaps);
  for (const LineChain& chain : gapLinker.chains()) buildLine(image, chain);
  rankLines();
  estimateUncertainty();
  write(result);
}

StripeExtractor::StripeExtractor(const StripeSettings& settings) : impl_(std::make_unique<Impl>(settings)) {}
StripeExtractor::~StripeExtractor() = default;
StripeExtractor::StripeExtractor(StripeExtractor&&) noexcept = default;
StripeExtractor& StripeExtractor::operator=(StripeExtractor&&) noexcept = default;

void StripeExtractor::extract(const ImageView& image, StripeResult& result) { impl_->extract(image, result); }

}  // namespace vignole
