#include "engine/systematic/seen_section.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/optics/camera_model.h"
#include "engine/profile/translate.h"

namespace vignole {

namespace {

constexpr double kStepMm = 0.1;           // between the places that are looked at
constexpr double kLaserDistanceMm = 480;  // from the middle of the section
constexpr double kLeastCosine = 0.15;     // of the angle between the outline's normal and a ray in the light plane
constexpr double kBorderPx = 2;           // of the picture: no line is found there

struct Place {
  Point2 point, normal, tangent;
};

std::vector<Place> placesOf(const Section& section, const Transform2& worldFromSection) {
  std::vector<Place> places;
  for (const NamedPrimitive& primitive : section.primitives) {
    const double lengthMm = length(primitive.shape);
    const auto steps = static_cast<int>(std::ceil(lengthMm / kStepMm));
    for (int k = 0; k < steps; ++k) {
      const double s = lengthMm * (k + 0.5) / steps;
      places.push_back({worldFromSection * pointAt(primitive.shape, s),
                        worldFromSection.rotate(normalAt(primitive.shape, s)),
                        worldFromSection.rotate(tangentAt(primitive.shape, s))});
    }
  }
  return places;
}

/// Which places a point of the plane outside of the outline looks at: the nearest ones in their direction.
class Eye {
 public:
  Eye(const Point2& position, const std::vector<Place>& places) : position_(position) {
    nearest_.assign(kDirections, 1e9);
    for (const Place& place : places)
      if (facing(place) > 0) {
        double& least = nearest_[directionOf(place)];
        least = std::min(least, distanceTo(place));
      }
  }
  [[nodiscard]] bool sees(const Place& place) const {
    return facing(place) > kLeastCosine && distanceTo(place) < nearest_[directionOf(place)] + kBehindMm;
  }

 private:
  static constexpr std::size_t kDirections = 7200;  // 0.05 degrees: 0.3 mm at 350 mm
  static constexpr double kBehindMm = 2;            // as much deeper may a slope be within one direction

  [[nodiscard]] double distanceTo(const Place& place) const { return (position_ - place.point).norm(); }
  [[nodiscard]] double facing(const Place& place) const {
    return place.normal.dot(position_ - place.point) / distanceTo(place);
  }
  [[nodiscard]] std::size_t directionOf(const Place& place) const {
    const Point2 d = place.point - position_;
    const double turns = std::atan2(d.y(), d.x()) / (2 * std::numbers::pi) + 0.5;
    return std::min(static_cast<std::size_t>(turns * static_cast<double>(kDirections)), kDirections - 1);
  }

  Point2 position_;
  std::vector<double> nearest_;
};

/// Places in the light plane -> pixels.
class Projector {
 public:
  explicit Projector(const RangeFinderCalibration& finder)
      : intrinsics_(finder.intrinsics),
        lens_(lens(finder.intrinsics)),
        pose_(finder.cameraFromWorld),
        plane_(finder.lightPlane) {}
  [[nodiscard]] Eigen::Vector2d operator()(const Point2& point) const {
    const double z = (plane_.distanceMm - plane_.normal.head<2>().dot(point)) / plane_.normal.z();
    return project<double>(lens_, pose_.rotation, pose_.translationMm, {point.x(), point.y(), z});
  }
  [[nodiscard]] bool inPicture(const Eigen::Vector2d& pixel) const {
    return pixel.x() > kBorderPx && pixel.y() > kBorderPx && pixel.x() < intrinsics_.widthPx - 1 - kBorderPx &&
           pixel.y() < intrinsics_.heightPx - 1 - kBorderPx;  // false if it is no number
  }

 private:
  Intrinsics intrinsics_;
  Lens<double> lens_;
  Extrinsics pose_;
  LightPlane plane_;
};

StripePoint stripePoint(const Eigen::Vector2d& pixel, const Eigen::Vector2d& next) {
  const Eigen::Vector2d along = (next - pixel).normalized();
  StripePoint p;
  p.x = static_cast<float>(pixel.x());
  p.y = static_cast<float>(pixel.y());
  p.nx = static_cast<float>(along.y());
  p.ny = static_cast<float>(-along.x());
  p.sigmaPx = p.ridgeSigmaPx = kSeenSigmaPx;
  p.strength = 100;
  return p;
}

StripeResult linesOf(const RangeFinderCalibration& finder, const Point2& middle, const std::vector<Place>& places,
                     double stepPx) {
  const Eigen::Vector3d centre = -finder.cameraFromWorld.rotation.transpose() * finder.cameraFromWorld.translationMm;
  const Point2 back = -finder.cameraFromWorld.rotation.row(2).head<2>().transpose();
  const Eye camera(centre.head<2>(), places), laser(middle + kLaserDistanceMm * back.normalized(), places);
  const Projector projector(finder);
  StripeResult result;
  Eigen::Vector2d last(0, 0);
  bool within = false;
  for (const Place& place : places) {
    const Eigen::Vector2d pixel = projector(place.point);
    if (!camera.sees(place) || !laser.sees(place) || !projector.inPicture(pixel)) {
      within = false;
      continue;
    }
    if (within && (pixel - last).norm() < stepPx) continue;
    if (!within) result.lines.push_back({static_cast<std::uint32_t>(result.points.size()), 0, Rejection::None});
    result.points.push_back(stripePoint(pixel, projector(place.point + 0.5 * kStepMm * place.tangent)));
    ++result.lines.back().count;
    last = pixel;
    within = true;
  }
  return result;
}

}  // namespace

SeenLines seenLines(const Section& section, const Transform2& worldFromSection, const RigCalibration& rig,
                    double stepPx) {
  const std::vector<Place> places = placesOf(section, worldFromSection);
  const Point2 middle = worldFromSection * Point2(0, section.heightMm() / 2);
  SeenLines lines;
  for (std::size_t c = 0; c < kCameraCount; ++c) lines[c] = linesOf(rig.rangeFinders[c], middle, places, stepPx);
  return lines;
}

Profile profileOf(const SeenLines& lines, const RigCalibration& rig) {
  Profile profile;
  PartialContour contour;
  for (std::size_t c = 0; c < kCameraCount; ++c) {
    Translator(static_cast<int>(c), rig.rangeFinders[c]).translate(0, lines[c], contour);
    const auto first = static_cast<std::uint32_t>(profile.points.size());
    profile.points.insert(profile.points.end(), contour.points.begin(), contour.points.end());
    for (const std::uint32_t end : contour.lineEnds) profile.lineEnds.push_back(first + end);
    profile.pointsOfCamera[c] = static_cast<std::uint32_t>(contour.points.size());
    profile.missing[c] = contour.missing;
  }
  return profile;
}

}  // namespace vignole
