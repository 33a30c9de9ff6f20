#include <algorithm>
#include <cmath>

#include "engine/registration/registration.h"

namespace vignole {
namespace {

constexpr double kCapMm = 1.0;
constexpr double kFallbackSigmaMm = 0.03;

double chi2OfAll(std::span<const ProfilePoint> points, const Registration& registration) {
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double sigma = points[i].sigmaMm > 0 ? points[i].sigmaMm : kFallbackSigmaMm;
    const double distance = registration.primitiveOfPoint[i] < 0 ? kCapMm : std::abs(registration.residualMm[i]);
    sum += std::pow(std::min(distance, kCapMm) / sigma, 2);
  }
  return points.empty() ? 0 : sum / static_cast<double>(points.size());
}

}  // namespace

std::vector<RailMatch> bestMatch(std::span<const ProfilePoint> points, std::span<const Section> sections,
                                 const RegistrationSettings& settings) {
  std::vector<RailMatch> matches;
  Registration registration;
  for (const Section& section : sections) {
    Registrar(section, settings).registerProfile(points, registration);
    matches.push_back({section.name, chi2OfAll(points, registration)});
  }
  std::stable_sort(matches.begin(), matches.end(),
                   [](const RailMatch& a, const RailMatch& b) { return a.chi2 < b.chi2; });
  return matches;
}

}  // namespace vignole
