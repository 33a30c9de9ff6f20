#pragma once
// Is everything in an archive as it was written?

#include <functional>
#include <string>
#include <vector>

#include "engine/archive/archive.h"

namespace vignole {

struct ArchiveFinding {
  std::string where, what;
};

struct ArchiveCheck {
  std::vector<ArchiveFinding> findings;  ///< empty: whole
  std::uint64_t rails = 0, profiles = 0, points = 0, auditEntries = 0;
  std::int64_t auditHead = 0;   ///< number and digest of the last entry of the audit trail: noted elsewhere, they also
  std::string auditHeadDigest;  ///< show that somebody wrote the whole trail anew
};

/// The database's own pages and references, every rail against its digest and every block of it unpacked, the texts of
/// recipes and calibrations against theirs, the chain of the audit trail. Rows of alarms, events and users carry no
/// digest: of those only what breaks a page shows. `progress`: share done; false stops. An Error only where the archive
/// cannot be read at all.
[[nodiscard]] Expected<ArchiveCheck> verifyArchive(const Archive& archive,
                                                   const std::function<bool(double)>& progress = {});

}  // namespace vignole
