#pragma once
// Who may do what.

#include <optional>
#include <string_view>

namespace vignole {

/// Each may what the one before may, except that an administrator looks after users and the site, not after quality.
enum class Role { Operator, Technician, QA, Administrator };
/// "operator", "technician", "QA", "administrator"
[[nodiscard]] std::string_view name(Role role);
[[nodiscard]] std::optional<Role> roleFromName(std::string_view name);

enum class Permission {
  Measure,            ///< arm, stop, choose an approved recipe for the next rail, enter ids
  AcknowledgeAlarms,  ///< and shelve them for a limited time
  TuneLines,          ///< line parameters and exposure
  Calibrate,
  ConfigureCameras,
  EditRecipes,     ///< drafts
  ApproveRecipes,  ///< approve and retire
  RemoveRails,     ///< and retention
  ConfigureSite,   ///< archive, units, plant
  ManageUsers
};
[[nodiscard]] bool may(Role role, Permission permission);

}  // namespace vignole
