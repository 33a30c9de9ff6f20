#pragma once
// The rotary encoder: the rail's motion vector V a pulse (paper section III-A) from counts over a known length.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/geometry/expected.h"

namespace vignole {

/// One row: the counter and where the body was seen across the line, world frame. The first row stands at the start of
/// the known length, the last one at its end.
struct EncoderReading {
  double count = 0;  ///< whole pulses
  double xMm = 0, yMm = 0;
  std::optional<double> count2;  ///< of a second encoder
};

struct EncoderSettings {
  double lengthMm = 0;          ///< travel from the first to the last reading
  double uLengthMm = 0;         ///< its standard uncertainty
  std::optional<double> ratio;  ///< pulses of the second encoder for one of the first; empty: the whole number (or one
                                ///< over it) within 2 % of what is seen
};

struct PerPulse {
  double mm = 0;
  std::optional<double> uMm;  ///< standard uncertainty; empty with fewer than three readings
};

/// How far two encoders disagree over the travel.
struct EncoderSlip {
  double ratio = 1;       ///< that was expected
  double mmPerPulse = 0;  ///< V^z of the second encoder
  double uMmPerPulse = 0;
  double ppm = 0, uPpm = 0;  ///< of the second against the first: (seen ratio / ratio - 1) 1e6; standard, by the pulses
  double worstJump = 0;      ///< largest disagreement from one reading to the next, pulses of the first
  std::size_t worstRow = 0;  ///< reading after it, from 0
};

struct EncoderCalibration {
  double counts = 0;  ///< over the length, > 0 also where the counter falls
  bool falling = false;
  PerPulse vz;  ///< L / counts; u = sqrt(u_L^2 + 2 (V^z / sqrt 12)^2) / counts: both readings are rounded to a pulse
  PerPulse vx, vy;  ///< slope of x and y over the counts
  std::optional<EncoderSlip> slip;
};

/// CSV with a header that names `count`, `x_mm`, `y_mm` and may name `count2`, in any order.
[[nodiscard]] Expected<std::vector<EncoderReading>> loadEncoderReadings(const std::filesystem::path& file);
/// Refuses a length that is not positive, fewer than two readings, counters that turn round, and travels of fewer
/// than 100 pulses, whose rounding alone would be worse than a part in 250.
[[nodiscard]] Expected<EncoderCalibration> calibrateEncoder(const std::vector<EncoderReading>& readings,
                                                            const EncoderSettings& settings);

}  // namespace vignole
