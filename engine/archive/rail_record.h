#pragma once
// A rail as the archive keeps it. Times are microseconds since 1970, UTC.

#include <cstdint>
#include <string>
#include <vector>

#include "engine/inspection/inspection.h"
#include "engine/inspection/rail_summary.h"

namespace vignole {

using TimeUs = std::int64_t;

[[nodiscard]] TimeUs systemTimeUs();
/// "2025-03-07T14:05:09.123456Z"
[[nodiscard]] std::string isoTime(TimeUs time);
/// A date, or a date and time as isoTime writes it (with or without fraction and Z), UTC.
[[nodiscard]] Expected<TimeUs> timeFromIso(std::string_view text);

/// Running: still passing, or the program that measured it died and none has measured here since.
/// Interrupted: it died; what it had stored by then is whole.
enum class RailState { Running, Finished, Interrupted };
[[nodiscard]] std::string_view name(RailState state);

/// What is entered by hand or handed in by the line, beside what RailBegin says.
struct RailPapers {
  std::string strand, orderNumber, shift, operatorName;
};

/// Who measured: recorded with every rail.
struct MeasuringPlace {
  std::string line = "line 1";
  std::string source;   ///< "virtual", "gige", ...
  std::string program;  ///< version
  std::string machine;  ///< SIMD target: numbers are equal to the last bit on the same one
};

struct StoredRail {
  std::int64_t key = 0;  ///< in this archive
  std::string uid;       ///< the same in every archive that it is copied to
  RailState state = RailState::Running;
  TimeUs beganUs = 0, endedUs = 0;
  MeasuringPlace place;
  RailPapers papers;
  std::int64_t recipe = 0, calibration = 0;  ///< keys in RecipeHistory, CalibrationHistory; 0: none
  /// As it was told when the rail had passed. rail.sectionName: the section that it was measured against.
  RailSummary summary;
  PerDimension<std::optional<double>> excessMm;  ///< the furthest beyond a limit (negative: inside) of any profile
  std::uint64_t notStored = 0;                   ///< profiles that were measured but could not be stored in time
  std::vector<StageStatistics> stages;
  std::int64_t auditNumber = 0;  ///< the last entry of the audit trail when it began, and its digest
  std::string auditDigest;
};

}  // namespace vignole
