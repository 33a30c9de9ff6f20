// Poses of a flat target as a technician would show it to a camera.

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/optics/camera_model.h"
#include "engine/simulator/hashing.h"
#include "engine/simulator/virtual_target.h"

namespace vignole {

using namespace simulator;  // the room's own parts

namespace {

/// A pose by where the board's middle is seen, how far it is, how it is tilted (about an axis in the picture) and
/// turned.
struct Stance {
  Point2 px{0, 0};
  double distanceMm = 0, tiltRad = 0, tiltAxisRad = 0, rollRad = 0;
};

Extrinsics poseOf(const Stance& stance, const Intrinsics& in, const Point2& middle) {
  const Eigen::Vector2d u = undistortedFromPixel(lens(in), Vector2T<double>(stance.px));
  const Point3 axis(std::cos(stance.tiltAxisRad), std::sin(stance.tiltAxisRad), 0);
  Extrinsics pose;
  pose.rotation =
      (Eigen::AngleAxisd(stance.tiltRad, axis) * Eigen::AngleAxisd(stance.rollRad, Point3::UnitZ())).toRotationMatrix();
  pose.translationMm = stance.distanceMm / in.focalMm * Point3(u.x(), u.y(), in.focalMm) -
                       pose.rotation * Point3(middle.x(), middle.y(), 0);
  return pose;
}

/// Whether every point, and what belongs to it, is in the picture.
bool fits(const PlanarTarget& target, const Intrinsics& in, const Extrinsics& pose) {
  constexpr double kEdgePx = 6;
  const TargetRectangle printed = [&] {
    TargetRectangle r = board(target);
    const double margin = target.pattern == TargetPattern::Chessboard ? target.pitchMm : target.pitchMm / 8;
    r.min += Point2(margin, margin);
    r.max -= Point2(margin, margin);
    return r;
  }();
  const Lens<double> camera = lens(in);
  for (const double x : {printed.min.x(), printed.max.x()})
    for (const double y : {printed.min.y(), printed.max.y()}) {
      const Point3 point = pose.rotation * Point3(x, y, 0) + pose.translationMm;
      if (!(point.z() > 0)) return false;
      const Eigen::Vector2d px = projectFromCamera<double>(camera, point);
      if (!(px.x() >= kEdgePx && px.y() >= kEdgePx && px.x() <= in.widthPx - 1 - kEdgePx &&
            px.y() <= in.heightPx - 1 - kEdgePx))
        return false;
    }
  return true;
}

}  // namespace

std::vector<Extrinsics> usualViews(const PlanarTarget& target, const Intrinsics& in, int count, std::uint64_t seed) {
  constexpr double kDegree = std::numbers::pi / 180;
  constexpr double kNearestMm = 350, kFarthestMm = 450, kTooFarMm = 4000;
  // Where the board goes, from the middle of the picture (-1 .. 1): over its corners, edges and middle.
  constexpr std::array<std::array<double, 2>, 9> kPlaces = {
      {{0, 0}, {-1, -1}, {1, 1}, {1, -1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
  constexpr int kBeyondEvery = 8;   // of so many views one shows the board partly outside
  constexpr double kBeyond = 1.15;  // so much farther out than it fits
  const TargetRectangle whole = board(target);
  const Point2 middle = (whole.min + whole.max) / 2;
  const Point2 centre((in.widthPx - 1) / 2.0, (in.heightPx - 1) / 2.0);
  std::vector<Extrinsics> views;
  for (int i = 0; i < count; ++i) {
    Draws draws(seed, Stream::View, {static_cast<std::uint64_t>(i)});
    const auto& place = kPlaces[static_cast<std::size_t>(i) % kPlaces.size()];
    Stance stance;
    stance.distanceMm = draws.uniform(kNearestMm, kFarthestMm);
    stance.tiltRad = (i == 0 ? draws.uniform(0, 5) : draws.uniform(15, 35)) * kDegree;
    stance.tiltAxisRad = 2.4 * i + draws.uniform(-0.3, 0.3);  // the golden angle: to all sides
    stance.rollRad = draws.uniform(-15, 15) * kDegree + (i % 4 == 3 ? std::numbers::pi / 2 : 0);
    const auto poseAt = [&](double share) {
      Stance there = stance;
      there.px = centre + share * Point2(place[0] * centre.x(), place[1] * centre.y());
      return poseOf(there, in, middle);
    };
    while (!fits(target, in, poseAt(0)) && stance.distanceMm < kTooFarMm) stance.distanceMm *= 1.02;
    double low = 0, high = 1;
    for (int step = 0; step < 20; ++step) {
      const double share = (low + high) / 2;
      (fits(target, in, poseAt(share)) ? low : high) = share;
    }
    const bool beyond = i % kBeyondEvery == kBeyondEvery - 1;
    views.push_back(poseAt(beyond ? kBeyond * low : draws.uniform(0.75, 1) * low));
  }
  return views;
}

}  // namespace vignole
