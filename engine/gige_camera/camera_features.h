#pragma once
// Features by name, whatever their type. Only for this room.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/geometry/expected.h"
#include "engine/gige_camera/arv_objects.h"

namespace vignole::gige {

/// The first of the names that the device has.
[[nodiscard]] std::optional<std::string> firstPresent(ArvDevice* device, const std::vector<std::string>& names);
[[nodiscard]] bool hasEntry(ArvDevice* device, const std::string& enumeration, const std::string& entry);

/// The value is written as the feature's type asks for; `where` in the error is "camera ADDRESS".
[[nodiscard]] Expected<void> write(ArvDevice* device, const std::string& feature, const std::string& value,
                                   const std::string& where);
[[nodiscard]] Expected<void> writeNumber(ArvDevice* device, const std::string& feature, double value,
                                         const std::string& where);
[[nodiscard]] Expected<void> execute(ArvDevice* device, const std::string& command, const std::string& where);
[[nodiscard]] Expected<std::int64_t> readInteger(ArvDevice* device, const std::string& feature,
                                                 const std::string& where);
/// Empty if there is none of the names.
[[nodiscard]] std::string readText(ArvDevice* device, const std::vector<std::string>& names);

}  // namespace vignole::gige
