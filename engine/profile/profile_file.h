#pragma once
// Ready-made profiles from files: CSV of two numeric columns, MiniProf .ban (Key=value header, ColumnDef), SIMPACK
// .prr.

#include <filesystem>
#include <string_view>
#include <vector>

#include "engine/geometry/expected.h"
#include "engine/profile/profile.h"

namespace vignole {

enum class ProfileFormat { Auto, Csv, MiniProf };  ///< Auto: by extension, then by what the file looks like

struct ProfileFileOptions {
  ProfileFormat format = ProfileFormat::Auto;
  double mmPerUnit = 1;   ///< of CSV and .ban; a .prr says its unit itself
  double sigmaMm = 0.03;  ///< standard uncertainty given to every point
};

/// Points in the file's own axes, mm, in the file's order, camera 0. Errors name file, line and column: a column
/// missing, text, NaN, no points, fewer points than the header says, coordinates beyond 20 m.
[[nodiscard]] Expected<std::vector<ProfilePoint>> readProfile(const std::filesystem::path& file,
                                                              const ProfileFileOptions& options = {});
/// The same from text; `nameInErrors` stands for the file and gives the extension.
[[nodiscard]] Expected<std::vector<ProfilePoint>> parseProfile(std::string_view text, const std::string& nameInErrors,
                                                               const ProfileFileOptions& options = {});

}  // namespace vignole
