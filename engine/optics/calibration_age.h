#pragma once
// When a calibration was made, and whether it is due again.

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "engine/optics/calibration.h"

namespace vignole {

/// Of "2026-01-31T12:00:00Z", seconds since 1970 UTC; empty where the text is none such.
[[nodiscard]] std::optional<std::chrono::sys_seconds> secondsSinceEpoch(std::string_view isoUtc);

struct CalibrationAge {
  std::optional<double> days;  ///< empty where the calibration does not say when it was made; < 0: in the future
  bool overdue = false;        ///< older than its interval, or made in the future by this machine's clock
};
/// Empty, or what is wrong with its age in a few words: "120 days old, its interval is 90 days".
[[nodiscard]] std::string warningOf(const RigCalibration& calibration, const CalibrationAge& age);
[[nodiscard]] CalibrationAge ageOf(const RigCalibration& calibration, std::chrono::sys_seconds now);

}  // namespace vignole
