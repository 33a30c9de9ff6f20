#pragma once
// How long rails stay: looked at first, then done, and written into the audit trail.

#include <functional>
#include <string>

#include "engine/archive/archive.h"
#include "engine/archive/rail_record.h"

namespace vignole {

/// A rail that is held (evidence was handed out) always stays, and so does one that is passing.
struct RetentionPolicy {
  int keepDays = 365;             ///< rails that began earlier go
  int keepRejectedDays = 0;       ///< rails that failed or were not measured: so long; 0: for ever
  int keepPointsDays = 0;         ///< the points of rails that stay go after so long; 0: they stay with their rail
  bool keepWithRecording = true;  ///< rails that frames were recorded of stay
};

struct RetentionPlan {
  TimeUs beforeUs = 0, rejectedBeforeUs = 0, pointsBeforeUs = 0;        ///< 0: never
  std::uint64_t rails = 0, profiles = 0, bytes = 0;                     ///< that go; bytes: of profiles and points
  std::optional<TimeUs> firstUs, lastUs;                                ///< of those
  std::uint64_t keptHeld = 0, keptRejected = 0, keptWithRecording = 0;  ///< old enough, and yet they stay: why
  std::uint64_t profilesLosingPoints = 0, bytesOfPoints = 0;
};

/// What would go now. Changes nothing.
[[nodiscard]] Expected<RetentionPlan> planRetention(const Archive& archive, const RetentionPolicy& policy, TimeUs now);
/// What went. A hundred rails at a time, each hundred with an entry in the audit trail that names them. `progress`:
/// share done; false stops.
[[nodiscard]] Expected<RetentionPlan> applyRetention(const Archive& archive, const RetentionPolicy& policy, TimeUs now,
                                                     const std::string& user, const std::string& reason,
                                                     const std::function<bool(double)>& progress = {});

}  // namespace vignole
