#pragma once
// Naming an archive and a rail in it on the command line.

#include <string>

#include "engine/archive/rail_archive.h"

namespace vignole::cli {

inline constexpr const char* kArchiveUrlHelp =
    "FILE, sqlite:FILE or postgresql://USER@HOST/DATABASE (its password in ~/.pgpass or PGPASSFILE)";

/// By its id (the newest of that name), or by its key in the archive.
[[nodiscard]] Expected<std::int64_t> findRail(const RailArchive& rails, const std::string& idOrKey);

}  // namespace vignole::cli
