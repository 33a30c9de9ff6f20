#pragma once
// Who changed what that touches quality, when and why. Entries are only ever added; each carries a digest over itself
// and the one before, the last one's is kept apart and with every rail: an entry changed, put in or taken out shows.

#include <optional>
#include <string>
#include <vector>

#include "engine/archive/archive.h"
#include "engine/archive/rail_record.h"

namespace vignole {

struct AuditEntry {
  std::int64_t number = 0;  ///< 1, 2, 3 ...
  TimeUs timeUs = 0;
  std::string user, action, subject, reason, details;
  std::string digest;
};

struct AuditQuery {
  std::optional<TimeUs> fromUs, toUs;
  std::string user, action, subject;  ///< empty: any
  std::size_t limit = 200;
  std::int64_t beforeNumber = 0;  ///< the next page; 0: from the newest
};

class AuditTrail {
 public:
  explicit AuditTrail(const Archive& archive);
  /// `user` and `reason` must be given; `details`: old and new value, as text.
  [[nodiscard]] Expected<void> add(const std::string& user, const std::string& action, const std::string& subject,
                                   const std::string& reason, const std::string& details = {});
  [[nodiscard]] Expected<std::vector<AuditEntry>> entries(const AuditQuery& query = {}) const;  ///< newest first
  /// What is wrong with the chain, one line each; empty: nothing.
  [[nodiscard]] Expected<std::vector<std::string>> verify() const;

 private:
  std::shared_ptr<Database> database_;
};

}  // namespace vignole
