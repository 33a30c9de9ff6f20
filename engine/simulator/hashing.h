#pragma once
// Randomness as a pure function of what it belongs to: no state, so any thread in any order draws the same numbers.

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <numbers>

namespace vignole::simulator {

/// What a random number is for; keeps the streams apart.
enum class Stream : std::uint64_t {
  Rig = 1,
  Shape,
  Wander,
  Vibration,
  NoiseBank,
  Background,
  PixelNoise,
  Speckle,
  SpeckleOffset,
  Scale,
  Gloss,
  Ghost,
  Loss,
  Missed,
  Plate,
  Placement,
  Spurious,
  Target,
  View,
  IntrinsicsError,
  Encoder
};

/// SplitMix64's finaliser (Steele, Lea, Flood 2014).
[[nodiscard]] inline std::uint64_t mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

[[nodiscard]] inline std::uint64_t hash(std::uint64_t seed, Stream stream, std::initializer_list<std::uint64_t> keys) {
  std::uint64_t h = mix(seed ^ mix(static_cast<std::uint64_t>(stream)));
  for (const std::uint64_t key : keys) h = mix(h ^ key);
  return h;
}

/// A counter-based sequence: the n-th number is mix(key + n).
class Draws {
 public:
  Draws(std::uint64_t seed, Stream stream, std::initializer_list<std::uint64_t> keys = {})
      : key_(hash(seed, stream, keys)) {}
  [[nodiscard]] std::uint64_t bits() { return mix(key_ + 0x632be59bd9b4e019ULL * ++count_); }
  /// [0, 1)
  [[nodiscard]] double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  [[nodiscard]] double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Standard normal (Box-Muller).
  [[nodiscard]] double normal() {
    const double u = 1 - uniform(), v = uniform();
    return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * v);
  }

 private:
  std::uint64_t key_;
  std::uint64_t count_ = 0;
};

}  // namespace vignole::simulator
