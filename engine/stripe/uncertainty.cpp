#include "engine/stripe/uncertainty.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vignole {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr float kMedianOfSquare = 0.45494F;  // of a squared standard normal number
constexpr float kAgreeing = 0.6F;
constexpr std::size_t kFewest = 24;  // samples; fewer say nothing about speckle

/// Correlation of the errors of two points that far apart along the line: both come from white noise smoothed by sigma.
float correlation(float distancePx, float sigma) {
  const float z = distancePx / (2 * sigma);
  return std::exp(-z * z);
}

float median(std::vector<float>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

double ridgePerContrast(double s, double sigma) { return s / std::pow(s * s + sigma * sigma, 1.5); }
double ridgeNoise(double sigma) { return std::sqrt(3 / (16 * kPi)) / (sigma * sigma * sigma); }
double gradientNoise(double sigma) { return 1 / (std::sqrt(8 * kPi) * sigma * sigma); }

// Noise C A exp(-x^2 / 2 s^2) xi(x, y) through g'(x) g(y) and g''(x) g(y): the integrals of their squares against the
// squared profile, with q^2 = sigma^2 s^2 / v, M_n = int x^n exp(-x^2 / q^2) dx.
SpeckleGain speckleGain(float s2, float sigma2) {
  constexpr auto kRootPi = static_cast<float>(1 / std::numbers::inv_sqrtpi);
  const float v = s2 + sigma2, q2 = sigma2 * s2 / v;
  const float m0 = kRootPi * std::sqrt(q2), m2 = m0 * q2 / 2, m4 = m2 * q2 * 1.5F;
  const float sigma4 = sigma2 * sigma2;
  const float alongLine = 1 / (2 * kRootPi * std::sqrt(sigma2));
  const float common = alongLine / (2 * std::numbers::pi_v<float> * sigma2) * (v * v * v / s2);  // (A / ridge)^2
  return {common * m2 / sigma4, common * (m4 / (sigma4 * sigma4) - 2 * m2 / (sigma4 * sigma2) + m0 / sigma4)};
}

void SpeckleMeter::begin(const RidgeFilter& filter, double noiseDn) {
  sigma_ = static_cast<float>(std::sqrt(filter.variancePx2));
  positionNoise2_ = static_cast<float>(std::pow(noiseDn * filter.gradientNoise, 2));
  ridgeNoise2_ = static_cast<float>(std::pow(noiseDn * filter.ridgeNoise, 2));
  fromPosition_.clear();
  fromRidge_.clear();
}

// Third differences over steps of about 2 sigma: they are blind to a steady bend and to a steady change of strength.
void SpeckleMeter::add(const LinePoints& p, const LineRange& line) {
  const auto lag = static_cast<std::size_t>(std::lround(1.8F * sigma_));
  if (line.count <= 3 * lag) return;
  const std::uint8_t useless = kSaturated | kLineEnd | kGapEdge;
  // Neighbouring samples see the same speckle: every fifth point is enough.
  for (std::size_t i = line.first; i + 3 * lag < line.end(); i += 5) {
    const std::size_t a = i, b = i + lag, c = i + 2 * lag, d = i + 3 * lag;
    if (((p.flags[a] | p.flags[b] | p.flags[c] | p.flags[d]) & useless) != 0) continue;
    const float step = (p.arc[d] - p.arc[a]) / 3;
    const float one = correlation(step, sigma_), two = one * one * one * one;
    const float gain = 20 - 30 * one + 12 * two - 2 * two * two * one;  // of the variance of independent errors
    const float nx = p.nx[b] + p.nx[c], ny = p.ny[b] + p.ny[c];
    const float dx = p.x[d] - 3 * p.x[c] + 3 * p.x[b] - p.x[a];
    const float dy = p.y[d] - 3 * p.y[c] + 3 * p.y[b] - p.y[a];
    const float moved2 = (dx * nx + dy * ny) * (dx * nx + dy * ny) / (nx * nx + ny * ny);
    const float rb = p.ridge[b], rc = p.ridge[c];
    const float ridge = 0.25F * (p.ridge[a] + rb + rc + p.ridge[d]);
    const float flicker = std::log(p.ridge[d] * rb * rb * rb / (rc * rc * rc * p.ridge[a]));
    const SpeckleGain speckle = speckleGain(0.5F * (p.s2[b] + p.s2[c]), sigma_ * sigma_);
    // The median of (squared difference / its expectation) is known; each sample says which speckle would put it there.
    const float perRidge2 = 1 / (ridge * ridge), scale = 1 / (gain * kMedianOfSquare);
    fromPosition_.push_back((moved2 * scale - positionNoise2_ * perRidge2) / speckle.positionPx2);
    fromRidge_.push_back((flicker * flicker * scale - ridgeNoise2_ * perRidge2) / speckle.ridge);
  }
}

float SpeckleMeter::speckle() {
  if (fromPosition_.size() < kFewest) return 0;
  const float a = std::max(0.0F, median(fromPosition_)), b = std::max(0.0F, median(fromRidge_));
  // Two answers that agree within their noise are one; the lesser of them would be too small.
  return std::min(a, b) > kAgreeing * std::max(a, b) ? (a + b) / 2 : std::min(a, b);
}

float endSigma(float edgePx, double sigma) { return 0.3F * std::exp(-edgePx / static_cast<float>(sigma)); }

}  // namespace vignole
