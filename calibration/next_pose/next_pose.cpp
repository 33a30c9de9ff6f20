#include "calibration/next_pose/next_pose.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "calibration/intrinsics/information.h"
#include "calibration/intrinsics/reprojection.h"
#include "calibration/parallel_for.h"

namespace vignole {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

struct Candidate {
  int column = 0, row = 0;  ///< of places
  double tiltDeg = 0, directionRad = 0, turnDeg = 0;
  double distanceMm = 0;
};

Eigen::Vector3d middleOf(const PlanarTarget& target) {
  Eigen::Vector3d low(1e300, 1e300, 0), high(-1e300, -1e300, 0);
  for (const Point2& p : target.points()) {
    low.head<2>() = low.head<2>().cwiseMin(p);
    high.head<2>() = high.head<2>().cwiseMax(p);
  }
  return (low + high) / 2;
}

/// Distances of the target's middle in the used views, mm.
std::vector<double> distancesOf(const IntrinsicsCalibration& calibration, const PlanarTarget& target) {
  const Eigen::Vector3d middle = middleOf(target);
  std::vector<double> distances;
  for (const ViewResult& view : calibration.views)
    if (view.used)
      distances.push_back((view.cameraFromTarget.rotation * middle + view.cameraFromTarget.translationMm).z());
  std::sort(distances.begin(), distances.end());
  return distances;
}

std::vector<Candidate> candidatesOf(const std::vector<double>& seen, const NextPoseSettings& settings) {
  std::vector<Candidate> all;
  for (const double distance : settings.distances)
    for (int row = 0; row < settings.rows; ++row)
      for (int column = 0; column < settings.columns; ++column)
        for (const double turn : settings.turnsDeg)
          for (const double tilt : settings.tiltsDeg)
            for (int direction = 0; direction < (tilt > 0 ? settings.directions : 1); ++direction)
              all.push_back({column, row, tilt, 2 * std::numbers::pi * direction / settings.directions, turn,
                             seen.front() + distance * (seen.back() - seen.front())});
  return all;
}

/// The side in `direction` (of the picture, x right, y down) is tilted away; the middle lies in the middle of its
/// place.
Extrinsics poseOf(const Candidate& c, const Intrinsics& in, const Eigen::Vector3d& middle,
                  const NextPoseSettings& settings) {
  const Eigen::Vector3d axis(std::sin(c.directionRad), -std::cos(c.directionRad), 0);
  Extrinsics pose;
  pose.rotation =
      (Eigen::AngleAxisd(c.tiltDeg * kDegree, axis) * Eigen::AngleAxisd(c.turnDeg * kDegree, Eigen::Vector3d::UnitZ()))
          .toRotationMatrix();
  const Eigen::Vector3d ray(((c.column + 0.5) / settings.columns * in.widthPx - in.cxPx) * in.pixelWidthMm / in.focalMm,
                            ((c.row + 0.5) / settings.rows * in.heightPx - in.cyPx) * in.pixelHeightMm / in.focalMm, 1);
  pose.translationMm = c.distanceMm * ray - pose.rotation * middle;
  return pose;
}

/// What would be seen of the target there.
ObservedView seenFrom(const Extrinsics& pose, const Intrinsics& in, const std::vector<Eigen::Vector3d>& points,
                      double radiusMm, double sigmaPx) {
  constexpr double kMarginPx = 8;
  ObservedView view;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point2 px = reprojected(in, pose, points[i], radiusMm);
    if (px.allFinite() && px.x() > kMarginPx && px.y() > kMarginPx && px.x() < in.widthPx - 1 - kMarginPx &&
        px.y() < in.heightPx - 1 - kMarginPx)
      view.push_back({static_cast<int>(i), px, sigmaPx, sigmaPx});
  }
  return view;
}

std::vector<Point2> outlineOf(const PlanarTarget& target, const Extrinsics& pose, const Intrinsics& in) {
  constexpr int kPointsASide = 12;
  const double border = target.pitchMm;
  Point2 high(0, 0);
  for (const Point2& p : target.points()) high = high.cwiseMax(p);
  const std::array<Point2, 5> corners = {Point2(-border, -border), Point2(high.x() + border, -border),
                                         Point2(high.x() + border, high.y() + border),
                                         Point2(-border, high.y() + border), Point2(-border, -border)};
  std::vector<Point2> outline;
  for (std::size_t side = 0; side < 4; ++side)
    for (int i = 0; i <= (side == 3 ? kPointsASide : kPointsASide - 1); ++i) {
      const Point2 p = corners[side] + (corners[side + 1] - corners[side]) * i / kPointsASide;
      if (const Point2 px = reprojected(in, pose, {p.x(), p.y(), 0}, 0); px.allFinite()) outline.push_back(px);
    }
  return outline;
}

std::string wordsFor(const Candidate& c, const NextPoseSettings& settings) {
  constexpr std::array<const char*, 8> kSides = {"right side", "lower right corner", "bottom", "lower left corner",
                                                 "left side",  "upper left corner",  "top",    "upper right corner"};
  const auto eighth = static_cast<std::size_t>(std::lround(c.directionRad / (std::numbers::pi / 4))) % kSides.size();
  std::string text;
  char number[32];
  if (c.tiltDeg > 0) {
    std::snprintf(number, sizeof number, "%.0f degrees", c.tiltDeg);
    text = std::string("tilt the ") + kSides[eighth] + " away by " + number;
  } else {
    text = "hold it straight to the camera";
  }
  if (c.turnDeg > 0) {
    std::snprintf(number, sizeof number, "%.0f degrees", c.turnDeg);
    text += std::string(", turned by ") + number + " in its plane";
  }
  const auto third = [](int at, int count, const char* low, const char* high) -> std::string {
    const double place = (at + 0.5) / count;
    return place < 0.4 ? low : place > 0.6 ? high : "";
  };
  const std::string vertical = third(c.row, settings.rows, "upper", "lower"),
                    horizontal = third(c.column, settings.columns, "left", "right");
  text += ", ";
  if (vertical.empty() && horizontal.empty())
    text += "middle";
  else
    text += vertical + (vertical.empty() || horizontal.empty() ? "" : " ") + horizontal +
            (vertical.empty()     ? " side"
             : horizontal.empty() ? " middle"
                                  : "");
  std::snprintf(number, sizeof number, "%.0f mm", c.distanceMm);
  return text + " of the picture, " + number + " away";
}

/// Mean over the effects of what is left of the variance.
double remaining(const CalibrationWorth& worth, const IntrinsicCovariance& before, const IntrinsicCovariance& after) {
  double sum = 0;
  for (const auto& effect : worth.effects)
    sum += std::pow(CalibrationWorth::uncertainty(effect, after) / CalibrationWorth::uncertainty(effect, before), 2);
  return sum / static_cast<double>(worth.effects.size());
}

double medianSigmaPx(const IntrinsicsCalibration& calibration) {
  // Of each coordinate; RMS is of the distance.
  constexpr double kLeastPx = 0.01;
  return std::max(kLeastPx, calibration.camera.rmsPx / std::sqrt(2.0));
}

}  // namespace

double usualDistanceMm(const IntrinsicsCalibration& calibration, const PlanarTarget& target) {
  const std::vector<double> distances = distancesOf(calibration, target);
  double sum = 0;
  for (const double d : distances) sum += d;
  return distances.empty() ? 0 : sum / static_cast<double>(distances.size());
}

Expected<NextPose> nextPose(const IntrinsicsCalibration& calibration, const PlanarTarget& target,
                            const CalibrationWorth& worth, const NextPoseSettings& settings) {
  const std::vector<double> distances = distancesOf(calibration, target);
  if (distances.empty() || !(calibration.camera.covariance(0, 0) > 0))
    return inputError("", "the next pose is worked out from a first calibration; take a few tilted pictures");
  const Intrinsics& in = calibration.camera.intrinsics;
  std::vector<Eigen::Vector3d> points;
  for (const Point2& p : target.points()) points.emplace_back(p.x(), p.y(), 0);
  const Eigen::Vector3d middle = middleOf(target);
  const double sigmaPx = medianSigmaPx(calibration), radiusMm = target.diameterMm / 2;
  const Information known(calibration.variant, calibration.camera.covariance);

  const std::vector<Candidate> candidates = candidatesOf(distances, settings);
  std::vector<double> left(candidates.size(), 1e300);
  const auto covarianceWith = [&](const Candidate& c) {
    const Extrinsics pose = poseOf(c, in, middle, settings);
    Information information = known;
    information.add(in, pose, points, radiusMm, seenFrom(pose, in, points, radiusMm, sigmaPx));
    return information.covariance();
  };
  parallelFor(candidates.size(), [&](std::size_t i) {
    const Extrinsics pose = poseOf(candidates[i], in, middle, settings);
    const auto seen = seenFrom(pose, in, points, radiusMm, sigmaPx).size();
    if (static_cast<double>(seen) < settings.minPointShare * static_cast<double>(points.size())) return;
    left[i] = remaining(worth, calibration.camera.covariance, covarianceWith(candidates[i]));
  });
  const auto best = static_cast<std::size_t>(std::min_element(left.begin(), left.end()) - left.begin());
  if (!(left[best] < 1e299)) return inputError("", "the target is larger than the picture; take a smaller one");

  NextPose next;
  next.cameraFromTarget = poseOf(candidates[best], in, middle, settings);
  next.outlinePx = outlineOf(target, next.cameraFromTarget, in);
  next.words = wordsFor(candidates[best], settings);
  next.remainingShare = left[best];
  const IntrinsicCovariance after = covarianceWith(candidates[best]);
  for (const auto& effect : worth.effects)
    next.gains.push_back({effect.dimension, CalibrationWorth::uncertainty(effect, calibration.camera.covariance),
                          CalibrationWorth::uncertainty(effect, after)});
  return next;
}

}  // namespace vignole
