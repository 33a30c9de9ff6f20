#pragma once
// The sections that come with the program, and where its files lie.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/rail/section.h"

namespace vignole {

/// VIGNOLE_RESOURCES if set, else `resources` or `share/vignole` beside or above the program, else the source tree's.
[[nodiscard]] std::filesystem::path resourceDirectory();

/// Names of the catalogue's sections, sorted.
[[nodiscard]] std::vector<std::string> catalogueNames();

/// All of them, in that order; a file that cannot be read is left out.
[[nodiscard]] std::vector<Section> catalogueSections();

/// A catalogue name ("60E1", case-insensitive) or a path to a section file. The error lists the names there are.
[[nodiscard]] Expected<Section> findSection(std::string_view nameOrFile);

}  // namespace vignole
