#include "engine/stripe/uncertainty.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vignole {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr float kMedianOfSquare = 0.45494F;  // of a squared standard normal number
constexpr std::size_t kFewest = 24;          // samples; fewer say nothing about speckle

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
void SpeckleMeter::add(std::span<const ChainPoint> line) {
  const auto lag = static_cast<std::size_t>(std::lround(1.8F * sigma_));
  const std::uint8_t useless = kSaturated | kLineEnd | kGapEdge;
  for (std::size_t i = 0; i + 3 * lag < line.size(); i += 2) {
    const ChainPoint &a = line[i], &b = line[i + lag], &c = line[i + 2 * lag], &d = line[i + 3 * lag];
    if (((a.point.flags | b.point.flags | c.point.flags | d.point.flags) & useless) != 0) continue;
    const float step = (d.arcPx - a.arcPx) / 3;
    const float one = correlation(step, sigma_), two = one * one * one * one;
    const float gain = 20 - 30 * one + 12 * two - 2 * two * two * one;  // of the variance of independent errors
    const float nx = b.point.nx + c.point.nx, ny = b.point.ny + c.point.ny;
    const float dx = d.point.x - 3 * c.point.x + 3 * b.point.x - a.point.x;
    const float dy = d.point.y - 3 * c.point.y + 3 * b.point.y - a.point.y;
    const float moved2 = (dx * nx + dy * ny) * (dx * nx + dy * ny) / (nx * nx + ny * ny);
    const float ridge = 0.25F * (a.ridge + b.ridge + c.ridge + d.ridge);
    const float flicker = std::log(d.ridge * b.ridge * b.ridge * b.ridge / (c.ridge * c.ridge * c.ridge * a.ridge));
    const SpeckleGain speckle = speckleGain(0.5F * (b.s2 + c.s2), sigma_ * sigma_);
    // The median of (squared difference / its expectation) is known; each sample says which speckle would put it there.
    const float perRidge2 = 1 / (ridge * ridge), scale = 1 / (gain * kMedianOfSquare);
    fromPosition_.push_back((moved2 * scale - positionNoise2_ * perRidge2) / speckle.positionPx2);
    fromRidge_.push_back((flicker * flicker * scale - ridgeNoise2_ * perRidge2) / speckle.ridge);
  }
}

float SpeckleMeter::speckle() {
  if (fromPosition_.size() < kFewest) return 0;
  return std::max(0.0F, std::min(median(fromPosition_), median(fromRidge_)));
}

void setUncertainty(std::span<ChainPoint> line, const RidgeFilter& filter, double noiseDn, float speckle) {
  const double sigma = std::sqrt(filter.variancePx2);
  const auto sigma2 = static_cast<float>(filter.variancePx2);
  const auto gradient = static_cast<float>(noiseDn * filter.gradientNoise);
  const auto reach = static_cast<std::size_t>(std::lround(2.6 * sigma));  // points are 1.13 px apart on average
  for (std::size_t i = 0; i < line.size(); ++i) {
    ChainPoint& c = line[i];
    const float noise = gradient / c.ridge;
    float variance = noise * noise + speckle * speckleGain(c.s2, sigma2).positionPx2;
    const std::size_t k = std::min({reach, i, line.size() - 1 - i});
    if (k > 0) {
      // Curvature from the chords to both sides: f(h)/h + f(-h')/h' = curvature / 2 (h + h'), whatever the slope.
      const StripePoint &p = c.point, &a = line[i - k].point, &b = line[i + k].point;
      const float back = c.arcPx - line[i - k].arcPx, forth = line[i + k].arcPx - c.arcPx;
      const float bend =
          ((b.x - p.x) * p.nx + (b.y - p.y) * p.ny) / forth + ((a.x - p.x) * p.nx + (a.y - p.y) * p.ny) / back;
      const float pull = k == reach ? sigma2 * bend / (back + forth) : 0;
      variance += pull * pull;
    }
    const float end = 0.3F * std::exp(-c.edgePx / static_cast<float>(sigma));
    c.point.sigmaPx = std::sqrt(variance + end * end);
  }
}

}  // namespace vignole
