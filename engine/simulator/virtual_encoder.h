#pragma once
// The rotary encoder of the virtual rig: what it counts while the rail is driven a known way, and where the rail was
// seen across the line meanwhile.

#include <cstdint>
#include <vector>

namespace vignole {

struct VirtualEncoderSettings {
  double mmPerPulse = 0.05;     ///< true, of the first encoder
  double sidewaysShare = 4e-4;  ///< the rail's way is not quite the normal of the light plane: x, per mm
  double upwardsShare = -2e-4;  ///< y, per mm
  double seenMm = 0.003;        ///< standard deviation of a place of the rail as it is measured
  double slipPpm = 0;           ///< the second encoder loses this share of its pulses
  std::uint64_t seed = 1;
};

struct VirtualEncoderReading {
  double count = 0, count2 = 0;  ///< whole pulses
  double xMm = 0, yMm = 0;
};

/// From 0 to `lengthMm`, `readings` (at least two) evenly apart. The same settings, the same readings.
[[nodiscard]] std::vector<VirtualEncoderReading> driveVirtualRail(const VirtualEncoderSettings& settings,
                                                                  double lengthMm, int readings);

}  // namespace vignole
