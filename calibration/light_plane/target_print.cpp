#include "calibration/light_plane/target_print.h"

#include <algorithm>
#include <cmath>

namespace vignole {
namespace {

constexpr double kReach = 3;  // widths; 12 steps of a quarter

bool inside(const TargetRectangle& r, const Point2& at) {
  return at.x() > r.min.x() && at.y() > r.min.y() && at.x() < r.max.x() && at.y() < r.max.y();
}

bool inCircle(const PlanarTarget& target, const Point2& at) {
  const double pitch = target.pitchMm;
  const bool shifted = target.pattern == TargetPattern::AsymmetricCircles;
  const auto nearest = [](double x, int count) { return std::clamp(static_cast<int>(std::lround(x)), 0, count - 1); };
  const int row = nearest(at.y() / pitch, target.rows);
  // Of asymmetric circles the row above or below may be nearer; circles of one row do not reach into the next but one.
  for (int r = std::max(0, row - 1); r <= std::min(target.rows - 1, row + 1); ++r) {
    const double x = shifted ? (at.x() / pitch - r % 2) / 2 : at.x() / pitch;
    const int column = nearest(x, target.columns);
    const Point2 centre(pitch * (shifted ? 2 * column + r % 2 : column), pitch * r);
    if ((at - centre).norm() < target.diameterMm / 2) return true;
  }
  return false;
}

bool inFrame(const PlanarTarget& target, const Point2& at) {
  const DotPlateFrame border = frame(target);
  const Point2 width(border.widthMm, border.widthMm), corner = at - border.outer.min;
  if (!inside(border.outer, at)) return false;
  return !inside({border.outer.min + width, border.outer.max - width}, at) || corner.x() + corner.y() < border.cornerMm;
}

}  // namespace

bool isBlack(const PlanarTarget& target, const Point2& at) {
  if (target.pattern == TargetPattern::Chessboard) {
    if (!inside(printedArea(target), at)) return false;
    // The square up and left of point 0 is black.
    const auto column = static_cast<long>(std::floor(at.x() / target.pitchMm));
    const auto row = static_cast<long>(std::floor(at.y() / target.pitchMm));
    return (column + row) % 2 == 0;
  }
  const bool printed = inCircle(target, at) || (target.pattern == TargetPattern::DotPlate && inFrame(target, at));
  return printed != target.lightDots;
}

PrintAcross::PrintAcross(const PlanarTarget& target, const Point2& at, const Point2& width) {
  for (int i = -kTaps; i <= kTaps; ++i)
    black_[static_cast<std::size_t>(i + kTaps)] = isBlack(target, at + kReach * i / kTaps * width);
}

double PrintAcross::pull(double blackShare) const {
  double sum = 0, moment = 0;
  for (int i = -kTaps; i <= kTaps; ++i) {
    const double t = kReach * i / kTaps;
    const double light = std::exp(-0.5 * t * t) * (black_[static_cast<std::size_t>(i + kTaps)] ? blackShare : 1);
    sum += light;
    moment += light * t;
  }
  return moment / sum;
}

bool PrintAcross::white() const {
  return std::none_of(black_.begin() + 4, black_.end() - 4, [](bool b) { return b; });
}
bool PrintAcross::black() const {
  return std::all_of(black_.begin() + 4, black_.end() - 4, [](bool b) { return b; });
}

TargetRectangle printedArea(const PlanarTarget& target) {
  const std::vector<Point2> points = target.points();
  TargetRectangle area{points.front(), points.front()};
  for (const Point2& p : points) {
    area.min = area.min.cwiseMin(p);
    area.max = area.max.cwiseMax(p);
  }
  const double beyond = target.pattern == TargetPattern::Chessboard || target.pattern == TargetPattern::DotPlate
                            ? target.pitchMm
                            : target.pitchMm / 2;
  area.min -= Point2(beyond, beyond);
  area.max += Point2(beyond, beyond);
  return area;
}

}  // namespace vignole
