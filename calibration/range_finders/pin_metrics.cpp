#include "calibration/range_finders/pin_metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/geometry/fit.h"
#include "engine/optics/plane_map.h"

namespace vignole {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// Centre and radius free, in the plate's frame, beside what the plate's file says.
void measureCircle(const ArcObservation& arc, const Pin& stated, const Transform2& worldFromPlate, PinView& view) {
  std::vector<double> sigma;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t i = 0; i < arc.inside.size(); ++i)
    if (arc.shown[i] != 0 && arc.weight[i] > 0) {
      sigma.push_back(arc.sigmaPx[i] * arc.mmPerPx[i]);
      low = std::min(low, arc.angleRad[i]);
      high = std::max(high, arc.angleRad[i]);
    }
  view.cdMm = view.rdMm = view.pdMm = view.pdNominalMm = std::nan("");
  if (!(high - low > kLeastMetricArcDeg * kDegree)) return;
  const auto circle = fitCircle(view.pointsInWorld, sigma);
  if (!circle) return;
  const Point2 centre = worldFromPlate * stated.centreMm;
  view.cdMm = (circle->centre - centre).norm();
  view.rdMm = std::abs(circle->radiusMm - stated.radiusMm);
  double free = 0, nominal = 0;
  for (const Point2& p : view.pointsInWorld) {
    free += std::abs((p - circle->centre).norm() - stated.radiusMm);
    nominal += std::abs((p - centre).norm() - stated.radiusMm);
  }
  const auto count = static_cast<double>(view.pointsInWorld.size());
  view.pdMm = free / count;
  view.pdNominalMm = nominal / count;
}

}  // namespace

std::vector<PinView> pinViews(const ArcAdjustment& adjustment, const RigInputs& inputs) {
  std::vector<PlaneMap> maps;
  for (const RangeFinderCalibration& finder : adjustment.state.finders) maps.emplace_back(finder);
  std::vector<PinView> views;
  for (const ArcObservation& arc : adjustment.arcs) {
    PinView& view = views.emplace_back();
    const Pin& stated = inputs.plate.pins[static_cast<std::size_t>(arc.pin)];
    const Transform2& placed = adjustment.state.worldFromPlate[static_cast<std::size_t>(arc.placement)];
    const Point2 centre = placed * adjustment.state.pins[static_cast<std::size_t>(arc.pin)].centreMm;
    view.pin = stated.number;
    view.camera = arc.camera;
    view.placement = arc.placement;
    view.used = arc.used();
    view.reason = arc.rejected;
    view.arcDeg = arc.arcRad / kDegree;
    for (std::size_t i = 0; i < arc.inside.size(); ++i) {
      if (arc.shown[i] == 0 || !(arc.weight[i] > 0)) continue;
      const ArcPoint& point = arc.line->points[i];
      const PlanePoint p = maps[static_cast<std::size_t>(arc.camera)](point.px.x(), point.px.y());
      const Point2 at(p.x, p.y);
      view.pointsInWorld.push_back(at - arc.pullMm[i] * (at - centre).normalized());
      view.residualPx.push_back(arc.residualPx[i]);
    }
    view.points = arc.pointsUsed();
    measureCircle(arc, stated, placed, view);
  }
  return views;
}

SpreadMm spreadOf(std::span<const double> values) {
  SpreadMm spread;
  double sum = 0, square = 0;
  int count = 0;
  for (const double v : values) {
    if (!std::isfinite(v)) continue;
    sum += v;
    square += v * v;
    spread.max = std::max(spread.max, v);
    ++count;
  }
  if (count == 0) return spread;
  spread.mean = sum / count;
  spread.std = count > 1 ? std::sqrt(std::max(0.0, (square - sum * sum / count) / (count - 1))) : 0;
  return spread;
}

RangeFinderFit fitOf(std::span<const PinView> views, int camera) {
  std::vector<double> cd, rd, pd, nominal;
  double distance = 0, square = 0;
  int points = 0;
  for (const PinView& view : views) {
    if (view.camera != camera || !view.used) continue;
    cd.push_back(view.cdMm);
    rd.push_back(view.rdMm);
    pd.push_back(view.pdMm);
    nominal.push_back(view.pdNominalMm);
    for (const double r : view.residualPx) {
      distance += std::abs(r);
      square += r * r;
      ++points;
    }
  }
  RangeFinderFit fit;
  fit.cd = spreadOf(cd);
  fit.rd = spreadOf(rd);
  fit.pd = spreadOf(pd);
  fit.pdNominal = spreadOf(nominal);
  if (points > 0) {
    fit.reprojectionPx = distance / points;
    fit.rmsPx = std::sqrt(square / points);
  }
  return fit;
}

}  // namespace vignole
