#include "calibration/assessment/comparison.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "calibration/assessment/pin_centres.h"
#include "calibration/assessment/plane_motion.h"
#include "engine/optics/nominal_rig.h"
#include "engine/optics/plane_map.h"
#include "engine/systematic/calibration_error.h"

namespace vignole {

namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

/// Where one camera's pixels lie by both.
struct Places {
  std::vector<Point2> older, newer;
};

/// Of the pixels in which the newer one sees the space of a rail.
Places placesOf(const RangeFinderCalibration& older, const RangeFinderCalibration& newer) {
  constexpr int kHalfWidth = 7, kHeight = 17;
  constexpr double kStepMm = 10;
  const PlaneMap a(older), b(newer);
  Places places;
  for (int column = -kHalfWidth; column <= kHalfWidth; ++column)
    for (int row = 0; row <= kHeight; ++row) {
      const Point2 px = pixelOf(newer, {kStepMm * column, kStepMm * row});
      const bool seen = px.x() > 0 && px.y() > 0 && px.x() < newer.intrinsics.widthPx - 1 &&
                        px.y() < newer.intrinsics.heightPx - 1;  // false if it is no number
      if (!seen) continue;
      const PlanePoint o = a(px.x(), px.y()), n = b(px.x(), px.y());
      if (!std::isfinite(o.x) || !std::isfinite(o.y)) continue;
      places.older.emplace_back(o.x, o.y);
      places.newer.emplace_back(n.x, n.y);
    }
  return places;
}

/// From the older camera, seen in the newer world, to the newer one.
CameraMovement movementOf(const Places& places, const Extrinsics& older, const Extrinsics& newer) {
  CameraMovement movement;
  Point2 mean(0, 0);
  for (std::size_t i = 0; i < places.older.size(); ++i)
    mean += (places.newer[i] - places.older[i]) / static_cast<double>(places.older.size());
  movement.xMm = mean.x();
  movement.yMm = mean.y();
  movement.turnDeg = laidOnto(places.older, places.newer).angleRad * kDegrees;
  movement.centreMm = (cameraCentre(newer) - cameraCentre(older)).norm();
  movement.poseDeg = Eigen::AngleAxisd(newer.rotation * older.rotation.transpose()).angle() * kDegrees;
  return movement;
}

}  // namespace

Transform2 worldOf(const RigCalibration& reference, const RigCalibration& other) {
  Places all;
  for (std::size_t c = 0; c < kCameraCount; ++c) {
    const Places places = placesOf(other.rangeFinders[c], reference.rangeFinders[c]);
    all.older.insert(all.older.end(), places.older.begin(), places.older.end());
    all.newer.insert(all.newer.end(), places.newer.begin(), places.newer.end());
  }
  return all.older.size() < 2 ? Transform2{} : laidOnto(all.older, all.newer);
}

Expected<Comparison> compare(const RigCalibration& older, const RigCalibration& newer, const Section& section,
                             const DimensionParameters& parameters) {
  const RigCalibration before = inWorld(older, worldOf(newer, older));
  const auto difference = measuredDimensions(section, parameters, newer, before);
  if (!difference) return tl::unexpected(difference.error());
  const auto uOlder = calibrationUncertainty(section, parameters, before);
  if (!uOlder) return tl::unexpected(uOlder.error());
  const auto uNewer = calibrationUncertainty(section, parameters, newer);
  if (!uNewer) return tl::unexpected(uNewer.error());
  Comparison comparison;
  comparison.differenceMm = *difference;
  for (std::size_t d = 0; d < kDimensionCount; ++d) comparison.uMm[d] = std::hypot((*uOlder)[d], (*uNewer)[d]);
  for (std::size_t c = 0; c < kCameraCount; ++c) {
    const RangeFinderCalibration &a = before.rangeFinders[c], &b = newer.rangeFinders[c];
    const Places places = placesOf(a, b);
    if (places.older.size() > 1) comparison.cameras[c] = movementOf(places, a.cameraFromWorld, b.cameraFromWorld);
  }
  return comparison;
}

Check comparisonCheck(const Comparison& comparison) {
  constexpr double kMostU = 4, kLeastUMm = 1e-3;
  Check check{"last calibration", true, 0, kMostU, "u", false, "", ""};
  Dimension worst = Dimension::RH;
  for (const Dimension d : kDimensions) {
    if (d == Dimension::HF || d == Dimension::HR) continue;  // an extreme, and one that its own noise rules
    const double value = std::abs(comparison.differenceMm[index(d)]) / std::max(kLeastUMm, comparison.uMm[index(d)]);
    if (value > check.value) {
      check.value = value;
      worst = d;
    }
  }
  std::size_t most = 0;
  const auto size = [&](std::size_t c) { return std::hypot(comparison.cameras[c].xMm, comparison.cameras[c].yMm); };
  for (std::size_t c = 1; c < kCameraCount; ++c)
    if (size(c) > size(most)) most = c;
  std::array<char, 320> text{};
  std::snprintf(
      text.data(), text.size(),
      "the older calibration gives %s %+.4f mm off the newer one (u %.4f); camera %zu has moved most, by %.3f mm "
      "and %.4f deg",
      std::string(name(worst)).c_str(), comparison.differenceMm[index(worst)], comparison.uMm[index(worst)], most + 1,
      size(most), comparison.cameras[most].turnDeg);
  check.words = text.data();
  check.remedy = "find out what has moved since, and judge the rails of that time by it";
  return check;
}

}  // namespace vignole
