#include "engine/simulator/noise_scale.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
  const auto refuse = [&](const std::string& why) { return inputError("noise-px " + std::to_string(boundPx), why); };
  double most = 100;
  if (effects.speckle > 0) most = std::min(most, 1 / effects.speckle);
  if (effects.readNoiseDn > 0) most = std::min(most, kMostReadNoiseDn / effects.readNoiseDn);
  if (effects.speckle <= 0 && effects.readNoiseDn <= 0 && effects.shotNoise <= 0)
    return refuse("there is no noise to scale: read-noise, shot-noise and speckle are off; turn one on");
  double low = 0, high = most;
  if (medianBoundPx(places, withNoise(effects, low)) > boundPx)
    return refuse("is less than rounding to whole DN leaves; choose more");
  if (medianBoundPx(places, withNoise(effects, high)) < boundPx)
    return refuse("is more than these kinds of noise can make (speckle of contrast 1, 50 DN); choose less");
  while (high - low > 1e-4 * high) {
    const double middle = (low + high) / 2;
    (medianBoundPx(places, withNoise(effects, middle)) < boundPx ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace vignole::simulator
