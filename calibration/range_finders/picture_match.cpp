#include "calibration/range_finders/picture_match.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "calibration/range_finders/pose_from_centres.h"
#include "engine/geometry/fit.h"
#include "engine/optics/camera_model.h"
#include "engine/optics/plane_map.h"

namespace vignole {

namespace {

constexpr double kLeastArcRad = 0.6;     // shorter ones tell no centre
constexpr double kRoughMm = 0.25;        // rms about a circle, in a plane that is known but roughly
constexpr double kLargestURadiusMm = 0.5;
constexpr double kPosePx = 4;            // rms of the centres; they scatter by 0.2 to 1 px
constexpr double kOnPinMm = 0.6;         // median distance of an arc's points from the circle of its pin
constexpr double kQuarter = std::numbers::pi / 2;

RangeFinderCalibration finderAt(const Intrinsics& intrinsics, const Extrinsics& pose) {
  RangeFinderCalibration finder;
  finder.intrinsics = intrinsics;
  finder.cameraFromWorld = pose;
  return finder;
}

std::vector<Point2> inPlane(const PinArc& arc, const PlaneMap& map) {
  std::vector<Point2> points;
  for (const ArcPoint& p : arc.points) {
    const PlanePoint at = map(p.px.x(), p.px.y());
    points.emplace_back(at.x, at.y);
  }
  return points;
}

double sweepRad(const std::vector<Point2>& points, const Point2& centre) {
  const auto heading = [&](const Point2& p) { return std::atan2(p.y() - centre.y(), p.x() - centre.x()); };
  const double middle = heading(points[points.size() / 2]);
  return std::abs(std::remainder(heading(points.front()) - middle, 4 * kQuarter)) +
         std::abs(std::remainder(heading(points.back()) - middle, 4 * kQuarter));
}

/// The pin on whose circle an arc lies, on the side of the camera.
struct PinUnder {
  bool found = false;
  std::size_t pin = 0;
  double offMm = kOnPinMm;
};
PinUnder pinUnder(const std::vector<Point2>& points, const Point2& camera, const PinPlate& plate) {
  PinUnder best;
  std::vector<double> off;
  for (std::size_t p = 0; p < plate.pins.size(); ++p) {
    const Pin& pin = plate.pins[p];
    if ((points[points.size() / 2] - pin.centreMm).dot(camera - pin.centreMm) < 0) continue;
    off.clear();
    for (const Point2& point : points) off.push_back(std::abs((point - pin.centreMm).norm() - pin.radiusMm));
    const auto middle = off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2);
    std::nth_element(off.begin(), middle, off.end());
    if (*middle < best.offMm) best = {true, p, *middle};
  }
  return best;
}

/// Whether two poses put the plate's middle elsewhere, or are the same answer come by twice.
bool differs(const Extrinsics& a, const Extrinsics& b, const PinPlate& plate) {
  constexpr double kSameMm = 3;
  Point2 middle(0, 0);
  for (const Pin& pin : plate.pins) middle += pin.centreMm / static_cast<double>(plate.pins.size());
  const Eigen::Vector3d m(middle.x(), middle.y(), 0);
  return (a.rotation * m + a.translationMm - b.rotation * m - b.translationMm).norm() > kSameMm;
}

}  // namespace

PlaneCircles planeCircles(const PinPicture& picture, const Intrinsics& intrinsics, const Extrinsics& drawing,
                          const PinPlate& plate) {
  PlaneCircles found;
  const PlaneMap map(finderAt(intrinsics, drawing));
  const Point2 camera = cameraCentre(drawing).head<2>();
  double smallest = 1e9, largest = 0;
  for (const Pin& pin : plate.pins) {
    smallest = std::min(smallest, pin.radiusMm);
    largest = std::max(largest, pin.radiusMm);
  }
  for (std::size_t a = 0; a < picture.arcs.size(); ++a) {
    if (!picture.arcs[a].usable()) continue;
    const std::vector<Point2> points = inPlane(picture.arcs[a], map);
    const auto circle = fitCircle(points);
    if (!circle || !(circle->rmsMm < kRoughMm)) continue;
    const double uRadius = circle->rmsMm * std::sqrt(std::max(0.0, circle->covariance(2, 2)));
    if (circle->radiusMm < 0.7 * smallest - 3 * uRadius || circle->radiusMm > 1.4 * largest + 3 * uRadius ||
        uRadius > kLargestURadiusMm || sweepRad(points, circle->centre) < kLeastArcRad)
      continue;
    // Light lies on the camera's side of a pin.
    if ((points[points.size() / 2] - circle->centre).dot(camera - circle->centre) < 0) continue;
    found.circles.push_back({circle->centre, circle->radiusMm, uRadius});
    found.arcs.push_back(a);
  }
  return found;
}

namespace {

/// One answer with the pose that it leads to.
struct Answer {
  PatternMatch match;
  CameraPose pose;
  int pins = 0;  ///< with their arcs on them
};

/// Pins that have an arc on their circle from there.
int pinsWithArcs(const PinPicture& picture, const Intrinsics& intrinsics, const PinPlate& plate,
                 const Extrinsics& cameraFromPlate) {
  const PlaneMap map(finderAt(intrinsics, cameraFromPlate));
  const Point2 camera = cameraCentre(cameraFromPlate).head<2>();
  std::set<std::size_t> pins;
  for (const PinArc& arc : picture.arcs)
    if (const auto on = arc.usable() ? pinUnder(inPlane(arc, map), camera, plate) : PinUnder{}; on.found)
      pins.insert(on.pin);
  return static_cast<int>(pins.size());
}

}  // namespace

PictureMatch matchPicture(const PinPicture& picture, const Intrinsics& intrinsics, const Extrinsics& drawing,
                          const PinPlate& plate, const AssociationSettings& settings) {
  const PlaneCircles circles = planeCircles(picture, intrinsics, drawing, plate);
  PictureMatch result;
  result.circles = static_cast<int>(circles.circles.size());
  PatternSettings pattern;
  pattern.radiusMm = settings.radiusMm;
  const Lens<double> camera = lens(intrinsics);
  std::vector<Answer> answers;
  for (PatternMatch& match : matchPattern(circles.circles, plate.pins, pattern)) {
    if (static_cast<int>(match.pairs.size()) + 1 < settings.fewestPins || !(match.rmsMm < settings.maxRmsMm)) continue;
    // The circles' centres back in the picture: of circles, not of ellipses, so without a bias worth the name.
    std::vector<PlaneCorrespondence> points;
    for (const auto& pair : match.pairs) {
      const Point2& at = circles.circles[static_cast<std::size_t>(pair.circle)].centreMm;
      points.push_back({plate.pins[static_cast<std::size_t>(pair.pin)].centreMm,
                        project<double>(camera, drawing.rotation, drawing.translationMm, {at.x(), at.y(), 0})});
    }
    const Transform2& turn = match.planeFromPlate;
    Extrinsics start;
    start.rotation =
        drawing.rotation * Eigen::AngleAxisd(turn.angleRad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    start.translationMm = drawing.rotation * Eigen::Vector3d(turn.xMm, turn.yMm, 0) + drawing.translationMm;
    const auto pose = poseFromCentres(points, intrinsics, start);
    if (!pose || !(pose->rmsPx < kPosePx)) continue;
    answers.push_back({std::move(match), *pose, pinsWithArcs(picture, intrinsics, plate, pose->cameraFromPlane)});
  }
  if (answers.empty()) return result;
  std::stable_sort(answers.begin(), answers.end(), [](const Answer& a, const Answer& b) {
    return a.pins != b.pins ? a.pins > b.pins : a.pose.rmsPx < b.pose.rmsPx;
  });
  // Of two answers that are as good, the one with the plate as drawn.
  constexpr double kFloorPx = 0.3;
  const auto asGood = [&](const Answer& a) {
    return a.pins + 2 > answers.front().pins &&
           a.pose.rmsPx < settings.uniqueness * std::max(answers.front().pose.rmsPx, kFloorPx);
  };
  std::size_t best = 0;
  for (std::size_t i = 1; i < answers.size(); ++i) {
    if (!asGood(answers[i])) continue;
    const double angle = answers[i].match.planeFromPlate.angleRad, other = answers[best].match.planeFromPlate.angleRad;
    if (std::abs(std::remainder(angle - other, 4 * kQuarter)) > kQuarter / 2) {
      result.looksAlikeTurned = true;
      if (std::abs(angle) < std::abs(other)) best = i;
    } else if (differs(answers[i].pose.cameraFromPlane, answers[best].pose.cameraFromPlane, plate)) {
      result.ambiguous = true;
    }
  }
  result.pins = answers[best].pins;
  result.cameraFromPlate = answers[best].pose.cameraFromPlane;
  result.found = !result.ambiguous && result.pins >= settings.fewestPins;
  return result;
}

void assignArcs(PinPicture& picture, const Intrinsics& intrinsics, const PinPlate& plate) {
  const PlaneMap map(finderAt(intrinsics, picture.cameraFromPlate));
  const Point2 camera = cameraCentre(picture.cameraFromPlate).head<2>();
  struct Claim {
    double fromRad, toRad, offMm;
    PinArc* arc;
  };
  std::vector<std::vector<Claim>> claims(plate.pins.size());
  for (PinArc& arc : picture.arcs) {
    arc.pin = 0;
    const std::vector<Point2> points = inPlane(arc, map);
    const PinUnder on = pinUnder(points, camera, plate);
    if (!on.found) {
      if (arc.usable()) arc.reason = "no pin of the plate's file is there";
      continue;
    }
    arc.pin = plate.pins[on.pin].number;
    const Point2& centre = plate.pins[on.pin].centreMm;
    const double toCamera = std::atan2(camera.y() - centre.y(), camera.x() - centre.x());
    const auto heading = [&](const Point2& p) {
      return std::remainder(std::atan2(p.y() - centre.y(), p.x() - centre.x()) - toCamera, 4 * kQuarter);
    };
    const double a = heading(points.front()), b = heading(points.back());
    claims[on.pin].push_back({std::min(a, b), std::max(a, b), on.offMm, &arc});
  }
  // Two lines on the same stretch of a pin: one of them is something else.
  for (std::vector<Claim>& claim : claims)
    for (std::size_t i = 0; i < claim.size(); ++i)
      for (std::size_t k = 0; k < claim.size(); ++k) {
        const double common = std::min(claim[i].toRad, claim[k].toRad) - std::max(claim[i].fromRad, claim[k].fromRad);
        constexpr double kCommonRad = 0.2;
        if (i == k || common < kCommonRad || !claim[i].arc->usable() || !claim[k].arc->usable()) continue;
        if (claim[i].offMm > claim[k].offMm) claim[i].arc->reason = "another line lies on the same pin";
      }
}

}  // namespace vignole
