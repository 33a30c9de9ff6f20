#include "calibration/detection/target_finder.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <opencv2/core.hpp>
#include <utility>

#include "calibration/detection/target_border.h"
#include "calibration/detection/target_search.h"

namespace vignole {
namespace {

constexpr double kClippedPoint = 0.15;  // of a point's pixels: it lies in clipped light
constexpr double kMostClipped = 0.3;    // of the points
constexpr double kStrayShare = 0.15;    // of a row's points: fewer are strays
constexpr double kMostU = 1;            // px; what is known no better helps nobody
constexpr std::size_t kLeastLeft = 6;

template <typename... Values>
std::string text(const char* format, Values... values) {
  std::string buffer(320, '\0');
  const int length = std::snprintf(buffer.data(), buffer.size(), format, values...);
  buffer.resize(static_cast<std::size_t>(std::clamp(length, 0, static_cast<int>(buffer.size()) - 1)));
  return buffer;
}

double medianOf(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

const char* nameOf(TargetPattern pattern) {
  switch (pattern) {
    case TargetPattern::Chessboard:
      return "chessboard";
    case TargetPattern::Circles:
      return "grid of circles";
    case TargetPattern::AsymmetricCircles:
      return "asymmetric grid of circles";
    case TargetPattern::DotPlate:
      return "dot plate";
  }
  return "target";
}
const char* pointsOf(TargetPattern pattern) {
  return pattern == TargetPattern::Chessboard ? "inner corners" : "circles";
}

std::string notFound(const ImageView& image, const PlanarTarget& target) {
  std::size_t dark = 0, clipped = 0, all = 0;
  for (int y = 0; y < image.height; y += 2)
    for (int x = 0; x < image.width; x += 2) {
      dark += image.row(y)[x] < 12 ? 1 : 0;
      clipped += image.row(y)[x] >= 254 ? 1 : 0;
      ++all;
    }
  const auto share = [all](std::size_t part) { return 100.0 * static_cast<double>(part) / static_cast<double>(all); };
  std::string what = text("not found: no %s of %d x %d %s; ", nameOf(target.pattern), target.columns, target.rows,
                          pointsOf(target.pattern));
  if (share(clipped) > 40)
    return what + text("%.0f %% of the picture is saturated: shorten the exposure", share(clipped));
  if (share(dark) > 90) return what + text("%.0f %% of the picture is black: lengthen the exposure", share(dark));
  return what + "show all of it, sharp, evenly lit, and check the pattern and size stated";
}

struct Steps {
  std::vector<double> shortest, obliqueDeg;
};

Steps stepsOf(const FittedLattice& lattice, TargetPattern pattern) {
  Steps all;
  const LatticePlace stepU = alongRows({1, 0}, pattern), stepV = alongRows({0, 1}, pattern);
  for (const auto& [place, point] : lattice) {
    const auto u = lattice.find({place.first + stepU.first, place.second + stepU.second});
    const auto v = lattice.find({place.first + stepV.first, place.second + stepV.second});
    if (u == lattice.end() || v == lattice.end()) continue;
    Eigen::Matrix2d j;
    j << u->second.px - point.px, v->second.px - point.px;
    all.shortest.push_back(std::min(j.col(0).norm(), j.col(1).norm()));
    // Ratio of the singular values of the map from the target to the picture.
    const double sum = j.squaredNorm(), det = std::abs(j.determinant());
    const double root = std::sqrt(std::max(0.0, sum * sum - 4 * det * det));
    const double ratio = std::sqrt(std::max(0.0, (sum - root) / (sum + root)));
    all.obliqueDeg.push_back(std::acos(std::clamp(ratio, 0.0, 1.0)) * 180 / std::numbers::pi);
  }
  return all;
}

void measure(const FittedLattice& lattice, const PlanarTarget& target, TargetView& view) {
  std::vector<double> blurs;
  std::size_t clipped = 0;
  for (const auto& [place, point] : lattice) {
    blurs.push_back(point.blurPx);
    clipped += point.saturatedShare > kClippedPoint ? 1 : 0;
  }
  view.blurPx = medianOf(std::move(blurs));
  view.saturatedShare = static_cast<double>(clipped) / static_cast<double>(lattice.size());
  Steps steps = stepsOf(lattice, target.pattern);
  view.pitchPx = medianOf(std::move(steps.shortest));
  view.obliqueDeg = medianOf(std::move(steps.obliqueDeg));
}

std::string poorQuality(const TargetView& view, const TargetFinderSettings& settings) {
  if (view.pitchPx < settings.minPointDistancePx)
    return text("too small: neighbouring points are %.1f px apart, at least %.1f are needed; move the target closer",
                view.pitchPx, settings.minPointDistancePx);
  if (view.saturatedShare > kMostClipped)
    return text("saturated: %.0f %% of the points lie in clipped light; shorten the exposure or dim the light",
                100 * view.saturatedShare);
  if (view.blurPx > settings.maxBlurPx)
    return text(
        "blurred: edges are spread by %.1f px (standard deviation), at most %.1f; focus, stop down or hold still",
        view.blurPx, settings.maxBlurPx);
  if (view.obliqueDeg > settings.maxObliqueDeg)
    return text("too oblique: seen at %.0f degrees, at most %.0f; turn the target towards the camera", view.obliqueDeg,
                settings.maxObliqueDeg);
  return {};
}

/// Outer rows and columns of very few points, as long as the lattice is too large for the target.
void trim(FittedLattice& lattice, const PlanarTarget& target) {
  while (!lattice.empty() && placings(placesOf(lattice), target, false).empty()) {
    std::map<int, std::size_t> columns, rows;
    for (const auto& [place, point] : lattice) {
      const auto [x, y] = place;
      ++columns[x];
      ++rows[y];
    }
    const auto most = [](const std::map<int, std::size_t>& lines) {
      std::size_t count = 0;
      for (const auto& [line, n] : lines) count = std::max(count, n);
      return static_cast<double>(count);
    };
    struct Line {
      bool column;
      int at;
      double share;
    };
    const double mostInColumn = most(columns), mostInRow = most(rows);
    std::vector<Line> outer;
    for (const auto* line : {&*columns.begin(), &*columns.rbegin()})
      outer.push_back({true, line->first, (static_cast<double>(line->second) - 1) / mostInColumn});
    for (const auto* line : {&*rows.begin(), &*rows.rbegin()})
      outer.push_back({false, line->first, (static_cast<double>(line->second) - 1) / mostInRow});
    const auto thinnest =
        *std::min_element(outer.begin(), outer.end(), [](const Line& a, const Line& b) { return a.share < b.share; });
    if (thinnest.share > kStrayShare) return;
    std::erase_if(lattice, [&](const auto& item) {
      const auto [x, y] = item.first;
      return (thinnest.column ? x : y) == thinnest.at;
    });
  }
}

/// Direction in which the target's columns run in the picture.
Point2 alongX(const FittedLattice& lattice, const Placing& placing) {
  Point2 centre(0, 0), sum(0, 0);
  double middle = 0;
  const auto n = static_cast<double>(lattice.size());
  for (const auto& [place, point] : lattice) {
    centre += point.px / n;
    middle += placed(place, placing).first / n;
  }
  for (const auto& [place, point] : lattice) sum += (placed(place, placing).first - middle) * (point.px - centre);
  return sum.normalized();
}

/// Whether the square before point 0, to its left and above, is dark.
bool darkBefore(const FittedLattice& lattice, const Placing& placing) {
  int votes = 0;
  const Point2 x = alongX(lattice, placing), y(-x.y(), x.x());
  for (const auto& [place, point] : lattice) {
    const auto [column, row] = placed(place, placing);
    const Point2 before = -(x + y);
    double ahead = std::fmod(std::atan2(before.y(), before.x()) - point.corner.angle1, std::numbers::pi);
    if (ahead < 0) ahead += std::numbers::pi;
    double between = std::fmod(point.corner.angle2 - point.corner.angle1, std::numbers::pi);
    if (between < 0) between += std::numbers::pi;
    const bool dark = (ahead < between) != point.corner.brightBetween;
    votes += dark == ((column + row) % 2 == 0) ? 1 : -1;
  }
  return votes > 0;
}

/// Of the turns that the pattern allows: the one that its squares' colours ask for, then the one most upright.
Placing chosen(const FittedLattice& lattice, std::vector<Placing> all, const PlanarTarget& target) {
  if (target.pattern == TargetPattern::Chessboard &&
      std::any_of(all.begin(), all.end(), [&](const Placing& p) { return darkBefore(lattice, p); }))
    std::erase_if(all, [&](const Placing& p) { return !darkBefore(lattice, p); });
  return *std::max_element(all.begin(), all.end(), [&](const Placing& a, const Placing& b) {
    return alongX(lattice, a).x() < alongX(lattice, b).x();
  });
}

std::string wrongSize(const FittedLattice& lattice, const PlanarTarget& target) {
  const auto [columns, rows] = sizeOf(placesOf(lattice), target);
  const bool part = columns <= target.columns && rows <= target.rows;
  return text("%s: found %d x %d %s, expected %d x %d; %s", part ? "only part of it, or another size" : "wrong size",
              columns, rows, pointsOf(target.pattern), target.columns, target.rows,
              part ? "show the whole target, or state its size" : "state the target's size");
}

void label(const FittedLattice& lattice, const Placing& placing, const PlanarTarget& target, TargetView& view) {
  for (const auto& [place, point] : lattice)
    if (point.saturatedShare <= kClippedPoint && point.uPx < kMostU)
      view.points.push_back({indexOf(placed(place, placing), target), point.px, point.uPx});
  std::sort(view.points.begin(), view.points.end(),
            [](const FoundPoint& a, const FoundPoint& b) { return a.index < b.index; });
  view.partial = view.points.size() < static_cast<std::size_t>(target.columns) * static_cast<std::size_t>(target.rows);
}

/// Turns that leave more than one place open, or none.
bool decided(const std::vector<Placing>& all) {
  for (std::size_t i = 1; i < all.size(); ++i)
    if (all[i].quarterTurns == all[i - 1].quarterTurns) return false;
  return !all.empty();
}

/// Leaves out placings that would have points of the target beyond a side where the picture shows no place for them.
void keepWithinBorders(const FittedLattice& lattice, const PlanarTarget& target, const BorderSides& sides,
                       std::vector<Placing>& all) {
  const PlaceBox box = boxOf(placesOf(lattice));
  std::erase_if(all, [&](const Placing& placing) {
    const LatticePlace a = placed({box.x0, box.y0}, placing), b = placed({box.x1, box.y1}, placing);
    const auto inner = [&](const LatticePlace& outwards) {
      // The lattice's outer line on that side, in the target.
      const LatticePlace there = placed(outwards, {placing.quarterTurns, placing.mirrored, 0, 0});
      if (there.first < 0) return std::min(a.first, b.first) > 0;
      if (there.first > 0) return std::max(a.first, b.first) < widthOf(target) - 1;
      if (there.second < 0) return std::min(a.second, b.second) > 0;
      return std::max(a.second, b.second) < target.rows - 1;
    };
    return (sides.left != Beyond::Outside && inner({-1, 0})) || (sides.right != Beyond::Outside && inner({1, 0})) ||
           (sides.top != Beyond::Outside && inner({0, -1})) || (sides.bottom != Beyond::Outside && inner({0, 1}));
  });
}

/// A plain grid of circles has none.
bool frameSeen(const BorderSides& sides) {
  int seen = 0;
  for (const Beyond side : {sides.left, sides.right, sides.top, sides.bottom}) seen += side == Beyond::Margin ? 1 : 0;
  return seen >= 2;
}

/// Whether the filled corner of the frame is where the placing has point 0. An unseen corner speaks neither for nor
/// against; three open ones leave only the fourth.
bool frameAgrees(const ImageView& image, const FittedLattice& lattice, const PlanarTarget& target,
                 const Placing& placing) {
  const PlaceBox box = boxOf(placesOf(lattice));
  std::size_t open = 0;
  bool filled = false;
  for (const int sideX : {-1, 1})
    for (const int sideY : {-1, 1}) {
      const LatticePlace corner = placed({sideX < 0 ? box.x0 : box.x1, sideY < 0 ? box.y0 : box.y1}, placing);
      const bool first = corner == LatticePlace(0, 0);
      const bool ofTarget = (corner.first == 0 || corner.first == target.columns - 1) &&
                            (corner.second == 0 || corner.second == target.rows - 1);
      const FrameCorner seen = ofTarget ? frameCorner(image, lattice, sideX, sideY) : FrameCorner::Unseen;
      if (seen == FrameCorner::Filled && !first) return false;
      if (seen == FrameCorner::Open && first) return false;
      open += seen == FrameCorner::Open ? 1 : 0;
      filled = filled || seen == FrameCorner::Filled;
    }
  return filled || open == 3;
}

/// The placings that are left, or the reason why there are none.
std::vector<Placing> placingsOf(const ImageView& image, const FittedLattice& lattice, const PlanarTarget& target,
                                std::string& refusal) {
  constexpr const char* kMirrored =
      "mirrored: the target is seen in a mirror, or the picture is flipped; take it directly";
  const std::vector<LatticePlace> places = placesOf(lattice);
  const BorderSides sides = borderSides(image, lattice, target);
  const auto allOf = [&](bool mirrored) {
    std::vector<Placing> all = placings(places, target, mirrored);
    if (!decided(all)) keepWithinBorders(lattice, target, sides, all);
    return all;
  };
  std::vector<Placing> all = allOf(false);
  if (target.pattern == TargetPattern::DotPlate && !all.empty() && !frameSeen(sides)) {
    refusal = "no frame is seen around the dots; show it on two sides at least, or state the pattern circles";
    return {};
  }
  if (target.pattern == TargetPattern::DotPlate) {
    const auto disagrees = [&](const Placing& p) { return !frameAgrees(image, lattice, target, p); };
    const bool any = !all.empty();
    std::erase_if(all, disagrees);
    if (all.empty() && any) {
      std::vector<Placing> mirrored = allOf(true);
      std::erase_if(mirrored, disagrees);
      refusal = mirrored.empty() ? "the frame's filled corner is not seen, so that it cannot be told which dot is "
                                   "which; show it, or state the pattern circles"
                                 : kMirrored;
      return {};
    }
  }
  if (decided(all)) return all;
  if (all.empty() && !placings(places, target, true).empty() && placings(places, target, false).empty())
    refusal = kMirrored;
  else
    refusal = wrongSize(lattice, target);
  return {};
}

void find(const ImageView& image, const PlanarTarget& target, const TargetFinderSettings& settings, TargetView& view) {
  FittedLattice lattice;
  for (const auto& [place, point] : searchLattice(image, target)) lattice[alongRows(place, target.pattern)] = point;
  if (lattice.empty()) {
    view.refusal = notFound(image, target);
    return;
  }
  measure(lattice, target, view);
  view.refusal = poorQuality(view, settings);
  if (!view.usable()) return;
  trim(lattice, target);
  const std::vector<Placing> all = placingsOf(image, lattice, target, view.refusal);
  if (!view.usable()) return;
  label(lattice, chosen(lattice, all, target), target, view);
  if (view.points.size() < kLeastLeft) {
    view.points.clear();
    view.refusal = notFound(image, target);
  }
}

}  // namespace

TargetView findTarget(const ImageView& image, const PlanarTarget& target, const TargetFinderSettings& settings) {
  TargetView view;
  view.widthPx = image.width;
  view.heightPx = image.height;
  if (image.empty() || std::min(image.width, image.height) < 32) {
    view.refusal = "the picture is smaller than 32 x 32 px";
    return view;
  }
  try {
    find(image, target, settings, view);
  } catch (const cv::Exception& exception) {
    view.refusal = "the picture cannot be searched: " + exception.err;
  }
  return view;
}

}  // namespace vignole
