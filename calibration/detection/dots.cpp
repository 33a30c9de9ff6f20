#include <algorithm>
#include <cmath>
#include <numbers>

#include "calibration/detection/pattern_points.h"

namespace vignole {
namespace {

// In a frame in which the dot is the unit circle its neighbours stand in a square lattice.
constexpr double kLeastDistance = 2.02, kMostDistance = 9;  // of neighbours, in radii
constexpr double kSquareness = 0.3;                         // of that distance
constexpr double kMostAreaRatio = 2.2;                      // of neighbours
// What the model leaves, in shares of the contrast: a circle leaves 1 to 3 %, a square 10 and more.
constexpr double kMostMisfit = 0.085;
constexpr double kNoiseSlack = 1.5;  // of the noise's variance, known from some hundred pixels
constexpr double kLeastContrastDn = 4;
constexpr double kRoomShare = 0.6;  // of the gap between two dots

bool similarArea(double a, double b) { return a < kMostAreaRatio * b && b < kMostAreaRatio * a; }

class Dots : public PatternPoints {
 public:
  Dots(const ImageView& picture, std::vector<DotEllipse> candidates)
      : picture_(picture), candidates_(std::move(candidates)) {
    for (const DotEllipse& ellipse : candidates_) {
      places_.push_back(ellipse.centrePx);
      areas_.push_back(ellipse.areaPx());
    }
  }

  [[nodiscard]] std::span<const Point2> places() const override { return places_; }

  [[nodiscard]] std::optional<LatticeSeed> seedAt(std::size_t candidate, const PointIndex& index) const override {
    const DotEllipse& own = candidates_[candidate];
    struct Neighbour {
      std::size_t index;
      Point2 normalised;
      double distance;
    };
    std::vector<Neighbour> about;
    for (const std::size_t i : index.within(own.centrePx, kMostDistance * own.semiAxesPx().x())) {
      if (i == candidate || !similarArea(areas_[i], areas_[candidate])) continue;
      const Point2 normalised = own.toUnitCircle * (places_[i] - own.centrePx);
      const double distance = normalised.norm();
      if (distance > kLeastDistance && distance < kMostDistance) about.push_back({i, normalised, distance});
    }
    std::stable_sort(about.begin(), about.end(),
                     [](const Neighbour& a, const Neighbour& b) { return a.distance < b.distance; });
    if (about.empty()) return std::nullopt;
    const Neighbour& first = about.front();
    const Point2 wanted(-first.normalised.y(), first.normalised.x());
    for (const Neighbour& other : about) {
      if (other.distance > (1 + kSquareness) * first.distance) break;
      for (const double sign : {1.0, -1.0})
        if ((sign * other.normalised - wanted).norm() < kSquareness * first.distance)
          return turnedRight(candidate, places_[first.index] - own.centrePx,
                             sign * (places_[other.index] - own.centrePx));
    }
    return std::nullopt;
  }

  [[nodiscard]] bool mayBeNeighbours(std::size_t a, std::size_t b) const override {
    return similarArea(areas_[a], areas_[b]);
  }

  [[nodiscard]] std::optional<PatternPoint> fit(std::size_t candidate, const LatticeSteps& steps) const override {
    return fitted(candidates_[candidate], steps);
  }

  [[nodiscard]] std::optional<PatternPoint> fitAt(const Point2& place, const LatticeSteps& steps,
                                                  const PatternPoint& neighbour, bool) const override {
    DotEllipse start = neighbour.ellipse;
    start.centrePx = place;
    auto point = fitted(start, steps);
    if (!point || point->contrastDn * neighbour.contrastDn < 0 ||
        std::abs(point->contrastDn) < 0.35 * std::abs(neighbour.contrastDn) ||
        !similarArea(point->ellipse.areaPx(), start.areaPx()))
      return std::nullopt;
    if ((start.toUnitCircle * (point->px - place)).norm() > 0.7) return std::nullopt;
    return point;
  }

 private:
  static LatticeSeed turnedRight(std::size_t candidate, const Point2& u, const Point2& v) {
    const bool right = u.x() * v.y() - u.y() * v.x() > 0;
    return {candidate, right ? LatticeSteps{u, v} : LatticeSteps{v, u}};
  }

  [[nodiscard]] std::optional<PatternPoint> fitted(const DotEllipse& start, const LatticeSteps& steps) const {
    const double distance = std::min((start.toUnitCircle * steps.u).norm(), (start.toUnitCircle * steps.v).norm());
    const double room = 1 + kRoomShare * std::max(distance - 2, 0.1);
    const auto fit = fitCircle(picture_, start, room);
    if (!fit) return std::nullopt;
    PatternPoint point;
    point.px = fit->ellipse.centrePx;
    point.uPx = fit->uPx;
    point.blurPx = fit->blurPx;
    point.contrastDn = fit->contrastDn;
    point.groundDn = fit->groundDn;
    point.noiseDn = fit->noiseDn;
    point.rmsDn = fit->rmsDn;
    point.saturatedShare = fit->saturatedShare;
    point.ellipse = fit->ellipse;
    const double contrast = std::abs(fit->contrastDn);
    if (contrast < std::max(kLeastContrastDn, 2 * fit->noiseDn)) return std::nullopt;
    // Noise alone is no misfit: it is what half of the pixels show.
    const double misfit = std::sqrt(std::max(0.0, fit->rmsDn * fit->rmsDn - kNoiseSlack * fit->noiseDn * fit->noiseDn));
    if (misfit > kMostMisfit * contrast) return std::nullopt;
    return point;
  }

  ImageView picture_;
  std::vector<DotEllipse> candidates_;
  std::vector<Point2> places_;
  std::vector<double> areas_;
};

}  // namespace

std::unique_ptr<PatternPoints> dots(const ImageView& picture, std::vector<DotEllipse> candidates) {
  return std::make_unique<Dots>(picture, std::move(candidates));
}

DotEllipse inPicture(const DotEllipse& ellipse, const PictureLevel& level) {
  return {level.inPicture(ellipse.centrePx), ellipse.toUnitCircle / level.factor()};
}

}  // namespace vignole
