#include "calibration/detection/pose_difference.h"

#include <cmath>
#include <complex>
#include <map>

namespace vignole {
namespace {

using Complex = std::complex<double>;

struct Pair {
  Complex a, b;
};

/// Squares summed with points as complex numbers: a similarity is then a multiplication.
PoseDifference differenceOf(const std::vector<Pair>& pairs) {
  const auto n = static_cast<double>(pairs.size());
  Complex middleA = 0, middleB = 0;
  for (const Pair& p : pairs) {
    middleA += p.a / n;
    middleB += p.b / n;
  }
  double moved = 0, sizeA = 0, sizeB = 0;
  Complex product = 0;
  for (const Pair& p : pairs) {
    moved += std::norm(p.b - p.a);
    sizeA += std::norm(p.a - middleA);
    sizeB += std::norm(p.b - middleB);
    product += std::conj(p.a - middleA) * (p.b - middleB);
  }
  const double left = sizeB - std::norm(product) / std::max(sizeA, 1e-12);
  return {std::sqrt(moved / n), std::sqrt(std::max(left, 0.0) / n), std::sqrt(0.5 * (sizeA + sizeB) / n)};
}

}  // namespace

std::optional<PoseDifference> poseDifference(const TargetView& a, const TargetView& b, const PlanarTarget& target) {
  constexpr std::size_t kLeastCommon = 4;
  std::map<int, Point2> inA;
  for (const FoundPoint& p : a.points) inA[p.index] = p.px;
  const int last = target.columns * target.rows - 1;
  const auto differenceWith = [&](bool upsideDown) -> std::optional<PoseDifference> {
    std::vector<Pair> pairs;
    for (const FoundPoint& p : b.points)
      if (const auto found = inA.find(upsideDown ? last - p.index : p.index); found != inA.end())
        pairs.push_back({{found->second.x(), found->second.y()}, {p.px.x(), p.px.y()}});
    if (pairs.size() < kLeastCommon) return std::nullopt;
    return differenceOf(pairs);
  };
  const auto straight = differenceWith(false);
  if (target.pattern == TargetPattern::DotPlate) return straight;
  const auto turned = differenceWith(true);
  if (!straight || (turned && turned->movedPx < straight->movedPx)) return turned;
  return straight;
}

std::vector<int> samePose(std::span<const TargetView> views, const PlanarTarget& target, double leastMoved) {
  std::vector<int> same(views.size(), -1);
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (!views[i].usable()) continue;
    for (std::size_t j = 0; j < i && same[i] < 0; ++j) {
      if (!views[j].usable() || same[j] >= 0) continue;
      const auto difference = poseDifference(views[j], views[i], target);
      if (difference && difference->moved() < leastMoved) same[i] = static_cast<int>(j);
    }
  }
  return same;
}

std::string samePoseRefusal(const TargetView& other) {
  return "same pose as " + (other.file.empty() ? std::string("another picture") : other.file) +
         "; move or tilt the target between pictures";
}

}  // namespace vignole
