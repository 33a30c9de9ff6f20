#include "engine/stripe/gap_linking.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace vignole {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFF;

struct Direction {
  float dx = 1, dy = 0;
};

/// Orthogonal regression.
Direction regression(const RidgeArrays& points, std::size_t first, std::size_t count) {
  double mx = 0, my = 0;
  for (std::size_t i = first; i < first + count; ++i) {
    mx += points.x[i];
    my += points.y[i];
  }
  mx /= static_cast<double>(count);
  my /= static_cast<double>(count);
  double sxx = 0, sxy = 0, syy = 0;
  for (std::size_t i = first; i < first + count; ++i) {
    const double x = points.x[i] - mx, y = points.y[i] - my;
    sxx += x * x;
    sxy += x * y;
    syy += y * y;
  }
  const double angle = 0.5 * std::atan2(2 * sxy, sxx - syy);
  return {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
}

}  // namespace

void GapLinker::link(const RidgeArrays& points, std::span<const LinePiece> pieces, const GapSettings& settings) {
  ends_.clear();
  for (const LinePiece& piece : pieces) {
    const auto used = std::min(static_cast<std::uint32_t>(5 * settings.sigma) + 3, piece.count);
    for (const bool atStop : {false, true}) {
      const std::size_t first = atStop ? piece.first + piece.count - used : piece.first, last = first + used - 1;
      const std::size_t end = atStop ? last : first, inner = atStop ? first : last;
      Direction d = regression(points, first, used);
      if ((points.x[end] - points.x[inner]) * d.dx + (points.y[end] - points.y[inner]) * d.dy < 0) d = {-d.dx, -d.dy};
      ends_.push_back({points.x[end], points.y[end], d.dx, d.dy});
    }
  }
  findBridges(settings);
  chooseBridges();
  followChains(pieces.size());
}

void GapLinker::findBridges(const GapSettings& settings) {
  bridges_.clear();
  byX_.resize(ends_.size());
  for (std::uint32_t i = 0; i < byX_.size(); ++i) byX_[i] = i;
  std::sort(byX_.begin(), byX_.end(), [this](std::uint32_t a, std::uint32_t b) {
    return ends_[a].x != ends_[b].x ? ends_[a].x < ends_[b].x : a < b;
  });
  const auto distance = static_cast<float>(settings.distance);
  const double alpha = settings.angleDeg * std::numbers::pi / 180;
  const auto leastCosine = static_cast<float>(std::cos(alpha)), sine = static_cast<float>(std::sin(alpha));
  // Over a short way the ends' own uncertainty decides about its angle, not their direction.
  const auto slack = static_cast<float>(0.5 * settings.sigma);
  for (std::size_t i = 0; i < byX_.size(); ++i)
    for (std::size_t k = i + 1; k < byX_.size(); ++k) {
      const End &a = ends_[byX_[i]], &b = ends_[byX_[k]];
      const float gx = b.x - a.x, gy = b.y - a.y;
      if (gx > distance) break;
      const float gap = std::hypot(gx, gy);
      if (gap > distance || byX_[i] / 2 == byX_[k] / 2) continue;
      const float cosine = -(a.dx * b.dx + a.dy * b.dy);
      const bool straight = cosine >= leastCosine;
      const bool ahead = gx * a.dx + gy * a.dy > -slack && -gx * b.dx - gy * b.dy > -slack;
      const float aside = std::max(std::abs(gx * a.dy - gy * a.dx), std::abs(gx * b.dy - gy * b.dx));
      if (straight && ahead && aside <= gap * sine + slack)
        bridges_.push_back({gap * (2 - cosine) + aside, byX_[i], byX_[k]});
    }
  std::sort(bridges_.begin(), bridges_.end(), [](const Bridge& a, const Bridge& b) {
    return a.cost != b.cost ? a.cost < b.cost : (a.a != b.a ? a.a < b.a : a.b < b.b);
  });
}

std::uint32_t GapLinker::root(std::uint32_t piece) {
  while (parent_[piece] != piece) piece = parent_[piece] = parent_[parent_[piece]];
  return piece;
}

void GapLinker::chooseBridges() {
  partner_.assign(ends_.size(), kNone);
  parent_.resize(ends_.size() / 2);
  for (std::uint32_t i = 0; i < parent_.size(); ++i) parent_[i] = i;
  for (const Bridge& bridge : bridges_) {
    const std::uint32_t a = root(bridge.a / 2), b = root(bridge.b / 2);
    if (partner_[bridge.a] != kNone || partner_[bridge.b] != kNone || a == b) continue;  // a == b would close a ring
    partner_[bridge.a] = bridge.b;
    partner_[bridge.b] = bridge.a;
    parent_[std::max(a, b)] = std::min(a, b);
  }
}

void GapLinker::followChains(std::size_t pieces) {
  chains_.clear();
  links_.clear();
  seen_.assign(pieces, 0);
  for (std::uint32_t p = 0; p < pieces; ++p) {
    const std::uint32_t begin = 2 * p, stop = begin + 1;
    const bool freeBegin = partner_[begin] == kNone, freeStop = partner_[stop] == kNone;
    if (seen_[p] != 0 || (!freeBegin && !freeStop)) continue;
    LineChain chain{static_cast<std::uint32_t>(links_.size()), 0};
    for (std::uint32_t entry = freeBegin ? begin : stop; entry != kNone; entry = partner_[entry ^ 1U]) {
      seen_[entry / 2] = 1;
      links_.push_back({entry / 2, (entry & 1U) != 0});
    }
    chain.count = static_cast<std::uint32_t>(links_.size()) - chain.first;
    chains_.push_back(chain);
  }
}

}  // namespace vignole
