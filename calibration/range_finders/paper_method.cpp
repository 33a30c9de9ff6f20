#include "calibration/range_finders/paper_method.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "calibration/range_finders/pose_from_centres.h"
#include "engine/optics/camera_model.h"

namespace vignole {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr std::size_t kFewestCentres = 4;

Point2 withoutDistortion(const Lens<double>& camera, const Point2& px) {
  return pixelFromSensor<double>(camera, undistortedFromPixel<double>(camera, px));
}

Point2 withDistortion(const Lens<double>& camera, const Point2& px) {
  return pixelFromSensor<double>(camera, distort<double>(camera, sensorFromPixel<double>(camera, px)));
}

PaperEllipse ellipseOf(const PinArc& arc, const Lens<double>& camera, const PaperSettings& settings) {
  PaperEllipse result;
  if (!arc.usable() && settings.fourSteps == false) {
    result.reason = arc.reason;
    return result;
  }
  std::vector<Point2> points;
  double length = 0;
  for (const ArcPoint& p : arc.points) {
    points.push_back(settings.undistort ? withoutDistortion(camera, p.px) : p.px);
    if (points.size() > 1) length += (points.back() - points[points.size() - 2]).norm();
  }
  const auto fitted = fitEllipse(points, settings.fit);
  if (!fitted) {
    result.reason = "no ellipse: " + fitted.error().what;
    return result;
  }
  result.ellipse = *fitted;
  result.arcShare = length / fitted->perimeterPx();
  if (fitted->axisRatio() < settings.minAxisRatio || fitted->axisRatio() > settings.maxAxisRatio)
    result.reason = "ratio of the axes";
  else if (!(result.arcShare >= settings.minArcShare))
    result.reason = "arc too short for its ellipse";
  return result;
}

/// The ellipses of the longest arcs stay.
void keepLongest(std::vector<PaperEllipse>& ellipses, int most) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < ellipses.size(); ++i)
    if (ellipses[i].reason.empty()) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return ellipses[a].arcShare > ellipses[b].arcShare; });
  for (std::size_t i = static_cast<std::size_t>(std::max(0, most)); i < order.size(); ++i)
    ellipses[order[i]].reason = "beyond the largest number of ellipses";
}

/// Angle by which the drawing's camera sees the plate's x axis turned, y upwards: of the rotation nearest to its affine
/// map.
double rollOf(const Extrinsics& drawing, const Lens<double>& camera, const Point2& middle) {
  const auto seen = [&](const Point2& p) -> Point2 {
    const Point2 px = project<double>(camera, drawing.rotation, drawing.translationMm, {p.x(), p.y(), 0});
    return {px.x(), -px.y()};
  };
  const Point2 x = seen(middle + Point2(1, 0)) - seen(middle), y = seen(middle + Point2(0, 1)) - seen(middle);
  return std::atan2(x.y() - y.x(), x.x() + y.y());
}

Point2 turned(const Point2& p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * p.x() - s * p.y(), s * p.x() + c * p.y()};
}

std::size_t nearestTo(const std::vector<Point2>& points, const Point2& middle) {
  return static_cast<std::size_t>(std::min_element(points.begin(), points.end(),
                                                   [&](const Point2& a, const Point2& b) {
                                                     return (a - middle).squaredNorm() < (b - middle).squaredNorm();
                                                   }) -
                                  points.begin());
}

Point2 meanOf(const std::vector<Point2>& points) {
  Point2 sum(0, 0);
  for (const Point2& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

/// Third step: each axis, each side of zero, by its farthest point.
void normalise(std::vector<Point2>& points) {
  for (int axis = 0; axis < 2; ++axis) {
    double low = 0, high = 0;
    for (const Point2& p : points) {
      low = std::min(low, p[axis]);
      high = std::max(high, p[axis]);
    }
    for (Point2& p : points) {
      const double reach = p[axis] < 0 ? -low : high;
      if (reach > 0) p[axis] /= reach;
    }
  }
}

/// The paper's four steps; sets the pin of each ellipse that finds one.
void associateInFourSteps(std::vector<PaperEllipse>& ellipses, const PinPlate& plate, const Point2& imageCentre,
                          double roll, const PaperSettings& settings) {
  std::vector<std::size_t> taking;
  std::vector<Point2> seen, pins;
  for (std::size_t i = 0; i < ellipses.size(); ++i)
    if (ellipses[i].reason.empty()) {
      taking.push_back(i);
      seen.emplace_back(ellipses[i].ellipse.centre.x(), -ellipses[i].ellipse.centre.y());
    }
  if (seen.empty()) return;
  for (const Pin& pin : plate.pins) pins.push_back(pin.centreMm);

  const Point2 middle =
      settings.centermost == Centermost::Mean ? meanOf(seen) : Point2(imageCentre.x(), -imageCentre.y());
  const Point2 from = seen[nearestTo(seen, middle)], origin = pins[nearestTo(pins, meanOf(pins))];
  for (Point2& p : seen) p = turned(p - from, -roll);
  for (Point2& p : pins) p -= origin;
  normalise(seen);
  normalise(pins);

  // Who is nearest to a pin keeps it.
  std::vector<std::size_t> pinOf(seen.size());
  std::vector<double> distance(seen.size());
  for (std::size_t k = 0; k < seen.size(); ++k) {
    pinOf[k] = nearestTo(pins, seen[k]);
    distance[k] = (pins[pinOf[k]] - seen[k]).norm();
  }
  for (std::size_t k = 0; k < seen.size(); ++k) {
    PaperEllipse& ellipse = ellipses[taking[k]];
    if (!(distance[k] < settings.matchDistance)) {
      ellipse.reason = "farther from every pin than t_ec";
      continue;
    }
    bool closest = true;
    for (std::size_t other = 0; other < seen.size(); ++other)
      if (other != k && pinOf[other] == pinOf[k] &&
          (distance[other] < distance[k] || (distance[other] == distance[k] && other < k)))
        closest = false;
    if (closest)
      ellipse.pin = plate.pins[pinOf[k]].number;
    else
      ellipse.reason = "another ellipse is closer to its pin";
  }
}

}  // namespace

PaperPose paperPose(const PinPicture& picture, const PinPlate& plate, const Intrinsics& intrinsics,
                    const Extrinsics& drawing, const PaperSettings& settings) {
  PaperPose result;
  const Lens<double> camera = lens(intrinsics);
  for (std::size_t a = 0; a < picture.arcs.size(); ++a) {
    result.ellipses.push_back(ellipseOf(picture.arcs[a], camera, settings));
    result.ellipses.back().arc = static_cast<int>(a);
  }
  keepLongest(result.ellipses, settings.maxEllipses);
  if (settings.fourSteps) {
    std::vector<Point2> pins;
    for (const Pin& pin : plate.pins) pins.push_back(pin.centreMm);
    const double roll = rollOf(drawing, camera, meanOf(pins)) + settings.rollErrorDeg * kDegree;
    associateInFourSteps(result.ellipses, plate, {(intrinsics.widthPx - 1) / 2.0, (intrinsics.heightPx - 1) / 2.0},
                         roll, settings);
  } else {
    for (PaperEllipse& e : result.ellipses) {
      if (!e.reason.empty()) continue;
      e.pin = picture.arcs[static_cast<std::size_t>(e.arc)].pin;
      if (e.pin == 0) e.reason = "no pin";
    }
  }

  std::vector<PlaneCorrespondence> centres;
  for (const PaperEllipse& e : result.ellipses)
    for (const Pin& pin : plate.pins)
      if (e.pin == pin.number)
        centres.push_back(
            {pin.centreMm, settings.undistort ? withDistortion(camera, e.ellipse.centre) : e.ellipse.centre});
  if (centres.size() < kFewestCentres) {
    result.refusal = "only " + std::to_string(centres.size()) + " ellipses found their pins";
    return result;
  }
  const auto pose = poseFromCentres(centres, intrinsics, drawing);
  if (!pose) {
    result.refusal = "no pose fits the centres: " + pose.error().what;
    return result;
  }
  result.cameraFromPlate = pose->cameraFromPlane;
  result.rmsPx = pose->rmsPx;
  const Eigen::FullPivLU<Eigen::Matrix<double, 6, 6>> information(pose->information);
  if (information.isInvertible()) result.covariance = information.inverse() * pose->rmsPx * pose->rmsPx;
  if (!(pose->rmsPx <= settings.maxRmsPx))
    result.refusal = "the centres lie " + std::to_string(pose->rmsPx).substr(0, 5) +
                     " px off their pose: ellipses were paired with wrong pins";
  return result;
}

}  // namespace vignole
