#pragma once
// How the dimensions of a virtual rail vary along its length.
//
// The law: each dimension is its nominal + mean + amplitude * (0.5 sin + 0.3 sin + 0.2 sin) of the position along the
// rail, wavelengths drawn from 2-40 m, phases drawn. Amplitudes are about a quarter of class X of EN 13674-1. What
// cannot vary apart follows: HWA follows HW; RAS_l and RAS_r share FW - HW, of which a shift of the head against the
// foot gives one more and the other less.

#include <array>
#include <cstdint>
#include <optional>

#include "engine/geometry/expected.h"
#include "engine/rail/dimension.h"
#include "engine/simulator/displaced_outline.h"

namespace vignole::simulator {

/// Immutable.
class ShapeLaw {
 public:
  /// Refuses constant deviations that contradict each other (HW and HWA; FW, HW, RAS_l and RAS_r).
  [[nodiscard]] static Expected<ShapeLaw> create(std::uint64_t seed, bool vary, const CrownLatitude& crown,
                                                 const PerDimension<std::optional<double>>& deviationMm);
  [[nodiscard]] OutlineDeviation at(double positionMm) const;

 private:
  struct Sine {
    double waveNumber, phase;  // 1/mm, rad
  };
  struct Variation {
    double mean = 0, amplitude = 0;
    std::array<Sine, 3> sines{};
    [[nodiscard]] double at(double positionMm) const;
  };
  PerDimension<Variation> variations_{};
  Variation headShift_;
  bool headAtArema_ = false;
  PerDimension<std::optional<double>> fixed_{};
};

}  // namespace vignole::simulator
