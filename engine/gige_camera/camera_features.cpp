#include "engine/gige_camera/camera_features.h"

#include <charconv>
#include <cmath>

namespace vignole::gige {

namespace {

Expected<void> outcome(const Failure& failure, const std::string& feature, const std::string& value,
                       const std::string& where) {
  if (!failure.any()) return {};
  return worldError(where,
                    "refuses " + feature + (value.empty() ? "" : " = " + value) + " (" + failure.message() + ")");
}

std::string printed(double value) {
  std::string text = std::to_string(value);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text;
}

}  // namespace

std::optional<std::string> firstPresent(ArvDevice* device, const std::vector<std::string>& names) {
  for (const std::string& name : names)
    if (!name.empty() && arv_device_get_feature(device, name.c_str()) != nullptr) return name;
  return {};
}

bool hasEntry(ArvDevice* device, const std::string& enumeration, const std::string& entry) {
  Failure failure;
  guint count = 0;
  const char** entries =
      arv_device_dup_available_enumeration_feature_values_as_strings(device, enumeration.c_str(), &count, failure);
  bool found = false;
  for (guint i = 0; entries != nullptr && i < count; ++i) found = found || entry == entries[i];
  g_free(entries);
  return found;
}

Expected<void> writeNumber(ArvDevice* device, const std::string& feature, double value, const std::string& where) {
  Failure failure;
  ArvGcNode* node = arv_device_get_feature(device, feature.c_str());
  if (node == nullptr) return worldError(where, "has no feature " + feature + "; name the right one in the site file");
  if (ARV_IS_GC_FLOAT(node)) {
    arv_device_set_float_feature_value(device, feature.c_str(), value, failure);
  } else {
    arv_device_set_integer_feature_value(device, feature.c_str(), static_cast<gint64>(std::llround(value)), failure);
  }
  return outcome(failure, feature, printed(value), where);
}

Expected<void> write(ArvDevice* device, const std::string& feature, const std::string& value,
                     const std::string& where) {
  ArvGcNode* node = arv_device_get_feature(device, feature.c_str());
  if (node == nullptr) return worldError(where, "has no feature " + feature + "; name the right one in the site file");
  Failure failure;
  double number = 0;
  const auto [end, failed] = std::from_chars(value.data(), value.data() + value.size(), number);
  const bool isNumber = failed == std::errc() && end == value.data() + value.size();
  if (ARV_IS_GC_COMMAND(node)) {
    arv_device_execute_command(device, feature.c_str(), failure);
  } else if (ARV_IS_GC_BOOLEAN(node)) {
    arv_device_set_boolean_feature_value(device, feature.c_str(), value == "true" || value == "1" || value == "On",
                                         failure);
  } else if (ARV_IS_GC_ENUMERATION(node) && !isNumber) {
    arv_device_set_string_feature_value(device, feature.c_str(), value.c_str(), failure);
  } else if (isNumber) {
    return writeNumber(device, feature, number, where);
  } else {
    arv_device_set_string_feature_value(device, feature.c_str(), value.c_str(), failure);
  }
  return outcome(failure, feature, value, where);
}

Expected<void> execute(ArvDevice* device, const std::string& command, const std::string& where) {
  Failure failure;
  arv_device_execute_command(device, command.c_str(), failure);
  return outcome(failure, command, {}, where);
}

Expected<std::int64_t> readInteger(ArvDevice* device, const std::string& feature, const std::string& where) {
  Failure failure;
  const gint64 value = arv_device_get_integer_feature_value(device, feature.c_str(), failure);
  if (failure.any()) return worldError(where, "does not tell its " + feature + " (" + failure.message() + ")");
  return value;
}

std::string readText(ArvDevice* device, const std::vector<std::string>& names) {
  const auto name = firstPresent(device, names);
  if (!name) return {};
  Failure failure;
  const char* text = arv_device_get_string_feature_value(device, name->c_str(), failure);
  return failure.any() || text == nullptr ? std::string() : std::string(text);
}

}  // namespace vignole::gige
