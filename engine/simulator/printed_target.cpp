#include "engine/simulator/printed_target.h"

#include <algorithm>
#include <cmath>

#include "engine/simulator/hashing.h"

namespace vignole::simulator {

namespace {

/// Share of the area on the border's inner side: as of an even distribution of the area's variance across the border.
double share(double insideMm, double aAcross, double bAcross) {
  const double width2 = aAcross * aAcross + bAcross * bAcross;
  if (4 * insideMm * insideMm >= width2) return insideMm > 0 ? 1 : 0;
  return 0.5 + insideMm / std::sqrt(width2);
}

double share(double insideMm, const Point2& normal, const Footprint& area) {
  return share(insideMm, normal.dot(area.a), normal.dot(area.b));
}

double shareOfRectangle(const TargetRectangle& r, const Point2& at, const Footprint& area) {
  return share(std::min(at.x() - r.min.x(), r.max.x() - at.x()), area.a.x(), area.b.x()) *
         share(std::min(at.y() - r.min.y(), r.max.y() - at.y()), area.a.y(), area.b.y());
}

double distanceToBorder(const TargetRectangle& r, const Point2& at) {
  // Lower bound, also outside beside a corner.
  return std::min(std::min(std::abs(at.x() - r.min.x()), std::abs(r.max.x() - at.x())),
                  std::min(std::abs(at.y() - r.min.y()), std::abs(r.max.y() - at.y())));
}

int nearest(double x) { return static_cast<int>(std::floor(x + 0.5)); }

TargetRectangle shrunk(const TargetRectangle& r, double by) { return {r.min + Point2(by, by), r.max - Point2(by, by)}; }

}  // namespace

PrintedTarget::PrintedTarget(const PlanarTarget& target, double errorMm, bool mirrored, std::uint64_t seed)
    : target_(target),
      errorMm_(errorMm),
      mirrored_(mirrored),
      board_(board(target)),
      frame_(frame(target)),
      inFrame_(shrunk(frame_.outer, frame_.widthMm)),
      drawn_(target.points()) {
  width_ = board_.min.x() + board_.max.x();
  Draws draws(seed, Stream::Target);
  for (Point2& point : drawn_) {
    const double dx = errorMm * draws.uniform(-1, 1), dy = errorMm * draws.uniform(-1, 1);
    shifts_.emplace_back(dx, dy);
    point += shifts_.back();
    points_.push_back(asDrawn(point));
  }
}

int PrintedTarget::nearestCircle(const Point2& at) const {
  const double pitch = target_.pitchMm;
  if (target_.pattern != TargetPattern::AsymmetricCircles) {
    const int column = std::clamp(nearest(at.x() / pitch), 0, target_.columns - 1);
    const int row = std::clamp(nearest(at.y() / pitch), 0, target_.rows - 1);
    return row * target_.columns + column;
  }
  // Rows interleave: the nearest of the two rows beside the place.
  int best = 0;
  double least = 1e300;
  const auto low = static_cast<int>(std::floor(at.y() / pitch));
  for (const int candidate : {low, low + 1}) {
    const int row = std::clamp(candidate, 0, target_.rows - 1);
    const int column = std::clamp(nearest((at.x() / pitch - row % 2) / 2), 0, target_.columns - 1);
    const int index = row * target_.columns + column;
    const double d = (at - drawn_[static_cast<std::size_t>(index)]).squaredNorm();
    if (d < least) least = d, best = index;
  }
  return best;
}

/// How far the print is shifted here: between the four corners around the place, evenly.
Point2 PrintedTarget::shiftAt(const Point2& at) const {
  if (errorMm_ <= 0) return {0, 0};
  const double u = std::clamp(at.x() / target_.pitchMm, 0.0, target_.columns - 1.0);
  const double v = std::clamp(at.y() / target_.pitchMm, 0.0, target_.rows - 1.0);
  const int i = std::min(static_cast<int>(u), target_.columns - 2), j = std::min(static_cast<int>(v), target_.rows - 2);
  const double s = u - i, t = v - j;
  const auto shift = [&](int column, int row) -> const Point2& {
    return shifts_[static_cast<std::size_t>(row * target_.columns + column)];
  };
  return (1 - t) * ((1 - s) * shift(i, j) + s * shift(i + 1, j)) +
         t * ((1 - s) * shift(i, j + 1) + s * shift(i + 1, j + 1));
}

double PrintedTarget::clearanceMm(const Point2& place) const {
  const Point2 at = asDrawn(place);
  double clear = distanceToBorder(board_, at);
  if (target_.pattern == TargetPattern::Chessboard) {
    // All lines of the grid, drawn through as if each were a border everywhere.
    const auto toLine = [&](double x) { return std::abs(x - target_.pitchMm * nearest(x / target_.pitchMm)); };
    return std::min(clear, std::min(toLine(at.x()), toLine(at.y())) - 2 * errorMm_);
  }
  clear = std::min(
      clear, std::abs((at - drawn_[static_cast<std::size_t>(nearestCircle(at))]).norm() - target_.diameterMm / 2));
  if (target_.pattern == TargetPattern::DotPlate) {
    clear = std::min(clear, distanceToBorder(frame_.outer, at));
    clear = std::min(clear, distanceToBorder(inFrame_, at));
    const Point2 corner = at - frame_.outer.min;
    clear = std::min(clear, std::abs(corner.x() + corner.y() - frame_.cornerMm) / std::sqrt(2.0));
  }
  return clear;
}

double PrintedTarget::blackOfChessboard(const Point2& place, const Footprint& area) const {
  const double pitch = target_.pitchMm;
  const Point2 at = place - shiftAt(place);
  // Along one axis: which of the two kinds of column the area lies in, from -1 to 1, by the nearest line inside.
  const auto kind = [&](double x, int lines, double a, double b) {
    const int line = std::clamp(nearest(x / pitch), 0, lines - 1);
    const double side = 2 * share(x - line * pitch, a, b) - 1;
    return line % 2 == 0 ? side : -side;
  };
  const double x = kind(at.x(), target_.columns, area.a.x(), area.b.x());
  const double y = kind(at.y(), target_.rows, area.a.y(), area.b.y());
  // The outer squares end one pitch beyond the outer corners; the one beside point 0, up and left of it, is black.
  const TargetRectangle squares = shrunk(board_, pitch);
  return shareOfRectangle(squares, at, area) * (1 + x * y) / 2;
}

double PrintedTarget::blackOfCircles(const Point2& at, const Footprint& area) const {
  const Point2 from = at - drawn_[static_cast<std::size_t>(nearestCircle(at))];
  const double distance = from.norm();
  if (!(distance > 0)) return 1;
  return share(target_.diameterMm / 2 - distance, from / distance, area);
}

double PrintedTarget::blackOfFrame(const Point2& at, const Footprint& area) const {
  const double inOuter = shareOfRectangle(frame_.outer, at, area);
  const double inInner = shareOfRectangle(inFrame_, at, area);
  const Point2 corner = at - frame_.outer.min, diagonal = Point2(1, 1).normalized();
  const double beyondCorner = share(corner.dot(diagonal) - frame_.cornerMm / std::sqrt(2.0), diagonal, area);
  return inOuter * (1 - inInner * beyondCorner);
}

PrintedShares PrintedTarget::shares(const Point2& place, const Footprint& footprint) const {
  const Point2 at = asDrawn(place);
  Footprint area = footprint;
  if (mirrored_) area.a.x() = -area.a.x(), area.b.x() = -area.b.x();
  const double onBoard = shareOfRectangle(board_, at, area);
  double black = 0;
  switch (target_.pattern) {
    case TargetPattern::Chessboard:
      black = blackOfChessboard(at, area);
      break;
    case TargetPattern::DotPlate: {
      const double dots = blackOfCircles(at, area);
      black = dots + (1 - dots) * blackOfFrame(at, area);
      break;
    }
    default:
      black = blackOfCircles(at, area);
  }
  if (target_.lightDots) black = 1 - black;
  return {onBoard * (1 - black), onBoard * black};
}

}  // namespace vignole::simulator
