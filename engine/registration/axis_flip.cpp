#include <algorithm>
#include <array>
#include <cmath>

#include "engine/registration/registration.h"

namespace vignole {
namespace {

constexpr double kCapMm = 1.0;
constexpr double kFallbackSigmaMm = 0.03;
constexpr double kClearlyBetter = 0.9;

std::vector<ProfilePoint> flipped(const std::vector<ProfilePoint>& points, AxisFlip flip) {
  std::vector<ProfilePoint> result = points;
  for (ProfilePoint& p : result) {
    if (flip.x) p.x = -p.x, p.nx = -p.nx;
    if (flip.y) p.y = -p.y, p.ny = -p.ny;
  }
  return result;
}

}  // namespace

double chi2OfAllPoints(std::span<const ProfilePoint> points, const Registration& registration) {
  if (points.empty() || registration.primitiveOfPoint.size() != points.size()) return 0;
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double sigma = points[i].sigmaMm > 0 ? points[i].sigmaMm : kFallbackSigmaMm;
    const double distance = registration.primitiveOfPoint[i] < 0 ? kCapMm : std::abs(registration.residualMm[i]);
    sum += std::pow(std::min(distance, kCapMm) / sigma, 2);
  }
  return sum / static_cast<double>(points.size());
}

AxisFlip registerEitherWay(std::vector<ProfilePoint>& points, const Section& section, Registrar& registrar,
                           Registration& result) {
  registrar.registerProfile(points, result);
  if (points.empty()) return {};
  AxisFlip best;
  std::vector<ProfilePoint> bestPoints = points;
  Registration candidate;
  double least = chi2OfAllPoints(points, result);
  for (const AxisFlip flip : std::array<AxisFlip, 3>{{{false, true}, {true, true}, {true, false}}}) {
    if (flip.x && section.symmetric()) continue;
    std::vector<ProfilePoint> turned = flipped(points, flip);
    registrar.registerProfile(turned, candidate);
    const double chi2 = chi2OfAllPoints(turned, candidate);
    if (chi2 > kClearlyBetter * least) continue;
    least = chi2;
    best = flip;
    bestPoints = std::move(turned);
    result = candidate;
  }
  points = std::move(bestPoints);
  return best;
}

}  // namespace vignole
