#include "calibration/intrinsics/view_selection.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "calibration/intrinsics/zhang_start.h"

namespace vignole {

namespace {

using Size = std::pair<int, int>;

/// The size that most pictures have.
Size usualSize(const std::vector<TargetView>& views) {
  std::map<Size, int> count;
  for (const TargetView& view : views)
    if (view.usable()) ++count[{view.widthPx, view.heightPx}];
  Size usual{0, 0};
  int most = 0;
  for (const auto& [size, n] : count)
    if (n > most) {
      most = n;
      usual = size;
    }
  return usual;
}

std::string words(const Size& size) { return std::to_string(size.first) + " x " + std::to_string(size.second) + " px"; }

ObservedView observed(const TargetView& view, std::size_t targetPoints) {
  ObservedView points;
  for (const FoundPoint& p : view.points)
    if (p.index >= 0 && static_cast<std::size_t>(p.index) < targetPoints && p.px.allFinite())
      points.push_back({p.index, p.px, std::isfinite(p.uPx) ? std::max(0.0, p.uPx) : 0, 1});
  return points;
}

std::string objection(const TargetView& view, const ObservedView& points, const TakenViews& taken, const Size& usual,
                      const IntrinsicsSettings& settings) {
  if (!view.usable()) return view.refusal;
  if (const Size size{view.widthPx, view.heightPx}; size != usual)
    return "the picture has " + words(size) + ", the others " + words(usual) +
           "; take all with the same camera and settings";
  if (points.size() < settings.minViewPoints)
    return "only " + std::to_string(points.size()) + " points were found, " + std::to_string(settings.minViewPoints) +
           " are needed; show more of the target";
  const auto h = homography(taken.observations.points, points);
  if (!h) return "its points lie on one line; show more of the target";
  if (mirrored(*h, taken.like))
    return "the target is seen as in a mirror; do not flip the picture, and show the target's front";
  return {};
}

double distancePx(const TargetObservations& observations, const TargetFit& fit, std::size_t a, std::size_t b) {
  double squares = 0;
  std::size_t count = 0;
  for (const Observation& o : observations.views[a]) {
    const Eigen::Vector3d& point = fit.points[static_cast<std::size_t>(o.point)];
    const Point2 there = reprojected(fit.intrinsics, fit.cameraFromTarget[b], point, 0);
    if (!there.allFinite()) continue;
    squares += (there - reprojected(fit.intrinsics, fit.cameraFromTarget[a], point, 0)).squaredNorm();
    ++count;
  }
  return count == 0 ? INFINITY : std::sqrt(squares / static_cast<double>(count));
}

}  // namespace

TakenViews takeViews(const std::vector<TargetView>& views, const PlanarTarget& target,
                     const IntrinsicsSettings& settings, std::vector<ViewResult>& results) {
  TakenViews taken;
  for (const Point2& p : target.points()) taken.observations.points.emplace_back(p.x(), p.y(), 0);
  taken.observations.radiusMm = target.diameterMm / 2;
  const Size usual = usualSize(views);
  taken.like.pixelWidthMm = taken.like.pixelHeightMm = settings.pixelMm;
  taken.like.widthPx = usual.first;
  taken.like.heightPx = usual.second;
  taken.like.cxPx = (usual.first - 1) / 2.0;
  taken.like.cyPx = (usual.second - 1) / 2.0;
  taken.like.focalMm = usual.first * settings.pixelMm;
  for (std::size_t v = 0; v < views.size(); ++v) {
    ObservedView points = observed(views[v], taken.observations.points.size());
    ViewResult& result = results.emplace_back();
    result.file = views[v].file;
    result.reason = objection(views[v], points, taken, usual, settings);
    if (!result.reason.empty()) continue;
    taken.observations.views.push_back(std::move(points));
    taken.source.push_back(v);
  }
  return taken;
}

void rejectSamePoses(const TargetObservations& observations, const TargetFit& fit,
                     const std::vector<std::string>& names, double samePosePx, Selection& selection) {
  for (std::size_t v = 1; v < observations.views.size(); ++v)
    for (std::size_t earlier = 0; earlier < v && selection.viewRejection[v].empty(); ++earlier)
      if (selection.viewRejection[earlier].empty() && distancePx(observations, fit, v, earlier) < samePosePx)
        selection.viewRejection[v] =
            "the target stands where it stood in " + names[earlier] + "; move and tilt it between pictures";
}

double tiltDifferenceDeg(const TargetFit& fit, const Selection& selection) {
  double largest = 0;
  for (std::size_t a = 0; a < fit.cameraFromTarget.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      if (!selection.viewRejection[a].empty() || !selection.viewRejection[b].empty()) continue;
      const double cosine = fit.cameraFromTarget[a].rotation.col(2).dot(fit.cameraFromTarget[b].rotation.col(2));
      largest = std::max(largest, std::acos(std::clamp(cosine, -1.0, 1.0)));
    }
  return largest * 180 / std::numbers::pi;
}

}  // namespace vignole
