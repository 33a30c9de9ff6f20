#pragma once
// The rows of a rail: written, read back, digested. All throw DatabaseFailure; for this room alone.

#include <span>

#include "engine/archive/rail_record.h"
#include "engine/database/database.h"
#include "engine/packing/profile_record.h"

namespace vignole {

/// The rail's own row; returns its key.
[[nodiscard]] std::int64_t insertRail(Database& database, const StoredRail& rail);
/// What changes while it passes: the row's counts, the dimensions, and the exceptions from `known` (per dimension, how
/// many are stored already) on.
void updateRail(Database& database, const StoredRail& rail, PerDimension<std::size_t>& known);
/// What is known when it has passed: the reasons of its triggers and its stages.
void insertLedger(Database& database, const StoredRail& rail);
/// `block`: that many profiles as packProfiles gives them.
void insertBlock(Database& database, std::int64_t rail, std::uint64_t first, std::size_t profiles, const Bytes& block);
/// The blocks of a passing rail, one a second, become few large ones.
void joinBlocks(Database& database, std::int64_t rail);

/// Without the tracks of its dimensions. Throws where there is none.
[[nodiscard]] StoredRail loadRail(Database& database, std::int64_t key);
/// Profiles `first` .. `first + count`, as far as there are any, with the rail's nominals and limits.
[[nodiscard]] std::vector<ProfileRecord> loadProfiles(Database& database, std::int64_t key, std::uint64_t first,
                                                      std::uint64_t count);
/// Over everything that is kept of the rail.
[[nodiscard]] std::string railDigest(Database& database, std::int64_t key);

}  // namespace vignole
