#include "engine/stripe/line_ends.h"

#include <algorithm>
#include <cmath>

namespace vignole {
namespace {

constexpr float kUntouched = 4;       // sigma from the end: the fork does not reach there
constexpr float kChord = 3;           // sigma; the direction comes from a chord of this length
constexpr float kCurvatureOver = 12;  // sigma
constexpr float kLeastPart = 3;       // sigma of trusted points, or the end stays as it is
// At the edge of the light the second derivative has fallen to half; it ends a little behind that.
constexpr float kEdgeShare = 0.45F;
constexpr float kLargestStepAside = 1;  // px between one point and the next, off the expected direction

float distance(const RidgePoint& a, const RidgePoint& b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// Index of the last point at least `way` px along the line before points[from]; 0 if there is none.
std::size_t back(std::span<const RidgePoint> points, std::size_t from, float way) {
  while (from > 0 && way > 0) {
    way -= distance(points[from], points[from - 1]);
    --from;
  }
  return from;
}

float angleBetween(float ax, float ay, float bx, float by) { return std::atan2(ax * by - ay * bx, ax * bx + ay * by); }

}  // namespace

LineEnds::LineEnds() : band_(std::make_unique<RidgeBand>()), patch_(std::size_t{kPatch + 2} * (kPatch + 2)) {}

LineEnds::Trusted LineEnds::trustedPart(std::span<const RidgePoint> outwards) const {
  Trusted trusted;
  trusted.last = back(outwards, outwards.size() - 1, kUntouched * sigma_);
  const std::size_t first = back(outwards, trusted.last, kCurvatureOver * sigma_), middle = (first + trusted.last) / 2;
  const RidgePoint &a = outwards[first], &b = outwards[middle], &c = outwards[trusted.last];
  const float before = distance(a, b), behind = distance(b, c);
  if (std::min(before, behind) > sigma_)
    trusted.curvature = 2 * angleBetween(b.x - a.x, b.y - a.y, c.x - b.x, c.y - b.y) / (before + behind);
  const std::size_t near = back(outwards, trusted.last, kChord * sigma_);
  for (std::size_t i = near; i <= trusted.last; ++i) trusted.ridge += outwards[i].ridge;
  trusted.ridge /= static_cast<float>(trusted.last - near + 1);
  return trusted;
}

void LineEnds::smoothAround(const ImageView& image, const RidgeFilter& filter, int column, int row) {
  patchColumn_ = column - kPatch / 2;
  patchRow_ = row - kPatch / 2;
  for (int y = 0; y < kPatch; y += kBandHeight) {
    const auto [pixels, stride] = window_.at(image, filter, patchColumn_, patchRow_ + y, kPatch);
    smoothBand(pixels, stride, kPatch, filter, *band_);
    for (int r = 0; r < kBandHeight + 2; ++r)
      std::copy_n(band_->smoothed[static_cast<std::size_t>(r)].begin(), kPatch + 2,
                  patch_.begin() + static_cast<std::ptrdiff_t>(y + r) * (kPatch + 2));
  }
}

// The line's point on the way (nx, ny) through the pixel at (x, y), from the same differences as everywhere.
bool LineEnds::measure(float x, float y, float nx, float ny, RidgePoint& point) const {
  const int column = static_cast<int>(std::lround(x)), row = static_cast<int>(std::lround(y));
  const int i = column - patchColumn_, j = row - patchRow_;
  if (i < 0 || j < 0 || i >= kPatch || j >= kPatch) return false;
  constexpr std::ptrdiff_t kPitch = kPatch + 2;
  const float* s = patch_.data() + (j + 1) * kPitch + i + 1;
  const float dx = (s[1] - s[-1]) / 2, dy = (s[kPitch] - s[-kPitch]) / 2;
  const float dxx = s[1] + s[-1] - 2 * s[0], dyy = s[kPitch] + s[-kPitch] - 2 * s[0];
  const float dxy = (s[kPitch + 1] - s[kPitch - 1] - s[1 - kPitch] + s[-1 - kPitch]) / 4;
  const float ridge = -(dxx * nx * nx + 2 * dxy * nx * ny + dyy * ny * ny);
  if (!(ridge > 0)) return false;
  const float t = (dx * nx + dy * ny) / ridge;
  point = {static_cast<float>(column) + t * nx,
           static_cast<float>(row) + t * ny,
           nx,
           ny,
           ridge,
           s[0],
           static_cast<std::uint16_t>(std::max(0, column)),
           static_cast<std::uint16_t>(std::max(0, row))};
  return true;
}

void LineEnds::follow(const ImageView& image, const RidgeFilter& filter, std::span<const RidgePoint> outwards,
                      const Trusted& trusted) {
  traced_.assign(outwards.begin(), outwards.begin() + static_cast<std::ptrdiff_t>(trusted.last) + 1);
  const float least = std::max(filter.leastRidge, kEdgeShare * trusted.ridge);
  const auto steps = static_cast<int>(2 * kUntouched * sigma_);
  patchColumn_ = patchRow_ = -2 * kPatch;  // nothing smoothed yet
  for (int step = 0; step < steps; ++step) {
    const RidgePoint& last = traced_.back();
    const std::size_t from = back(traced_, traced_.size() - 1, kChord * sigma_);
    const float chord = distance(traced_[from], last);
    if (chord < sigma_) return;
    // The chord's direction is that of its middle.
    const float turn = trusted.curvature * chord / 2, cx = (last.x - traced_[from].x) / chord,
                cy = (last.y - traced_[from].y) / chord;
    const float tx = cx * std::cos(turn) - cy * std::sin(turn), ty = cx * std::sin(turn) + cy * std::cos(turn);
    float x = last.x + tx, y = last.y + ty;
    if (std::lround(x) == last.column && std::lround(y) == last.row) {  // still the same pixel
      x += 0.5F * tx;
      y += 0.5F * ty;
    }
    if (x < 0 || y < 0 || x > static_cast<float>(image.width - 1) || y > static_cast<float>(image.height - 1)) return;
    const int column = static_cast<int>(std::lround(x)), row = static_cast<int>(std::lround(y));
    if (std::abs(column - patchColumn_ - kPatch / 2) > kPatch / 2 - 1 ||
        std::abs(row - patchRow_ - kPatch / 2) > kPatch / 2 - 1)
      smoothAround(image, filter, column + static_cast<int>(tx * kPatch / 3), row + static_cast<int>(ty * kPatch / 3));
    RidgePoint next;
    if (!measure(x, y, -ty, tx, next) || next.ridge < least) return;
    const float ex = next.x - last.x, ey = next.y - last.y;
    if (std::abs(ey * tx - ex * ty) > kLargestStepAside || ex * tx + ey * ty < 0.05F) return;
    traced_.push_back(next);
  }
}

void LineEnds::retrace(const ImageView& image, const RidgeFilter& filter, const LineLinker& lines) {
  sigma_ = std::sqrt(static_cast<float>(filter.variancePx2));
  points_.clear();
  pieces_.clear();
  for (const LinePiece& piece : lines.pieces()) {
    const auto whole = std::span(lines.points()).subspan(piece.first, piece.count);
    const auto first = static_cast<std::uint32_t>(points_.size());
    points_.insert(points_.end(), whole.begin(), whole.end());
    // Once for each end: the piece is turned round in between, and once more at last.
    for (int end = 0; end < 2; ++end) {
      const auto piecePoints = std::span(points_).subspan(first);
      const Trusted trusted = trustedPart(piecePoints);
      const std::size_t start = back(piecePoints, trusted.last, kLeastPart * sigma_);
      if (distance(piecePoints[start], piecePoints[trusted.last]) >= kLeastPart * sigma_) {
        follow(image, filter, piecePoints, trusted);
        points_.resize(first);
        points_.insert(points_.end(), traced_.begin(), traced_.end());
      }
      std::reverse(points_.begin() + first, points_.end());
    }
    pieces_.push_back({first, static_cast<std::uint32_t>(points_.size()) - first});
  }
}

}  // namespace vignole
