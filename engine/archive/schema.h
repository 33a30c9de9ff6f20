#pragma once
// The tables of an archive, as the steps that made them: an archive of any older version is brought to the present one,
// one of a later version is refused.

#include <span>
#include <vector>

#include "engine/database/database.h"

namespace vignole {

/// Statements that lead from the version before to this one.
struct Migration {
  int version;
  std::vector<const char*> statements;
};

[[nodiscard]] const std::vector<Migration>& migrations();

/// 0 for an empty database. Throws DatabaseFailure.
[[nodiscard]] int schemaVersion(Database& database);
/// Each step whole or not at all. Throws DatabaseFailure: also where the database holds tables of another program.
void migrate(Database& database, std::span<const Migration> steps);

}  // namespace vignole
