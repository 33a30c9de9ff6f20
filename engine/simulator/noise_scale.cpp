#include "engine/simulator/noise_scale.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/optics/intrinsics_toml.h"

namespace vignole::simulator {

namespace {

constexpr double kMostReadNoiseDn = 50;

}  // namespace

Effects withNoise(const Effects& effects, double factor) {
  Effects scaled = effects;
  scaled.readNoiseDn *= factor;
  scaled.shotNoise *= factor * factor;
  scaled.speckle *= factor;
  return scaled;
}

double medianBoundPx(const std::vector<LineLight>& places, const Effects& effects) {
  if (places.empty()) return std::numeric_limits<double>::infinity();
  const PictureNoise noise = pictureNoise(effects);
  std::vector<double> information;
  information.reserve(places.size());
  for (const LineLight& place : places) information.push_back(informationPerPx(place, noise));
  const auto middle = information.begin() + static_cast<std::ptrdiff_t>(information.size() / 2);
  std::nth_element(information.begin(), middle, information.end());
  return 1 / std::sqrt(*middle);
}

Expected<double> noiseFactorFor(double boundPx, const std::vector<LineLight>& places, const Effects& effects) {
  const auto refuse = [&](const std::string& why) { return inputError("noise-px " + number(boundPx), why); };
  double most = 100;
  if (effects.speckle > 0) most = std::min(most, 1 / effects.speckle);
  if (effects.readNoiseDn > 0) most = std::min(most, kMostReadNoiseDn / effects.readNoiseDn);
  if (effects.speckle <= 0 && effects.readNoiseDn <= 0 && effects.shotNoise <= 0)
    return refuse("there is no noise to scale: read-noise, shot-noise and speckle are off; turn one on");
  // The bound is almost proportional to the factor, so that each step almost arrives; halving where it does not.
  constexpr double kClose = 1e-4, kLeast = 1e-4;
  double low = 0, high = most, factor = std::min(1.0, most);
  for (;;) {
    const double bound = medianBoundPx(places, withNoise(effects, factor));
    if (!std::isfinite(bound))
      return refuse("cannot be had: half of the lines are too faint or overexposed to be read");
    if (std::abs(bound - boundPx) <= kClose * boundPx) return factor;
    if (bound < boundPx && factor == most)
      return refuse("is more than these kinds of noise can make (speckle of contrast 1, 50 DN); choose less");
    if (bound > boundPx && factor < kLeast) return refuse("is less than rounding to whole DN leaves; choose more");
    (bound < boundPx ? low : high) = factor;
    const double next = factor * boundPx / bound;
    if (next >= high)
      factor = bound < boundPx && high == most ? most : (low + high) / 2;
    else
      factor = next > low ? next : (low + high) / 2;
    if (high - low < kClose * kLeast) return factor;
  }
}

}  // namespace vignole::simulator
