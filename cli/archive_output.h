#pragma once
// What `vignole-cli archive` tells: tables for people, JSON and CSV for programs.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "engine/archive/rail_archive.h"
#include "engine/archive/verify_archive.h"

namespace vignole::cli {

[[nodiscard]] nlohmann::ordered_json toJson(const std::vector<RailLine>& rails);
[[nodiscard]] std::string toTable(const std::vector<RailLine>& rails);

/// `withPoints`: how many profiles have theirs; empty where that was not asked for.
[[nodiscard]] nlohmann::ordered_json toJson(const StoredRail& rail, std::optional<std::size_t> withPoints);
[[nodiscard]] std::string toTable(const StoredRail& rail, std::size_t withPoints);

[[nodiscard]] nlohmann::ordered_json toJson(const ArchiveCheck& check);
[[nodiscard]] std::string toTable(const ArchiveCheck& check);

/// As inspect --csv writes it.
[[nodiscard]] std::string profilesCsv(const StoredRail& rail, const std::vector<ProfileRecord>& profiles);
[[nodiscard]] std::string pointsCsv(const Profile& profile);

}  // namespace vignole::cli
