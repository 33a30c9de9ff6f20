#pragma once
// Appending to the audit trail, for the classes of this room that change what is audited, within their transaction.

#include <string>

#include "engine/database/database.h"

namespace vignole {

struct AuditNote {
  std::string user, action, subject, reason, details;
};

/// The end of the chain.
struct AuditHead {
  std::int64_t number = 0;
  std::string digest;
};

/// Refuses a note without user; every change that touches quality has a reason. Throws DatabaseFailure.
void appendAudit(Database& database, std::int64_t timeUs, const AuditNote& note);
[[nodiscard]] AuditHead auditHead(Database& database);
/// What entry `number` must be signed with, after one that was signed with `before`.
[[nodiscard]] std::string auditDigest(std::int64_t number, std::int64_t timeUs, const AuditNote& note,
                                      const std::string& before);

}  // namespace vignole
