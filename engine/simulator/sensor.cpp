#include "engine/simulator/sensor.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "engine/simulator/hashing.h"
#include "engine/simulator/surface.h"

namespace vignole::simulator {

namespace {

constexpr std::uint32_t kNormals = 1U << 18;
constexpr std::uint32_t kGroundPixels = kNormals;

}  // namespace

Sensor::Sensor(std::uint64_t seed, const Effects& effects, int widthPx, int heightPx)
    : effects_(effects),
      widthPx_(widthPx),
      heightPx_(heightPx),
      speckle_(speckleField(seed, effects.speckle)),
      normals_(kNormals),
      ground_(kGroundPixels + static_cast<std::size_t>(widthPx)) {
  Draws draws(seed, Stream::NoiseBank);
  for (float& n : normals_) n = static_cast<float>(draws.normal());
  const double sd =
      std::sqrt(effects.readNoiseDn * effects.readNoiseDn + effects.shotNoise * kShotPerDn * effects.ambientDn);
  for (std::size_t i = 0; i < ground_.size(); ++i)
    ground_[i] = static_cast<std::uint8_t>(
        std::clamp(std::nearbyint(effects.ambientDn + sd * normals_[i % kNormals]), 0.0, 255.0));
}

void Sensor::fillGround(const Exposure& exposure, const MutableImageView& image) const {
  const auto width = static_cast<std::size_t>(image.width);
  const auto ambient = static_cast<int>(std::nearbyint(effects_.ambientDn));
  for (int y = 0; y < image.height; ++y) {
    const std::uint64_t offset =
        hash(exposure.key, Stream::Background, {static_cast<std::uint64_t>(y)}) % (kGroundPixels - 1);
    const std::uint8_t* from = ground_.data() + offset;
    std::uint8_t* to = image.row(y);
    std::memcpy(to, from, width);
    if (exposure.black)
      for (std::size_t x = 0; x < width; ++x) to[x] = static_cast<std::uint8_t>(std::max(0, to[x] - ambient));
    else if (exposure.gain != 1)
      for (std::size_t x = 0; x < width; ++x)
        to[x] = static_cast<std::uint8_t>(
            std::min(255.0F, exposure.gain * static_cast<float>(ambient) + static_cast<float>(to[x] - ambient)));
  }
}

void Sensor::expose(const Exposure& exposure, Canvas& canvas, const MutableImageView& image) const {
  DevelopSettings settings;
  settings.gain = exposure.gain;
  settings.ambientDn = exposure.gain * static_cast<float>(effects_.ambientDn);
  settings.readVariance = static_cast<float>(effects_.readNoiseDn * effects_.readNoiseDn);
  settings.shotPerDn = static_cast<float>(effects_.shotNoise * kShotPerDn);
  settings.speckle = speckle_.data();
  settings.normals = normals_.data();
  settings.normalCount = kNormals;
  settings.key = exposure.key;
  develop(canvas, settings, image);
}

}  // namespace vignole::simulator
