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
#include "engine/stripe/line_kernels.h"
#include "engine/stripe/line_linking.h"
#include "engine/stripe/ridge_points.h"
#include "engine/stripe/uncertainty.h"

namespace vignole {
namespace {

constexpr int kClippedDn = 254;
constexpr float kNarrowestLinePx = 0.6F;     // a pixel and a lens alone make a line that broad
constexpr float kEndTouchesSigma = 2;        // so far an end's own error reaches into the smoothing, in sigma
constexpr float kPointSpacingPx = 1.13F;     // averaged over all directions of a line
constexpr float kCrosstalkShare = 0.1F;      // of the contrast of the better half of its line
constexpr std::uint32_t kCrosstalkRun = 12;  // points in a row

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

const char* reasonOf(Rejection rejection) {
  switch (rejection) {
    case Rejection::Weaker:
      return "a ghost: much weaker than the line beside it";
    case Rejection::Broader:
      return "a ghost: weaker, broader and shorter than the line beside it";
    case Rejection::Spot:
      return "a spot of light: many times as broad as the line";
    case Rejection::OutOfField:
      return "where the light plane cannot be seen";
    case Rejection::None:
      break;
  }
  return "";
}

struct StripeExtractor::Impl {
  Impl(const StripeSettings& s, const StripeOptics& o);
  void extract(const ImageView& image, StripeResult& result);
  void setThresholds();
  void findRidges(const ImageView& image);
  void gather();
  void gather(const LineChain& chain);
  void turnRound(const LineRange& line);
  void measure(const ImageView& image);
  void walkLines();
  void finishNormal(std::size_t i, std::size_t before, std::size_t after);
  void flagEnds(const LineRange& line, std::span<const std::uint32_t> gaps);
  void flagCrosstalk(const LineRange& line);
  void smooth();
  void bendAtEnds(std::uint32_t first, std::uint32_t end);
  void rankLines();
  void write(StripeResult& result);

  StripeSettings settings;
  StripeOptics optics;
  RidgeFilter filter;
  BlockScanSettings scanSettings;
  LinkingSettings linking;
  GapSettings gaps;
  LineSmoothing smoothing;
  BlockScan scan;
  RidgePoints ridges;
  LineLinker linker;
  LineEnds lineEnds;
  GapLinker gapLinker;
  SpeckleMeter speckleMeter;
  Competition competition;
  LinePoints points;
  std::vector<Competitor> lines;
  std::vector<std::uint32_t> gapStarts;   // first point behind each bridged gap, line after line
  std::vector<std::uint32_t> gapsOfLine;  // how many of them
  std::vector<float> sorted;
};

StripeExtractor::Impl::Impl(const StripeSettings& s, const StripeOptics& o)
    : settings(s), optics(o), filter(ridgeFilter(s.sigma, 0)) {
  scanSettings.radius = scanRadius(s.sigma);
  // A line of contrast t_l that runs along the border of two blocks raises the mean of each by at least 0.4 t_l.
  scanSettings.leastContrast = 0.4 * s.low;
  scanSettings.maxBlocks = s.maxBlocks;
  linking.minLength = s.minLength;
  gaps = {s.gapDistance, s.gapAngle, s.sigma};
  smoothing = lineSmoothing(filter.variancePx2, o.blurPx * o.blurPx, s.correction);
}

// t_l and t_h as second derivatives; never so low that noise alone would make lines.
void StripeExtractor::Impl::setThresholds() {
  const double perDn = ridgePerContrast(settings.sigma, settings.sigma);
  const double noise = scan.noiseDn() * ridgeNoise(settings.sigma);
  filter.leastRidge = static_cast<float>(std::max(settings.low * perDn, kLowNoiseFactor * noise));
  linking.highRidge = static_cast<float>(std::max(settings.high * perDn, kHighNoiseFactor * noise));
}

void StripeExtractor::Impl::gather() {
  points.reserve(lineEnds.points().size);
  points.size = 0;
  lines.clear();
  gapStarts.clear();
  gapsOfLine.clear();
  for (const LineChain& chain : gapLinker.chains()) gather(chain);
}

// The pieces of a line one after the other, from left to right (or from top to bottom).
void StripeExtractor::Impl::gather(const LineChain& chain) {
  const RidgeArrays& from = lineEnds.points();
  const auto first = static_cast<std::uint32_t>(points.size);
  const std::size_t firstGap = gapStarts.size();
  for (std::uint32_t l = chain.first; l < chain.first + chain.count; ++l) {
    const ChainLink link = gapLinker.links()[l];
    const LinePiece piece = lineEnds.pieces()[link.piece];
    if (l > chain.first) gapStarts.push_back(static_cast<std::uint32_t>(points.size));
    const auto take = [&](const auto& source, auto* to) {
      const auto begin = source.begin() + piece.first, end = begin + piece.count;
      link.reversed ? std::reverse_copy(begin, end, to) : std::copy(begin, end, to);
    };
    const std::size_t to = points.size;
    take(from.x, points.x.data() + to);
    take(from.y, points.y.data() + to);
    take(from.nx, points.nx.data() + to);
    take(from.ny, points.ny.data() + to);
    take(from.ridge, points.ridge.data() + to);
    take(from.smoothed, points.light.data() + to);
    take(from.along, points.along.data() + to);
    take(from.pixel, points.pixel.data() + to);
    points.size += piece.count;
  }
  const LineRange line{first, static_cast<std::uint32_t>(points.size) - first};
  const std::size_t last = points.size - 1;
  if (points.x[last] < points.x[first] || (points.x[last] == points.x[first] && points.y[last] < points.y[first])) {
    turnRound(line);
    for (std::size_t g = firstGap; g < gapStarts.size(); ++g) gapStarts[g] = line.first + line.end() - gapStarts[g];
    std::reverse(gapStarts.begin() + static_cast<std::ptrdiff_t>(firstGap), gapStarts.end());
  }
  lines.push_back({line, Rejection::None});
  gapsOfLine.push_back(static_cast<std::uint32_t>(gapStarts.size() - firstGap));
}

void StripeExtractor::Impl::turnRound(const LineRange& line) {
  for (PaddedFloats* v : {&points.x, &points.y, &points.nx, &points.ny, &points.ridge, &points.light, &points.along})
    std::reverse(v->data() + line.first, v->data() + line.end());
  std::reverse(points.pixel.begin() + line.first, points.pixel.begin() + line.end());
}

void StripeExtractor::Impl::measure(const ImageView& image) {
  // What the filter leaves of the narrowest line that is clipped.
  const auto leastClipped =
      static_cast<float>(kClippedDn * kNarrowestLinePx / std::hypot(kNarrowestLinePx, settings.sigma));
  for (std::size_t i = 0; i < points.size; ++i) {
    const int column = columnOf(points.pixel[i]), row = rowOf(points.pixel[i]);
    points.flags[i] = points.light[i] > leastClipped && clippedAt(image, column, row) ? kSaturated : 0;
    points.light[i] -= scan.backgroundAt(column, row);
  }
  measureLight(points, static_cast<float>(filter.variancePx2));
  orientNormals(points);
}

// The normal of a point that has a neighbour on one side only.
void StripeExtractor::Impl::finishNormal(std::size_t i, std::size_t before, std::size_t after) {
  const float dx = points.x[after] - points.x[before], dy = points.y[after] - points.y[before];
  if (dx * points.ny[i] - dy * points.nx[i] >= 0) return;
  points.nx[i] = -points.nx[i];
  points.ny[i] = -points.ny[i];
}

void StripeExtractor::Impl::walkLines() {
  std::size_t gap = 0;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    const LineRange& line = lines[l].range;
    const std::uint32_t last = line.end() - 1;
    finishNormal(line.first, line.first, std::min(line.first + 1, last));
    finishNormal(last, std::max(last, line.first + 1) - 1, last);
    float arc = 0;
    for (std::uint32_t i = line.first; i <= last; ++i) {
      points.arc[i] = arc;
      arc += points.step[i];
    }
    flagEnds(line, std::span(gapStarts).subspan(gap, gapsOfLine[l]));
    flagCrosstalk(line);
    gap += gapsOfLine[l];
  }
}

// Flags, the way to the nearest edge, and how many neighbours there are up to it that it does not touch.
void StripeExtractor::Impl::flagEnds(const LineRange& range, std::span<const std::uint32_t> gapsInLine) {
  const auto reach = static_cast<float>(3 * settings.sigma);
  const auto touched = kEndTouchesSigma * static_cast<float>(settings.sigma) / kPointSpacingPx;
  for (std::size_t g = 0; g <= gapsInLine.size(); ++g) {
    const std::uint32_t first = g == 0 ? range.first : gapsInLine[g - 1];
    const std::uint32_t end = g == gapsInLine.size() ? range.end() : gapsInLine[g];
    const std::uint8_t atFirst = g == 0 ? kLineEnd : kGapEdge, atEnd = g == gapsInLine.size() ? kLineEnd : kGapEdge;
    for (std::uint32_t i = first; i < end; ++i) {
      const float before = points.arc[i] - points.arc[first], behind = points.arc[end - 1] - points.arc[i];
      points.edge[i] = std::min(before, behind);
      points.room[i] = static_cast<float>(std::min(i - first, end - 1 - i)) - touched;
      if (before <= reach) points.flags[i] |= atFirst;
      if (behind <= reach) points.flags[i] |= atEnd;
    }
  }
}

// The light of another laser continues the line, many times weaker.
void StripeExtractor::Impl::flagCrosstalk(const LineRange& line) {
  sorted.clear();
  for (std::uint32_t i = line.first; i < line.end(); i += 16) sorted.push_back(points.strength[i]);
  const auto upper = sorted.begin() + static_cast<std::ptrdiff_t>(3 * sorted.size() / 4);
  std::nth_element(sorted.begin(), upper, sorted.end());
  const float limit = kCrosstalkShare * *upper;
  for (std::uint32_t i = line.first; i < line.end();) {
    std::uint32_t k = i;
    while (k < line.end() && points.strength[k] < limit) ++k;
    for (std::uint32_t j = i; k - i >= kCrosstalkRun && j < k; ++j) points.flags[j] |= kCrosstalk;
    i = std::max(k, i + 1);
  }
}

void StripeExtractor::Impl::smooth() {
  speckleMeter.begin(filter, scan.noiseDn());
  for (const Competitor& line : lines)
    if (line.rejection == Rejection::None) speckleMeter.add(points, line.range);
  const auto variance = static_cast<float>(filter.variancePx2);
  setRidgeSigma(points, static_cast<float>(scan.noiseDn() * filter.gradientNoise), speckleMeter.speckle(), variance);
  smoothAlong(points, smoothing);
  setBrightening(points);
  std::size_t gap = 0;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    std::uint32_t first = lines[l].range.first;
    for (std::uint32_t g = 0; g < gapsOfLine[l]; ++g, ++gap) {
      bendAtEnds(first, gapStarts[gap]);
      first = gapStarts[gap];
    }
    bendAtEnds(first, lines[l].range.end());
  }
}

// Where the ends leave no room for a window, the line goes on as it bends where there is; and the ends have an error of
// their own.
void StripeExtractor::Impl::bendAtEnds(std::uint32_t first, std::uint32_t end) {
  const float least = smoothing.windows[0].room;
  const auto close = static_cast<float>(6 * settings.sigma);
  std::uint32_t inner = first;
  while (inner < end && points.room[inner] < least) ++inner;
  if (inner < end) {
    std::uint32_t last = end - 1;
    while (points.room[last] < least) --last;
    const auto extend = [&](std::uint32_t from, std::uint32_t to, float bend) {
      for (std::uint32_t i = from; i < to; ++i) {
        points.bend[i] = bend;
        if (smoothing.applied) points.shift[i] = -smoothing.pullPx2 * bend;
      }
    };
    extend(first, inner, points.bend[inner]);
    extend(last + 1, end, points.bend[last]);
  }
  const auto addEnd = [&](std::uint32_t i) {
    const float e = endSigma(points.edge[i], settings.sigma);
    points.sigma[i] = std::sqrt(points.sigma[i] * points.sigma[i] + e * e);
    points.shiftedSigma[i] = std::sqrt(points.shiftedSigma[i] * points.shiftedSigma[i] + e * e);
  };
  std::uint32_t i = first;
  for (; i < end && points.edge[i] < close; ++i) addEnd(i);
  for (std::uint32_t k = end; k > i && points.edge[k - 1] < close; --k) addEnd(k - 1);
}

void StripeExtractor::Impl::rankLines() {
  competition.judge(points, lines, optics.field, CompetitionSettings{});
  for (const Competitor& line : lines)
    for (std::uint32_t i = line.range.first; line.rejection != Rejection::None && i < line.range.end(); ++i)
      points.flags[i] |= kRejected;
}

void StripeExtractor::Impl::write(StripeResult& result) {
  std::sort(lines.begin(), lines.end(), [](const Competitor& a, const Competitor& b) {
    const bool lostA = a.rejection != Rejection::None, lostB = b.rejection != Rejection::None;
    if (lostA != lostB) return lostB;
    return a.range.count != b.range.count ? a.range.count > b.range.count : a.range.first < b.range.first;
  });
  result.points.resize(points.size);
  result.lines.clear();
  std::uint32_t kept = 0, saturated = 0, steps = 0, to = 0;
  float length = 0;
  for (const auto& [range, rejection] : lines) {
    result.lines.push_back({to, range.count, rejection});
    std::uint32_t clipped = 0;
    for (std::uint32_t i = range.first; i < range.end(); ++i) {
      StripePoint& p = result.points[to++];
      const float shift = points.shift[i], nx = points.nx[i], ny = points.ny[i],
                  pull = smoothing.pullPx2 * points.bend[i];
      // With the correction off the pull of the bend stays, as an error.
      const float ridgeSigma = points.sigma[i],
                  sigma = smoothing.applied ? points.shiftedSigma[i] : std::hypot(ridgeSigma, pull);
      p = {points.x[i] + shift * nx, points.y[i] + shift * ny, nx,    ny,         sigma,
           points.strength[i],       std::sqrt(points.s2[i]),  shift, ridgeSigma, points.brightening[i],
           points.flags[i]};
      clipped += points.flags[i] & kSaturated;
    }
    if (rejection != Rejection::None) continue;
    kept += range.count;
    saturated += clipped;
    steps += range.count - 1;
    length += points.arc[range.end() - 1];
  }
  result.noiseDn = scan.noiseDn();
  result.backgroundDn = scan.backgroundDn();
  result.saturatedShare = kept == 0 ? 0 : static_cast<float>(saturated) / static_cast<float>(kept);
  // White noise smoothed by sigma along the line: the sum of its correlation exp(-d^2 / 4 sigma^2) over the points.
  const double spacing = steps == 0 ? 1 : std::max(0.5, static_cast<double>(length) / static_cast<double>(steps));
  result.correlatedPoints =
      static_cast<float>(std::max(1.0, 2 * std::sqrt(std::numbers::pi) * settings.sigma / spacing));
  result.smoothingPx = smoothing.applied ? std::sqrt(smoothing.pullPx2) : 0;
  result.overloaded = scan.overloaded();
}

// The ridges of one row of blocks while the pixels of the next are on their way. A frame of more blocks than the budget
// begins anew with the brightest.
void StripeExtractor::Impl::findRidges(const ImageView& image) {
  ridges.begin(image, filter);
  constexpr int kBehind = 2;  // rows until what the scan asked for has come
  for (int row = 0; row < scan.rows() + kBehind; ++row) {
    if (row < scan.rows()) scan.settle(row);
    if (row >= kBehind && !scan.overloaded()) ridges.find(scan.runsOf(row - kBehind));
  }
  if (scan.overloaded()) {
    scan.cap();
    ridges.begin(image, filter);
    ridges.find(scan.runs());
  }
  ridges.finish(scan.runs());
}

void StripeExtractor::Impl::extract(const ImageView& image, StripeResult& result) {
  if (image.empty()) {
    result = {};
    return;
  }
  scan.begin(image, scanSettings);
  setThresholds();
  findRidges(image);
  linker.link(ridges, linking);
  lineEnds.retrace(image, filter, ridges, linker);
  gapLinker.link(lineEnds.points(), lineEnds.pieces(), gaps);
  gather();
  measure(image);
  walkLines();
  rankLines();
  smooth();
  write(result);
}

StripeExtractor::StripeExtractor(const StripeSettings& settings, const StripeOptics& optics)
    : impl_(std::make_unique<Impl>(settings, optics)) {}
StripeExtractor::~StripeExtractor() = default;
StripeExtractor::StripeExtractor(StripeExtractor&&) noexcept = default;
StripeExtractor& StripeExtractor::operator=(StripeExtractor&&) noexcept = default;

void StripeExtractor::extract(const ImageView& image, StripeResult& result) { impl_->extract(image, result); }

}  // namespace vignole
