#pragma once
// Every calibration that was made, and which was in force when: comparable, revertible. Every change has a name and a
// reason, and goes into the audit trail.

#include <optional>
#include <string>
#include <vector>

#include "engine/archive/archive.h"
#include "engine/archive/rail_record.h"

namespace vignole {

struct StoredCalibration {
  std::int64_t key = 0;
  std::string id, method, created;  ///< as RigCalibration has them
  TimeUs storedUs = 0;
  std::string storedBy, reason;
};

/// A calibration put in force.
struct CalibrationUse {
  std::int64_t calibration = 0;
  std::string id;
  TimeUs sinceUs = 0;
  std::string user, reason;
};

class CalibrationHistory {
 public:
  explicit CalibrationHistory(const Archive& archive);
  /// Its key; one that is there already stays as it is.
  [[nodiscard]] Expected<std::int64_t> add(const RigCalibration& calibration, const std::string& user,
                                           const std::string& reason);
  [[nodiscard]] Expected<void> putInForce(std::int64_t key, const std::string& user, const std::string& reason);
  [[nodiscard]] Expected<std::vector<StoredCalibration>> all() const;  ///< newest first
  [[nodiscard]] Expected<std::vector<CalibrationUse>> uses() const;    ///< newest first: the first is in force
  [[nodiscard]] Expected<std::string> text(std::int64_t key) const;    ///< TOML, as loadCalibration reads it

 private:
  std::shared_ptr<Database> database_;
};

}  // namespace vignole
