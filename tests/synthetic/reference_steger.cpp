#include "tests/synthetic/reference_steger.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vignole::synthetic {
namespace {

using Plane = std::vector<double>;

struct Kernels {
  int radius;
  std::vector<double> smooth, first, second;  // index k + radius
};

/// Integrals of the Gaussian, its first and its second derivative over each pixel; normalised on 1, x and x^2 / 2.
Kernels kernelsOf(double sigma) {
  const int radius = static_cast<int>(std::ceil(5 * sigma));
  Kernels kernels{radius, {}, {}, {}};
  const auto integral = [sigma](double x) { return 0.5 * std::erfc(-x / (sigma * std::numbers::sqrt2)); };
  const auto gauss = [sigma](double x) {
    return std::exp(-x * x / (2 * sigma * sigma)) / (sigma * std::sqrt(2 * std::numbers::pi));
  };
  const auto slope = [&](double x) { return -x / (sigma * sigma) * gauss(x); };
  double sum = 0, moment1 = 0, sum2 = 0, moment2 = 0;
  for (int k = -radius; k <= radius; ++k) {
    kernels.smooth.push_back(integral(k + 0.5) - integral(k - 0.5));
    kernels.first.push_back(gauss(k + 0.5) - gauss(k - 0.5));
    kernels.second.push_back(slope(k + 0.5) - slope(k - 0.5));
    sum += kernels.smooth.back();
    moment1 += k * kernels.first.back();
    sum2 += kernels.second.back();
  }
  for (int k = -radius; k <= radius; ++k) {
    const auto i = static_cast<std::size_t>(k + radius);
    kernels.second[i] -= sum2 / (2 * radius + 1);
    moment2 += 0.5 * k * k * kernels.second[i];
  }
  for (double& v : kernels.smooth) v /= sum;
  for (double& v : kernels.first) v /= moment1;
  for (double& v : kernels.second) v /= moment2;
  return kernels;
}

/// Correlation along rows (dx = 1) or columns (dx = 0), the border repeated.
Plane filtered(const Plane& in, int width, int height, const std::vector<double>& kernel, int radius, bool alongRows) {
  Plane out(in.size());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      double sum = 0;
      for (int k = -radius; k <= radius; ++k) {
        const int xx = alongRows ? std::clamp(x + k, 0, width - 1) : x;
        const int yy = alongRows ? y : std::clamp(y + k, 0, height - 1);
        sum += kernel[static_cast<std::size_t>(k + radius)] *
               in[static_cast<std::size_t>(yy) * static_cast<std::size_t>(width) + static_cast<std::size_t>(xx)];
      }
      out[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] = sum;
    }
  return out;
}

}  // namespace

std::vector<StripePoint> referenceSteger(const ImageView& image, const StripeSettings& settings) {
  const int width = image.width, height = image.height;
  const auto pixelCount = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  Plane picture(pixelCount);
  for (int y = 0; y < height; ++y)
    std::copy_n(image.row(y), width, picture.begin() + static_cast<std::ptrdiff_t>(y) * width);
  const Kernels k = kernelsOf(settings.sigma);
  const auto derivative = [&](const std::vector<double>& x, const std::vector<double>& y) {
    return filtered(filtered(picture, width, height, y, k.radius, false), width, height, x, k.radius, true);
  };
  const Plane rx = derivative(k.first, k.smooth), ry = derivative(k.smooth, k.first);
  const Plane rxx = derivative(k.second, k.smooth), rxy = derivative(k.first, k.first),
              ryy = derivative(k.smooth, k.second);

  const double perDn = 1 / (2 * std::numbers::sqrt2 * settings.sigma * settings.sigma);
  std::vector<StripePoint> candidates;
  std::vector<int> indexOf(pixelCount, -1);
  std::vector<int> pixelOf;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
      const double mean = (rxx[i] + ryy[i]) / 2, root = std::hypot((rxx[i] - ryy[i]) / 2, rxy[i]);
      const double eigenvalue = mean - root;
      if (-eigenvalue < settings.low * perDn || -eigenvalue < std::abs(mean + root)) continue;
      const double angle = 0.5 * std::atan2(2 * rxy[i], rxx[i] - ryy[i]) + std::numbers::pi / 2;
      const double nx = std::cos(angle), ny = std::sin(angle);
      const double t = -(rx[i] * nx + ry[i] * ny) / (rxx[i] * nx * nx + 2 * rxy[i] * nx * ny + ryy[i] * ny * ny);
      if (std::abs(t * nx) > 0.5 || std::abs(t * ny) > 0.5) continue;
      StripePoint p;
      p.x = static_cast<float>(x + t * nx);
      p.y = static_cast<float>(y + t * ny);
      p.nx = static_cast<float>(nx);
      p.ny = static_cast<float>(ny);
      p.strength = static_cast<float>(-eigenvalue / perDn);
      indexOf[i] = static_cast<int>(candidates.size());
      pixelOf.push_back(static_cast<int>(i));
      candidates.push_back(p);
    }

  std::vector<StripePoint> accepted;
  std::vector<char> seen(candidates.size(), 0);
  for (std::size_t start = 0; start < candidates.size(); ++start) {
    if (seen[start] != 0) continue;
    std::vector<std::size_t> group{start};
    seen[start] = 1;
    bool strong = false;
    for (std::size_t g = 0; g < group.size(); ++g) {
      strong = strong || candidates[group[g]].strength >= settings.high;
      const int x = pixelOf[group[g]] % width, y = pixelOf[group[g]] / width;
      for (int yy = std::max(0, y - 1); yy <= std::min(height - 1, y + 1); ++yy)
        for (int xx = std::max(0, x - 1); xx <= std::min(width - 1, x + 1); ++xx) {
          const int next =
              indexOf[static_cast<std::size_t>(yy) * static_cast<std::size_t>(width) + static_cast<std::size_t>(xx)];
          if (next < 0 || seen[static_cast<std::size_t>(next)] != 0) continue;
          seen[static_cast<std::size_t>(next)] = 1;
          group.push_back(static_cast<std::size_t>(next));
        }
    }
    if (!strong || group.size() < static_cast<std::size_t>(settings.minLength)) continue;
    for (const std::size_t g : group) accepted.push_back(candidates[g]);
  }
  return accepted;
}

}  // namespace vignole::synthetic
