#include "calibration/range_finders/pin_lines.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "engine/stripe/ridge_kernel.h"
#include "engine/stripe/stripe_extractor.h"

namespace vignole {

namespace {

constexpr double kGapPx = 4;         // between neighbours of one arc
constexpr double kCornerDeg = 40;    // a turn within a few pixels that no pin makes
constexpr std::size_t kCornerReach = 4;  // points to both sides

/// The ridge itself: what the extraction moved its points by, for bends of rails, is taken back.
ArcPoint ridgePoint(const StripePoint& p, double filterVariance) {
  ArcPoint point;
  point.normal = {p.nx, p.ny};
  point.px = Point2(p.x, p.y) - static_cast<double>(p.shiftPx) * point.normal;
  point.sigmaPx = p.ridgeSigmaPx;
  const double own = static_cast<double>(p.widthPx) * p.widthPx;
  point.variancePx2 = own + filterVariance;
  point.lightDn = p.strength * std::sqrt(own / point.variancePx2);
  point.flags = p.flags;
  return point;
}

double turnDeg(const std::vector<ArcPoint>& points, std::size_t i, std::size_t reach) {
  const Point2 before = points[i].px - points[i - reach].px, behind = points[i + reach].px - points[i].px;
  return std::abs(std::atan2(before.x() * behind.y() - before.y() * behind.x(), before.dot(behind))) * 180 / M_PI;
}

/// Where a line does not go on as one arc: gaps, and corners where the lines of two pins meet.
std::vector<std::size_t> breaks(const std::vector<ArcPoint>& points) {
  std::vector<std::size_t> at{0};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const bool gap = (points[i].px - points[i - 1].px).norm() > kGapPx;
    bool corner = false;
    if (i >= kCornerReach && i + kCornerReach < points.size()) {
      const double turn = turnDeg(points, i, kCornerReach);
      corner = turn > kCornerDeg && turn >= turnDeg(points, i - 1, std::min(kCornerReach, i - 1)) &&
               (i + 1 + kCornerReach >= points.size() || turn >= turnDeg(points, i + 1, kCornerReach));
    }
    if (gap || corner) at.push_back(i);
  }
  at.push_back(points.size());
  return at;
}

double medianLight(const std::vector<PinArc>& arcs) {
  std::vector<double> light;
  for (const PinArc& arc : arcs)
    for (const ArcPoint& p : arc.points) light.push_back(p.lightDn);
  if (light.empty()) return 0;
  const auto middle = light.begin() + static_cast<std::ptrdiff_t>(light.size() / 2);
  std::nth_element(light.begin(), middle, light.end());
  return *middle;
}

double medianLight(const PinArc& arc) { return medianLight(std::vector<PinArc>{arc}); }

double saturatedShare(const PinArc& arc) {
  const auto clipped = std::count_if(arc.points.begin(), arc.points.end(),
                                     [](const ArcPoint& p) { return (p.flags & kSaturated) != 0; });
  return static_cast<double>(clipped) / static_cast<double>(arc.points.size());
}

}  // namespace

StripeSettings PinLineSettings::pinStripe() {
  StripeSettings stripe;
  stripe.sigma = 1.8;
  stripe.gapDistance = 0;
  stripe.gapAngle = 0;
  return stripe;
}

PinPicture findPinLines(const ImageView& image, const PinLineSettings& settings) {
  StripeExtractor extractor(settings.stripe);
  StripeResult lines;
  extractor.extract(image, lines);
  PinPicture picture;
  picture.filterVariancePx2 = ridgeFilter(settings.stripe.sigma, 0).variancePx2;
  picture.noiseDn = lines.noiseDn;
  picture.saturatedShare = lines.saturatedShare;
  if (lines.overloaded) {
    picture.refusal = "refused, because there is light everywhere; keep other light off the plate";
    return picture;
  }
  std::vector<ArcPoint> points;
  for (const StripeLine& line : lines.lines) {
    // Competition between lines is a matter of rails: one pin's line beside another's is no ghost.
    points.clear();
    for (std::uint32_t i = line.first; i < line.first + line.count; ++i)
      points.push_back(ridgePoint(lines.points[i], picture.filterVariancePx2));
    const std::vector<std::size_t> at = breaks(points);
    for (std::size_t b = 0; b + 1 < at.size(); ++b) {
      if (at[b + 1] - at[b] < static_cast<std::size_t>(settings.minPoints)) continue;
      PinArc arc;
      arc.points.assign(points.begin() + static_cast<std::ptrdiff_t>(at[b]),
                        points.begin() + static_cast<std::ptrdiff_t>(at[b + 1]));
      picture.arcs.push_back(std::move(arc));
    }
  }
  const double typical = medianLight(picture.arcs);
  for (PinArc& arc : picture.arcs) {
    if (saturatedShare(arc) > settings.maxSaturatedShare)
      arc.reason = "saturated";
    else if (medianLight(arc) < settings.leastShare * typical)
      arc.reason = "so weak that it is another laser's light";
  }
  if (picture.arcs.empty())
    picture.refusal = "refused, because no laser line is seen; check that the laser hits the plate and the exposure";
  return picture;
}

}  // namespace vignole
