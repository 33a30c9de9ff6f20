#include <algorithm>
#include <cmath>
#include <numbers>

#include "calibration/detection/pattern_points.h"

namespace vignole {
namespace {

constexpr double kCone = 0.22;       // rad: a neighbour lies ahead along an edge
constexpr double kMostTurn = 0.5;    // rad, of the squares' diagonals from one corner to the next
constexpr double kRoomShare = 0.7;   // of the distance of the next edges
constexpr double kMostMisfit = 0.1;  // of the contrast, beside the noise
constexpr double kLeastEvenness = 0.5;
constexpr double kNoiseSlack = 1.5;  // of the noise's variance, known from some hundred pixels
constexpr double kLeastContrastDn = 4;
constexpr double kLeastAngle = 0.3;  // rad, between the edges

/// Angle between two undirected lines, 0 .. pi/2.
double between(double a, double b) {
  const double turn = std::remainder(a - b, std::numbers::pi);
  return std::abs(turn);
}

/// Direction of the bright squares' diagonal, as an undirected line.
double brightDiagonal(const Corner& corner) {
  const double middle = 0.5 * (corner.angle1 + corner.angle2);
  return corner.brightBetween ? middle : middle + std::numbers::pi / 2;
}

class Corners : public PatternPoints {
 public:
  Corners(const ImageView& picture, std::vector<Corner> candidates)
      : picture_(picture), candidates_(std::move(candidates)) {
    for (const Corner& corner : candidates_) {
      places_.push_back(corner.px);
      diagonals_.push_back(brightDiagonal(corner));
    }
  }

  [[nodiscard]] std::span<const Point2> places() const override { return places_; }

  [[nodiscard]] std::optional<LatticeSeed> seedAt(std::size_t candidate, const PointIndex& index) const override {
    const Corner& own = candidates_[candidate];
    const auto u = stepAlong(candidate, own.angle1, index), v = stepAlong(candidate, own.angle2, index);
    if (!u || !v) return std::nullopt;
    const bool right = u->x() * v->y() - u->y() * v->x() > 0;
    return LatticeSeed{candidate, right ? LatticeSteps{*u, *v} : LatticeSteps{*v, *u}};
  }

  [[nodiscard]] bool mayBeNeighbours(std::size_t a, std::size_t b) const override {
    // Where a has its bright squares b has its dark ones.
    return between(diagonals_[a], diagonals_[b] + std::numbers::pi / 2) < kMostTurn;
  }

  [[nodiscard]] std::optional<PatternPoint> fit(std::size_t candidate, const LatticeSteps& steps) const override {
    return fitted(candidates_[candidate], steps);
  }

  [[nodiscard]] std::optional<PatternPoint> fitAt(const Point2& place, const LatticeSteps& steps,
                                                  const PatternPoint& neighbour, bool oddSteps) const override {
    Corner start = neighbour.corner;
    start.px = place;
    start.angle1 = std::atan2(steps.u.y(), steps.u.x());
    start.angle2 = std::atan2(steps.v.y(), steps.v.x());
    // The neighbour's edges may be numbered the other way round.
    const bool same = between(neighbour.corner.angle1, start.angle1) < between(neighbour.corner.angle2, start.angle1);
    start.brightBetween = neighbour.corner.brightBetween == (same != oddSteps);
    const auto point = fitted(start, steps);
    if (!point || point->contrastDn < 0.3 * neighbour.contrastDn) return std::nullopt;
    if ((point->px - place).norm() > 0.2 * std::min(steps.u.norm(), steps.v.norm()) + 1) return std::nullopt;
    return point;
  }

 private:
  /// To the nearest candidate that may be a neighbour, ahead or behind along an edge.
  [[nodiscard]] std::optional<Point2> stepAlong(std::size_t candidate, double angle, const PointIndex& index) const {
    const Point2 along(std::cos(angle), std::sin(angle));
    for (double reach = 48; reach < 4000; reach *= 3) {
      for (const std::size_t i : index.within(places_[candidate], reach)) {
        const Point2 step = places_[i] - places_[candidate];
        const double ahead = step.dot(along), aside = step.x() * along.y() - step.y() * along.x();
        if (i == candidate || std::abs(aside) > kCone * std::abs(ahead) || !mayBeNeighbours(candidate, i)) continue;
        return ahead > 0 ? step : Point2(-step);
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<PatternPoint> fitted(const Corner& start, const LatticeSteps& steps) const {
    const double area = std::abs(steps.u.x() * steps.v.y() - steps.u.y() * steps.v.x());
    const double room = kRoomShare * area / std::max(steps.u.norm(), steps.v.norm());
    const auto fit = fitCorner(picture_, start, room);
    if (!fit || fit->corner.brightBetween != start.brightBetween) return std::nullopt;
    if (between(fit->corner.angle1, fit->corner.angle2) < kLeastAngle) return std::nullopt;
    if (between(fit->corner.angle1, start.angle1) > 0.35 || between(fit->corner.angle2, start.angle2) > 0.35)
      return std::nullopt;
    if (fit->contrastDn < std::max(kLeastContrastDn, 2 * fit->noiseDn)) return std::nullopt;
    if (fit->evenness < kLeastEvenness) return std::nullopt;
    const double misfit = std::sqrt(std::max(0.0, fit->rmsDn * fit->rmsDn - kNoiseSlack * fit->noiseDn * fit->noiseDn));
    if (misfit > kMostMisfit * fit->contrastDn) return std::nullopt;
    PatternPoint point;
    point.px = fit->corner.px;
    point.uPx = fit->uPx;
    point.blurPx = fit->blurPx;
    point.contrastDn = fit->contrastDn;
    point.groundDn = fit->groundDn;
    point.noiseDn = fit->noiseDn;
    point.rmsDn = fit->rmsDn;
    point.saturatedShare = fit->saturatedShare;
    point.corner = fit->corner;
    return point;
  }

  ImageView picture_;
  std::vector<Corner> candidates_;
  std::vector<Point2> places_;
  std::vector<double> diagonals_;
};

}  // namespace

std::unique_ptr<PatternPoints> corners(const ImageView& picture, std::vector<Corner> candidates) {
  return std::make_unique<Corners>(picture, std::move(candidates));
}

}  // namespace vignole
