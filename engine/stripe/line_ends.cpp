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

float distance(const RidgePoint& a, const RidgePoint& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}

/// Place of the last point at least `way` px along the line before place `from`; 0 if there is none.
template <class Points>
std::size_t back(const Points& points, std::size_t from, float way) {
  while (from > 0 && way > 0) {
    way -= distance(points[from], points[from - 1]);
    --from;
  }
  return from;
}

float angleBetween(float ax, float ay, float bx, float by) { return std::atan2(ax * by - ay * bx, ax * bx + ay * by); }

}  // namespace

class LineEnds::Outwards {
 public:
  Outwards(const RidgeArrays& points, std::span<const std::uint32_t> order, bool reversed)
      : points_(points), order_(order), reversed_(reversed) {}
  [[nodiscard]] std::size_t size() const { return order_.size(); }
  [[nodiscard]] RidgePoint operator[](std::size_t place) const {
    return points_.at(order_[reversed_ ? order_.size() - 1 - place : place]);
  }

 private:
  const RidgeArrays& points_;
  std::span<const std::uint32_t> order_;
  bool reversed_;
};

LineEnds::Trusted LineEnds::trustedPart(const Outwards& points) const {
  Trusted trusted;
  trusted.last = back(points, points.size() - 1, kUntouched * sigma_);
  const std::size_t first = back(points, trusted.last, kCurvatureOver * sigma_), middle = (first + trusted.last) / 2;
  const RidgePoint a = points[first], b = points[middle], c = points[trusted.last];
  const float before = distance(a, b), behind = distance(b, c);
  if (std::min(before, behind) > sigma_)
    trusted.curvature = 2 * angleBetween(b.x - a.x, b.y - a.y, c.x - b.x, c.y - b.y) / (before + behind);
  const std::size_t near = back(points, trusted.last, kChord * sigma_);
  for (std::size_t i = near; i <= trusted.last; ++i) trusted.ridge += points[i].ridge;
  trusted.ridge /= static_cast<float>(trusted.last - near + 1);
  return trusted;
}

// The line's point on the way (nx, ny) through the pixel at (x, y), from the same differences as everywhere.
bool LineEnds::measure(const ImageView& image, const RidgeFilter& filter, float x, float y, float nx, float ny,
                       RidgePoint& point) {
  const int column = static_cast<int>(std::lround(x)), row = static_cast<int>(std::lround(y));
  const auto [pixels, stride] = window_.at(image, filter, column, row, 1);
  const std::array<float, 9> s = smoothedAround(pixels, stride, filter);
  const float dx = (s[5] - s[3]) / 2, dy = (s[7] - s[1]) / 2;
  const float dxx = s[5] + s[3] - 2 * s[4], dyy = s[7] + s[1] - 2 * s[4];
  const float dxy = (s[8] - s[6] - s[2] + s[0]) / 4;
  const float ridge = -(dxx * nx * nx + 2 * dxy * nx * ny + dyy * ny * ny);
  if (!(ridge > 0)) return false;
  const float t = (dx * nx + dy * ny) / ridge;
  point = {static_cast<float>(column) + t * nx,
           static_cast<float>(row) + t * ny,
           nx,
           ny,
           ridge,
           s[4],
           0,  // the direction is known: light that changes along the line does not turn it
           packedPixel(column, row)};
  return true;
}

/// Goes on from the last of traced_; not further from the light that the scan saw than reachPx() allows.
void LineEnds::follow(const ImageView& image, const RidgeFilter& filter, const RidgePoints& ridges,
                      const Trusted& trusted) {
  const int room = reachPx(filter) - filter.radius - 1;
  const float least = std::max(filter.leastRidge, kEdgeShare * trusted.ridge);
  const auto steps = static_cast<int>(2 * kUntouched * sigma_);
  for (int step = 0; step < steps; ++step) {
    const RidgePoint last = traced_.back();
    const RidgePoint& from = traced_[back(traced_, traced_.size() - 1, kChord * sigma_)];
    const float chord = distance(from, last);
    if (chord < sigma_) return;
    // The chord's direction is that of its middle.
    const float turn = trusted.curvature * chord / 2, cx = (last.x - from.x) / chord, cy = (last.y - from.y) / chord;
    const float c = std::cos(turn), s = std::sin(turn), tx = cx * c - cy * s, ty = cx * s + cy * c;
    float x = last.x + tx, y = last.y + ty;
    if (std::lround(x) == columnOf(last.pixel) && std::lround(y) == rowOf(last.pixel)) {  // still the same pixel
      x += 0.5F * tx;
      y += 0.5F * ty;
    }
    if (x < 0 || y < 0 || x > static_cast<float>(image.width - 1) || y > static_cast<float>(image.height - 1)) return;
    if (!ridges.litWithin(static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y)), room)) return;
    RidgePoint next;
    if (!measure(image, filter, x, y, -ty, tx, next) || next.ridge < least) return;
    const float ex = next.x - last.x, ey = next.y - last.y;
    if (std::abs(ey * tx - ex * ty) > kLargestStepAside || ex * tx + ey * ty < 0.05F) return;
    traced_.push_back(next);
  }
}

bool LineEnds::retraceEnd(const ImageView& image, const RidgeFilter& filter, const RidgePoints& ridges,
                          const Outwards& points, Trusted& trusted, std::vector<RidgePoint>& tail) {
  trusted = trustedPart(points);
  const std::size_t start = back(points, trusted.last, kLeastPart * sigma_);
  if (distance(points[start], points[trusted.last]) < kLeastPart * sigma_) return false;
  traced_.clear();
  for (std::size_t i = start; i <= trusted.last; ++i) traced_.push_back(points[i]);
  const std::size_t known = traced_.size();
  follow(image, filter, ridges, trusted);
  tail.assign(traced_.begin() + static_cast<std::ptrdiff_t>(known), traced_.end());
  return true;
}

void LineEnds::retrace(const ImageView& image, const RidgeFilter& filter, const RidgePoints& ridges,
                       const LineLinker& lines) {
  sigma_ = std::sqrt(static_cast<float>(filter.variancePx2));
  const RidgeArrays& all = ridges.points();
  const auto tailLength = static_cast<std::size_t>(2 * kUntouched * sigma_) + 1;
  std::size_t total = 0;
  for (const LinePiece& piece : lines.pieces()) total += piece.count + 2 * tailLength;
  points_.reserve(total);
  points_.size = 0;
  pieces_.clear();
  for (const LinePiece& piece : lines.pieces()) {
    const std::span<const std::uint32_t> order = lines.order(piece);
    const std::size_t last = order.size() - 1;
    Trusted atHead, atStop;
    const bool retraced = retraceEnd(image, filter, ridges, {all, order, true}, atHead, head_) &&
                          retraceEnd(image, filter, ridges, {all, order, false}, atStop, stop_) &&
                          last - atHead.last <= atStop.last;
    const auto first = static_cast<std::uint32_t>(points_.size);
    if (!retraced) {
      points_.append(all, order);
    } else {
      for (auto p = head_.rbegin(); p != head_.rend(); ++p) points_.push(*p);
      points_.append(all, order.subspan(last - atHead.last, atStop.last + 1 - (last - atHead.last)));
      for (const RidgePoint& p : stop_) points_.push(p);
    }
    pieces_.push_back({first, static_cast<std::uint32_t>(points_.size) - first});
  }
}

}  // namespace vignole
