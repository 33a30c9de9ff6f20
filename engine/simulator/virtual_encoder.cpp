#include "engine/simulator/virtual_encoder.h"

#include <cmath>

#include "engine/simulator/hashing.h"

namespace vignole {

std::vector<VirtualEncoderReading> driveVirtualRail(const VirtualEncoderSettings& settings, double lengthMm,
                                                    int readings) {
  simulator::Draws draws(settings.seed, simulator::Stream::Encoder, {});
  const double phase = draws.uniform(0, 1), phase2 = draws.uniform(0, 1);  // of the discs, in pulses
  std::vector<VirtualEncoderReading> all;
  for (int i = 0; i < readings; ++i) {
    const double z = lengthMm * i / (readings - 1), pulses = z / settings.mmPerPulse;
    VirtualEncoderReading reading;
    reading.count = std::floor(phase + pulses);
    reading.count2 = std::floor(phase2 + pulses * (1 - settings.slipPpm * 1e-6));
    reading.xMm = settings.sidewaysShare * z + settings.seenMm * draws.normal();
    reading.yMm = settings.upwardsShare * z + settings.seenMm * draws.normal();
    all.push_back(reading);
  }
  return all;
}

}  // namespace vignole
