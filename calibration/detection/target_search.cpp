#include "calibration/detection/target_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "calibration/detection/corner_candidates.h"
#include "calibration/detection/dot_candidates.h"

namespace vignole {
namespace {

constexpr double kStartPixels = 2.5e6;   // the search begins at the first level that has no more
constexpr int kLeastSide = 100;          // px, of the coarsest level
constexpr std::size_t kLeastPoints = 9;  // of a lattice
constexpr double kLeastShare = 0.25;     // of the target's points
constexpr double kEnoughShare = 0.6;     // of the target's points
constexpr std::size_t kMostSeeds = 6000;
constexpr std::size_t kFirstFits = 12, kLeastOfFirst = 4;
constexpr int kMostRounds = 12;     // of completing a lattice
constexpr double kRowShare = 0.15;  // fewer points than that in an outer row are strays

std::size_t countOf(const PlanarTarget& target) {
  return static_cast<std::size_t>(target.columns) * static_cast<std::size_t>(target.rows);
}

std::size_t leastPoints(const PlanarTarget& target) {
  const auto share = static_cast<std::size_t>(kLeastShare * static_cast<double>(countOf(target)));
  return std::min(std::max(std::size_t{6}, std::max(share, kLeastPoints)), countOf(target));
}

/// The largest lattice among the candidates.
ByPlace<std::size_t> largestLattice(const PatternPoints& points, std::size_t enough) {
  const PointIndex index(points.places());
  std::vector<bool> done(points.places().size(), false);
  ByPlace<std::size_t> best;
  const auto mayBe = [&points](std::size_t a, std::size_t b) { return points.mayBeNeighbours(a, b); };
  for (std::size_t i = 0; i < std::min(done.size(), kMostSeeds); ++i) {
    if (done[i]) continue;
    const auto seed = points.seedAt(i, index);
    if (!seed) continue;
    auto lattice = growLattice(points.places(), index, *seed, mayBe);
    if (lattice.size() >= 6)
      for (const auto& [place, candidate] : lattice) done[candidate] = true;
    if (lattice.size() > best.size()) best = std::move(lattice);
    if (best.size() >= enough) break;
  }
  return best;
}

/// Steps of a point's place as its neighbours have them; of a lone point: none.
std::optional<LatticeSteps> stepsAt(const ByPlace<Point2>& lattice, const LatticePlace& place) {
  const auto prediction = predicted(lattice, place);
  if (prediction) return prediction->steps;
  return std::nullopt;
}

/// Empty where of the first points most turn out to be none: what else stands in rows shall not cost much.
FittedLattice fitted(const PatternPoints& points, const ByPlace<std::size_t>& lattice) {
  ByPlace<Point2> coarse;
  for (const auto& [place, candidate] : lattice) coarse[place] = points.places()[candidate];
  dropUneven(coarse);
  std::vector<LatticePlace> order;
  for (const auto& [place, px] : coarse) order.push_back(place);
  // Not row by row, so that the first ones lie all over the lattice.
  std::vector<LatticePlace> spread;
  constexpr std::size_t kStride = 7;
  for (std::size_t first = 0; first < kStride; ++first)
    for (std::size_t i = first; i < order.size(); i += kStride) spread.push_back(order[i]);
  FittedLattice fine;
  for (std::size_t i = 0; i < spread.size(); ++i) {
    if (i == kFirstFits && fine.size() < kLeastOfFirst) return {};
    if (const auto steps = stepsAt(coarse, spread[i]))
      if (const auto point = points.fit(lattice.at(spread[i]), *steps)) fine[spread[i]] = *point;
  }
  return fine;
}

/// Points that were not found before, inside and around.
void complete(const PatternPoints& points, FittedLattice& lattice) {
  std::set<LatticePlace> tried;
  for (int round = 0; round < kMostRounds; ++round) {
    const ByPlace<Point2> pixels = pixelsOf(lattice);
    FittedLattice more;
    for (const LatticePlace& place : openPlaces(pixels)) {
      if (!tried.insert(place).second) continue;
      const auto prediction = predicted(pixels, place);
      if (!prediction) continue;
      const LatticePlace& from = prediction->neighbour;
      const bool odd = (place.first + place.second - from.first - from.second) % 2 != 0;
      const auto point = points.fitAt(prediction->px, prediction->steps, lattice.at(from), odd);
      if (point) more[place] = *point;
    }
    if (more.empty()) return;
    lattice.merge(more);
  }
}

/// Outer rows of very few points, and what does not lie evenly, are something else.
void dropStrays(FittedLattice& lattice) {
  ByPlace<Point2> pixels = pixelsOf(lattice);
  dropUneven(pixels);
  std::erase_if(lattice, [&pixels](const auto& item) { return !pixels.contains(item.first); });
}

class Search {
 public:
  Search(const ImageView& picture, const PlanarTarget& target) : picture_(picture), target_(target) {}

  FittedLattice run() {
    std::vector<PictureLevel> levels{PictureLevel(picture_)};
    while (std::min(levels.back().view().width, levels.back().view().height) / 2 >= kLeastSide)
      levels.push_back(levels.back().half());
    std::size_t start = 0;
    while (start + 1 < levels.size() &&
           static_cast<double>(levels[start].view().width) * levels[start].view().height > kStartPixels)
      ++start;
    for (std::size_t i = start; i < levels.size() && !found(); ++i) lookAt(levels[i]);
    for (std::size_t i = start; i-- > 0 && !found();) lookAt(levels[i]);
    return std::move(best_);
  }

 private:
  void lookAt(const PictureLevel& level) {
    failedCoarse_ = 0;
    if (target_.pattern == TargetPattern::Chessboard) {
      std::vector<Corner> candidates = cornerCandidates(level.view());
      for (Corner& corner : candidates) corner.px = level.inPicture(corner.px);
      judge(*corners(picture_, std::move(candidates)));
      return;
    }
    lookForDots(level, target_.lightDots);
    // A target that does not say how its dots are may have them light.
    if (!found() && !target_.lightDots) lookForDots(level, true);
  }

  void lookForDots(const PictureLevel& level, bool light) {
    failedCoarse_ = 0;
    const ImageView view = level.view();
    const int side = std::min(view.width, view.height);
    std::vector<int> windows;
    for (double half = 8; half < side / 2.5; half *= 2.2) windows.push_back(static_cast<int>(half));
    // From the middle sizes outwards.
    const auto middle = static_cast<int>(windows.size() / 2);
    std::stable_sort(windows.begin(), windows.end(), [&](int a, int b) {
      const double at = windows.empty() ? 0 : 8 * std::pow(2.2, middle);
      return std::abs(std::log(a / at)) < std::abs(std::log(b / at));
    });
    std::vector<DotEllipse> all;
    for (const int half : windows) {
      std::vector<DotEllipse> found = dotCandidates(view, light, half);
      for (DotEllipse& ellipse : found) ellipse = inPicture(ellipse, level);
      addNew(found, all);
      judge(*dots(picture_, all));
      if (whole_) return;
    }
  }

  void judge(const PatternPoints& points) {
    const ByPlace<std::size_t> coarse = largestLattice(points, countOf(target_));
    if (coarse.size() < leastPoints(target_) || coarse.size() <= bestCoarse_ || coarse.size() <= failedCoarse_) return;
    failedCoarse_ = coarse.size();
    FittedLattice lattice = fitted(points, coarse);
    complete(points, lattice);
    dropStrays(lattice);
    if (lattice.size() < leastPoints(target_) || lattice.size() <= best_.size()) return;
    bestCoarse_ = coarse.size();
    best_ = std::move(lattice);
    whole_ = best_.size() >= countOf(target_);
  }

  /// So much of the target that it would not be found again, better, at another level.
  [[nodiscard]] bool found() const {
    return static_cast<double>(best_.size()) >= kEnoughShare * static_cast<double>(countOf(target_));
  }

  ImageView picture_;
  const PlanarTarget& target_;
  FittedLattice best_;
  std::size_t bestCoarse_ = 0;    // points of the lattice that became best_, before they were fitted
  std::size_t failedCoarse_ = 0;  // of the largest that was tried at this level
  bool whole_ = false;
};

}  // namespace

FittedLattice searchLattice(const ImageView& picture, const PlanarTarget& target) {
  return Search(picture, target).run();
}

std::vector<LatticePlace> placesOf(const FittedLattice& lattice) {
  std::vector<LatticePlace> places;
  places.reserve(lattice.size());
  for (const auto& [place, point] : lattice) places.push_back(place);
  return places;
}

ByPlace<Point2> pixelsOf(const FittedLattice& lattice) {
  ByPlace<Point2> pixels;
  for (const auto& [place, point] : lattice) pixels[place] = point.px;
  return pixels;
}

}  // namespace vignole
