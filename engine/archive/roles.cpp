#include "engine/archive/roles.h"

#include <array>

namespace vignole {

namespace {

constexpr std::array<std::string_view, 4> kNames = {"operator", "technician", "QA", "administrator"};

}  // namespace

std::string_view name(Role role) { return kNames.at(static_cast<std::size_t>(role)); }

std::optional<Role> roleFromName(std::string_view name) {
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (kNames.at(i) == name) return static_cast<Role>(i);
  return {};
}

bool may(Role role, Permission permission) {
  switch (permission) {
    case Permission::Measure:
    case Permission::AcknowledgeAlarms:
      return true;
    case Permission::TuneLines:
    case Permission::Calibrate:
    case Permission::ConfigureCameras:
      return role != Role::Operator;
    case Permission::EditRecipes:
    case Permission::ApproveRecipes:
    case Permission::RemoveRails:
      return role == Role::QA;
    case Permission::ConfigureSite:
    case Permission::ManageUsers:
      return role == Role::Administrator;
  }
  return false;
}

}  // namespace vignole
