#include "calibration/detection/target_border.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace vignole {
namespace {

// Shares of the contrast between dots and ground, or bright and dark squares.
constexpr double kLikeGround = 0.3;
constexpr double kLikeDot = 0.6;
constexpr double kAgreeing = 0.75;  // of the places looked at
constexpr std::size_t kLeastPlaces = 3;
// A dot plate's frame, in pitches beyond the outer dots: 0.75 to 1.
constexpr double kBeforeFrame = 0.6, kInFrame = 0.875;
constexpr double kFilledCorner = 0.6;  // of a pitch beyond the corner dot both ways: inside the filled corner
constexpr double kBeyondSquares = 1.25;

/// Mean grey within `radius`, nothing where that leaves the picture.
std::optional<double> greyAt(const ImageView& image, const Point2& at, double radius) {
  const double r = std::max(radius, 0.75);
  const int x0 = static_cast<int>(std::ceil(at.x() - r)), x1 = static_cast<int>(std::floor(at.x() + r));
  const int y0 = static_cast<int>(std::ceil(at.y() - r)), y1 = static_cast<int>(std::floor(at.y() + r));
  if (!at.allFinite() || x0 < 0 || y0 < 0 || x1 >= image.width || y1 >= image.height) return std::nullopt;
  double sum = 0, n = 0;
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x)
      if (std::hypot(x - at.x(), y - at.y()) <= r) {
        sum += image.row(y)[x];
        n += 1;
      }
  return n > 0 ? std::optional<double>(sum / n) : std::nullopt;
}

/// The outer points of one line of the lattice and where it goes on.
struct LineEnd {
  const PatternPoint* outer = nullptr;
  Point2 step{0, 0}, change{0, 0};  // px a step outwards; its change with every step
  [[nodiscard]] Point2 beyond(double steps) const {
    return outer->px + steps * step + 0.5 * steps * (steps + 1) * change;
  }
};

/// Ends of all lines that reach the side, by their place along it. `direction`: outwards.
std::map<int, LineEnd> lineEnds(const FittedLattice& lattice, const LatticePlace& direction, int stride) {
  std::map<int, std::map<int, const PatternPoint*>> lines;  // by place along the side, then outwards
  int border = 0;
  bool first = true;
  for (const auto& [place, point] : lattice) {
    const int outwards = place.first * direction.first + place.second * direction.second;
    const int along = place.first * std::abs(direction.second) + place.second * std::abs(direction.first);
    lines[along][outwards] = &point;
    border = first ? outwards : std::max(border, outwards);
    first = false;
  }
  std::map<int, LineEnd> ends;
  for (const auto& [along, points] : lines) {
    const auto& [last, outer] = *points.rbegin();
    const auto second = points.find(last - stride), third = points.find(last - 2 * stride);
    if (last <= border - stride || second == points.end()) continue;
    LineEnd end;
    end.outer = outer;
    end.step = outer->px - second->second->px;
    if (third != points.end()) end.change = end.step - (second->second->px - third->second->px);
    ends[along] = end;
  }
  return ends;
}

bool likeGround(double grey, const PatternPoint& point) {
  return std::abs(grey - point.groundDn) < kLikeGround * std::abs(point.contrastDn);
}
bool likeDot(double grey, const PatternPoint& point) {
  return (grey - point.groundDn) * point.contrastDn > kLikeDot * point.contrastDn * point.contrastDn;
}

struct Votes {
  std::size_t agreeing = 0, all = 0;
  void add(bool agrees) {
    ++all;
    agreeing += agrees ? 1 : 0;
  }
  [[nodiscard]] bool carried() const {
    return all >= kLeastPlaces && static_cast<double>(agreeing) >= kAgreeing * static_cast<double>(all);
  }
};

/// Where the next dots would be there is ground. Between the near edge of such a dot and its middle, so that a narrow
/// margin will do.
bool endOfDots(const ImageView& image, const std::map<int, LineEnd>& ends) {
  Votes votes;
  for (const auto& [along, end] : ends) {
    const double radius = end.step.norm() / (end.outer->ellipse.toUnitCircle * end.step).norm();
    const double share = radius / end.step.norm();
    if (const auto grey = greyAt(image, end.beyond(1 - 0.5 * share), 0.2 * radius))
      votes.add(likeGround(*grey, *end.outer));
  }
  return votes.carried();
}

/// Midways between two lines, `steps` beyond them.
std::optional<double> greyBetween(const ImageView& image, const LineEnd& a, const LineEnd& b, double steps) {
  const Point2 at = 0.5 * (a.beyond(steps) + b.beyond(steps));
  return greyAt(image, at, 0.06 * a.step.norm());
}

template <typename Visit>
void forNeighbours(const std::map<int, LineEnd>& ends, const Visit& visit) {
  for (const auto& [along, end] : ends)
    if (const auto next = ends.find(along + 1); next != ends.end()) visit(end, next->second);
}

/// Beyond a bright outer square there would be a dark one.
bool endOfSquares(const ImageView& image, const std::map<int, LineEnd>& ends) {
  Votes votes;
  forNeighbours(ends, [&](const LineEnd& a, const LineEnd& b) {
    const auto square = greyBetween(image, a, b, 0.5), beyond = greyBetween(image, a, b, kBeyondSquares);
    const double middle = 0.5 * (a.outer->groundDn + b.outer->groundDn);
    const double clear = 0.2 * a.outer->contrastDn;
    if (square && beyond && *square > middle + clear) votes.add(*beyond > middle + clear);
  });
  // Only every second place has a say.
  return votes.all >= 2 && static_cast<double>(votes.agreeing) >= kAgreeing * static_cast<double>(votes.all);
}

bool frameBeyond(const ImageView& image, const std::map<int, LineEnd>& ends) {
  Votes votes;
  forNeighbours(ends, [&](const LineEnd& a, const LineEnd& b) {
    const auto before = greyBetween(image, a, b, kBeforeFrame), inside = greyBetween(image, a, b, kInFrame);
    if (before && inside) votes.add(likeGround(*before, *a.outer) && likeDot(*inside, *a.outer));
  });
  return votes.carried();
}

/// The next points could not have been found.
bool mostlyOutside(const ImageView& image, const std::map<int, LineEnd>& ends) {
  std::size_t outside = 0;
  for (const auto& [along, end] : ends) {
    const double reach = 0.35 * end.step.norm();
    const Point2 next = end.beyond(1);
    outside += next.x() < reach || next.y() < reach || next.x() > image.width - 1 - reach ||
                       next.y() > image.height - 1 - reach
                   ? 1
                   : 0;
  }
  return 2 * outside > ends.size();
}

}  // namespace

BorderSides borderSides(const ImageView& image, const FittedLattice& alongRows, const PlanarTarget& target) {
  const int stride = target.pattern == TargetPattern::AsymmetricCircles ? 2 : 1;
  const auto beyond = [&](const LatticePlace& direction) {
    const auto ends = lineEnds(alongRows, direction, stride);
    const bool margin = target.pattern == TargetPattern::Chessboard ? endOfSquares(image, ends)
                        : target.pattern == TargetPattern::DotPlate ? frameBeyond(image, ends)
                                                                    : endOfDots(image, ends);
    if (margin) return Beyond::Margin;
    return mostlyOutside(image, ends) ? Beyond::Outside : Beyond::Unknown;
  };
  return {beyond({-1, 0}), beyond({1, 0}), beyond({0, -1}), beyond({0, 1})};
}

FrameCorner frameCorner(const ImageView& image, const FittedLattice& alongRows, int sideX, int sideY) {
  const PlaceBox box = boxOf(placesOf(alongRows));
  const LatticePlace corner(sideX < 0 ? box.x0 : box.x1, sideY < 0 ? box.y0 : box.y1);
  const auto at = [&](int stepsX, int stepsY) -> const PatternPoint* {
    const auto found = alongRows.find({corner.first - sideX * stepsX, corner.second - sideY * stepsY});
    return found == alongRows.end() ? nullptr : &found->second;
  };
  // From the dot nearest to the corner with its neighbours inwards, be it the corner dot itself or one beside it.
  for (const auto& [x, y] : {LatticePlace(0, 0), LatticePlace(1, 0), LatticePlace(0, 1), LatticePlace(1, 1)}) {
    const PatternPoint *here = at(x, y), *inX = at(x + 1, y), *inY = at(x, y + 1);
    if (here == nullptr || inX == nullptr || inY == nullptr) continue;
    const Point2 stepX = here->px - inX->px, stepY = here->px - inY->px;
    const Point2 place = here->px + (kFilledCorner + x) * stepX + (kFilledCorner + y) * stepY;
    const auto grey = greyAt(image, place, 0.04 * std::min(stepX.norm(), stepY.norm()));
    if (!grey) return FrameCorner::Unseen;
    if (likeDot(*grey, *here)) return FrameCorner::Filled;
    return likeGround(*grey, *here) ? FrameCorner::Open : FrameCorner::Unseen;
  }
  return FrameCorner::Unseen;
}

}  // namespace vignole
