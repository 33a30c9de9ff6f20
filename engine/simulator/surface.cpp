#include "engine/simulator/surface.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/simulator/hashing.h"

namespace vignole::simulator {

namespace {

constexpr int kAround = 128, kAlong = 1024;  // cells
constexpr double kAroundMm = 6, kAlongMm = 8;
constexpr float kBareReflectance = 0.85F;
constexpr float kBorder = 0.04F;  // of rank: how soft a patch's border is
constexpr float kGlossShare = 0.01F, kGlossGain = 3;

std::vector<float> whiteNoise(Draws draws, std::size_t count) {
  std::vector<float> field(count);
  for (float& value : field) value = static_cast<float>(draws.normal());
  return field;
}

std::vector<double> gaussian(double sigma) {
  const int radius = static_cast<int>(std::ceil(3 * sigma));
  std::vector<double> kernel;
  for (int i = -radius; i <= radius; ++i) kernel.push_back(std::exp(-0.5 * i * i / (sigma * sigma)));
  return kernel;
}

/// Periodic separable filter that leaves the variance of white noise at 1.
void smooth(std::vector<float>& field, int width, int height, double sigmaX, double sigmaY) {
  const auto pass = [&](double sigma, int count, std::ptrdiff_t step, int lines, std::ptrdiff_t lineStep) {
    const std::vector<double> kernel = gaussian(sigma);
    const int radius = static_cast<int>(kernel.size() / 2);
    const double norm = std::sqrt(std::inner_product(kernel.begin(), kernel.end(), kernel.begin(), 0.0));
    std::vector<float> line(static_cast<std::size_t>(count + 2 * radius));
    for (int l = 0; l < lines; ++l) {
      float* first = field.data() + l * lineStep;
      for (int i = 0; i < count + 2 * radius; ++i)
        line[static_cast<std::size_t>(i)] = first[(i + count - radius) % count * step];
      for (int i = 0; i < count; ++i) {
        double sum = 0;
        for (std::size_t k = 0; k < kernel.size(); ++k) sum += kernel[k] * line[static_cast<std::size_t>(i) + k];
        first[i * step] = static_cast<float>(sum / norm);
      }
    }
  };
  pass(sigmaX, width, 1, height, width);
  pass(sigmaY, height, width, width, 1);
}

float softStep(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0F, 1.0F);
  return t * t * (3 - 2 * t);
}

}  // namespace

SkinTexture::SkinTexture(std::uint64_t seed)
    : ranks_(whiteNoise(Draws(seed, Stream::Scale), std::size_t{kAround} * kAlong)) {
  smooth(ranks_, kAround, kAlong, 1.5, 2);  // patches of about 10-40 mm
  std::vector<std::uint32_t> order(ranks_.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return ranks_[a] < ranks_[b]; });
  for (std::size_t i = 0; i < order.size(); ++i)
    ranks_[order[i]] = (static_cast<float>(i) + 0.5F) / static_cast<float>(order.size());
}

float SkinTexture::rank(double aroundMm, double alongMm) const {
  const auto cell = [](double mm, double step, int count, float& share) {
    const double at = mm / step, low = std::floor(at);
    share = static_cast<float>(at - low);
    const auto index = static_cast<std::int64_t>(low) % count;
    return static_cast<int>(index < 0 ? index + count : index);
  };
  float fx = 0, fy = 0;
  const int x0 = cell(aroundMm, kAroundMm, kAround, fx), y0 = cell(alongMm, kAlongMm, kAlong, fy);
  const int x1 = (x0 + 1) % kAround, y1 = (y0 + 1) % kAlong;
  const auto at = [&](int x, int y) { return ranks_[static_cast<std::size_t>(y * kAround + x)]; };
  return (1 - fy) * ((1 - fx) * at(x0, y0) + fx * at(x1, y0)) + fy * ((1 - fx) * at(x0, y1) + fx * at(x1, y1));
}

Surface::Surface(std::uint64_t seed) : skin_(seed) {}

float Surface::reflectance(double aroundMm, double alongMm, double scaleShare) const {
  if (scaleShare <= 0) return kBareReflectance;
  const auto threshold = static_cast<float>(1 - scaleShare);
  const float patch =
      scaleShare >= 1 ? 1 : softStep(threshold - kBorder / 2, threshold + kBorder / 2, skin_.rank(aroundMm, alongMm));
  // Shades vary faster along the rail than the patches do.
  const float shade = 0.3F + 0.4F * skin_.rank(aroundMm + 311, 1.7 * alongMm + 2777);
  const float bare =
      1 + kGlossGain * softStep(1 - 2 * kGlossShare, 1, skin_.rank(2 * aroundMm + 97, 3.1 * alongMm + 5501));
  return kBareReflectance * (patch * shade + (1 - patch) * bare);
}

std::vector<float> speckleField(std::uint64_t seed, double contrast) {
  if (!(contrast > 0)) return std::vector<float>(std::size_t{kSpeckleSize} * kSpeckleStride, 1.0F);
  std::vector<float> field = whiteNoise(Draws(seed, Stream::Speckle), std::size_t{kSpeckleSize} * kSpeckleSize);
  smooth(field, kSpeckleSize, kSpeckleSize, kSpeckleGrainSigma, kSpeckleGrainSigma);
  // Gamma of shape k = 1/contrast^2 and mean 1 from a normal deviate (Wilson and Hilferty 1931).
  const auto v = static_cast<float>(contrast * contrast / 9);
  std::vector<float> padded(std::size_t{kSpeckleSize} * kSpeckleStride);
  for (int y = 0; y < kSpeckleSize; ++y)
    for (int x = 0; x < kSpeckleStride; ++x) {
      const float z = field[static_cast<std::size_t>(y * kSpeckleSize + x % kSpeckleSize)];
      const float root = std::max(0.0F, 1 - v + z * std::sqrt(v));
      padded[static_cast<std::size_t>(y * kSpeckleStride + x)] = root * root * root;
    }
  return padded;
}

std::vector<double> speckleCorrelation() {
  const std::vector<double> kernel = gaussian(kSpeckleGrainSigma);
  std::vector<double> correlation(kernel.size(), 0.0);
  for (std::size_t lag = 0; lag < kernel.size(); ++lag)
    for (std::size_t i = 0; i + lag < kernel.size(); ++i) correlation[lag] += kernel[i] * kernel[i + lag];
  const double variance = correlation.front();
  for (double& c : correlation) c /= variance;
  return correlation;
}

}  // namespace vignole::simulator
