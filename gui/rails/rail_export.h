#pragma once
// A stored rail as a file for others: a row a profile (CSV), or the whole with its summary (JSON). Millimetres, always.

#include <filesystem>
#include <vector>

#include "engine/archive/rail_archive.h"

namespace vignole {

/// By extension: .csv or .json; written whole or not at all.
[[nodiscard]] Expected<void> exportRail(const StoredRail& rail, const std::vector<ProfileRecord>& profiles,
                                        const std::filesystem::path& file);

}  // namespace vignole
