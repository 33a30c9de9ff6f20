#pragma once
// Profiles sampled from a section's outline: four cameras, noise along the normal, outliers, cameras that are missing.

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "engine/profile/profile.h"
#include "engine/rail/section.h"

namespace vignole::synthetic {

struct ProfileRequest {
  int points = 2000;
  double noiseMm = 0.03;
  double outlierShare = 0;
  int missingCamera = -1;
  Transform2 worldFromSection;
  std::uint64_t seed = 1;
  double correlated = 1;  ///< > 1: errors are a moving average over this many neighbours
};

/// Camera 0 top left, 1 top right, 2 bottom right, 3 bottom left.
inline std::uint8_t cameraSeeing(const Point2& p, const Point2& normal, double middleHeightMm) {
  const bool top = normal.y() > 0.3 || (std::abs(normal.y()) <= 0.3 && p.y() > middleHeightMm);
  return static_cast<std::uint8_t>(top ? (p.x() < 0 ? 0 : 1) : (p.x() < 0 ? 3 : 2));
}

inline std::vector<double> errors(std::size_t n, double sigma, double correlated, std::mt19937_64& random) {
  std::normal_distribution<double> normal(0, 1);
  const auto width = static_cast<std::size_t>(std::lround(std::max(1.0, correlated)));
  std::vector<double> white(n + width), result(n);
  for (double& w : white) w = normal(random);
  for (std::size_t i = 0; i < n; ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < width; ++k) sum += white[i + k];
    result[i] = sigma * sum / std::sqrt(static_cast<double>(width));
  }
  return result;
}

/// `primitives`: the outline, counter-clockwise; may differ from the section that will be measured.
inline Profile sample(const std::vector<Primitive>& primitives, const ProfileRequest& request) {
  std::mt19937_64 random(request.seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  double perimeter = 0, top = 0;
  for (const Primitive& p : primitives) {
    perimeter += length(p);
    top = std::max(top, startPoint(p).y());
  }
  const double step = perimeter / request.points;
  const auto error = errors(static_cast<std::size_t>(request.points), request.noiseMm, request.correlated, random);
  Profile profile;
  profile.correlatedPoints = static_cast<float>(request.correlated);
  double s = uniform(random) * step, base = 0;
  std::size_t k = 0;
  for (std::size_t i = 0; i < error.size(); ++i, s += step) {
    while (k + 1 < primitives.size() && s - base > length(primitives[k])) base += length(primitives[k++]);
    const Point2 p = pointAt(primitives[k], s - base), n = normalAt(primitives[k], s - base);
    ProfilePoint point;
    point.camera = cameraSeeing(p, n, 0.4 * top);
    if (point.camera == request.missingCamera) continue;
    Point2 q = p + error[i] * n;
    if (uniform(random) < request.outlierShare)
      q = {220 * (uniform(random) - 0.5), top / 2 + 240 * (uniform(random) - 0.5)};
    const Point2 inWorld = request.worldFromSection * q;
    point.x = inWorld.x();
    point.y = inWorld.y();
    point.sigmaMm = static_cast<float>(request.noiseMm > 0 ? request.noiseMm : 0.01);
    point.strength = 60;
    profile.points.push_back(point);
  }
  if (request.missingCamera >= 0) profile.missing[static_cast<std::size_t>(request.missingCamera)] = "frame lost";
  for (const ProfilePoint& p : profile.points) ++profile.pointsOfCamera[p.camera];
  return profile;
}

inline std::vector<Primitive> outlineOf(const Section& section) {
  std::vector<Primitive> result;
  for (const auto& p : section.primitives) result.push_back(p.shape);
  return result;
}

inline Profile sample(const Section& section, const ProfileRequest& request) {
  return sample(outlineOf(section), request);
}

/// Section turned about its middle and shifted.
inline Transform2 pose(double xMm, double yMm, double degrees, double middleMm = 86) {
  const Transform2 turn{0, 0, degrees * std::numbers::pi / 180};
  const Point2 t = Point2(xMm, yMm + middleMm) - turn.rotate({0, middleMm});
  return {t.x(), t.y(), turn.angleRad};
}

}  // namespace vignole::synthetic
