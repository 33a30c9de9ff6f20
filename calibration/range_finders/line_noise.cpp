#include "calibration/range_finders/line_noise.h"

#include <algorithm>
#include <cmath>

namespace vignole {

namespace {

constexpr double kLeast = 0.2, kMost = 20;  // of the noise expected by the picture: beyond, something else is wrong
// The grain of speckle and the pixels' differences let errors reach further than the filter alone does.
constexpr double kKnownCorrelation = 1.15, kUKnownCorrelation = 0.15;
constexpr double kLeastCorrelation = 0.9, kMostCorrelation = 2.5;
constexpr double kFirstLag = 1.1, kLastLag = 2.8;  // in standard deviations of the filter

/// Two points of one arc.
struct Pair {
  double square;    ///< half the squared difference of their residuals, over the variance of one
  double distance2; ///< in variances of the filter
};

double meanMisfit(const std::vector<Pair>& pairs, double correlation) {
  double sum = 0;
  for (const Pair& p : pairs) sum += p.square - (1 - std::exp(-p.distance2 / (4 * correlation)));
  return sum / static_cast<double>(pairs.size());
}

/// By how much neighbours differ: what the unknowns took out of the residuals is smooth and hardly in their differences.
double correlationOf(const std::vector<Pair>& pairs, double independentPoints) {
  if (pairs.size() < 50) return kKnownCorrelation;
  double low = 0.3, high = 10;
  while (high - low > 1e-3) {
    const double middle = (low + high) / 2;
    (meanMisfit(pairs, middle) < 0 ? low : high) = middle;  // expected differences fall as correlation grows
  }
  // Each independent point tells the variogram to sqrt(2); its slope by the correlation is about 0.37.
  const double variance = 2 / (0.37 * 0.37 * std::max(independentPoints, 1.0));
  const double known = 1 / (kUKnownCorrelation * kUKnownCorrelation);
  const double both = ((low + high) / 2 / variance + kKnownCorrelation * known) / (1 / variance + known);
  return std::clamp(both, kLeastCorrelation, kMostCorrelation);
}

}  // namespace

void refineNoise(ArcAdjustment& adjustment, std::span<const int> cameras, const PinPlate& plate,
                 const std::vector<ArcObservation>& arcs) {
  const Influence answers = influence(adjustment, plate, cameras, adjustment.freedom);
  std::vector<Pair> pairs;
  double independent = 0;
  for (const int c : cameras) {
    const auto camera = static_cast<std::size_t>(c);
    CameraLight& light = adjustment.lights[camera];
    double square = 0, count = 0, shared = 1;
    for (const ArcObservation& arc : arcs) {
      if (arc.camera != c || !arc.used()) continue;
      shared = arc.correlatedPoints(light);
      for (std::size_t i = 0; i < arc.inside.size(); ++i) {
        if (arc.inside[i] == 0) continue;
        square += arc.weight[i] * std::pow(arc.residualPx[i] / arc.sigmaPx[i], 2);
        count += arc.weight[i];
      }
    }
    const double freedom = count - shared * answers.parameters[camera];
    if (!(freedom > 0.2 * count)) continue;
    light.noise = std::clamp(std::sqrt(square / freedom), kLeast, kMost);
    independent += count / shared;

    for (const ArcObservation& arc : arcs) {
      if (arc.camera != c || !arc.used()) continue;
      const double filter = std::sqrt(arc.filterPx2);
      for (std::size_t i = 0; i < arc.inside.size(); ++i) {
        if (arc.inside[i] == 0 || arc.weight[i] < 0.99) continue;
        for (std::size_t k = i + 1; k < arc.inside.size(); ++k) {
          const double distance = (arc.arcPx[k] - arc.arcPx[i]) / filter;
          if (distance < kFirstLag || arc.inside[k] == 0 || arc.weight[k] < 0.99) continue;
          if (distance > kLastLag) break;
          const double difference =
              (arc.residualPx[k] / arc.sigmaPx[k] - arc.residualPx[i] / arc.sigmaPx[i]) / light.noise;
          pairs.push_back({difference * difference / 2, distance * distance});
        }
      }
    }
  }
  const double correlation = correlationOf(pairs, independent);
  for (const int c : cameras) adjustment.lights[static_cast<std::size_t>(c)].correlation = correlation;
}

}  // namespace vignole
