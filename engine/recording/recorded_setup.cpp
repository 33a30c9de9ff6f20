#include "engine/recording/recorded_setup.h"

#include <nlohmann/json.hpp>

#include "engine/files/atomic_file.h"
#include "engine/rail/catalogue.h"
#include "engine/rail/section.h"

namespace vignole {

namespace {

using Json = nlohmann::ordered_json;
constexpr int kFormat = 1;

std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// Null if the text is no JSON object.
Json parsed(const std::string& text) {
  Json json = Json::parse(text, nullptr, false);
  return json.is_object() ? json : Json();
}

/// Absent or of another kind: nothing.
std::string textIn(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

double numberIn(const Json& json, const char* key, double otherwise) {
  const auto found = json.find(key);
  return found != json.end() && found->is_number() ? found->get<double>() : otherwise;
}

/// The catalogue's own where it is the same still: then it is the same to the last bit.
Expected<Section> recordedSection(const std::string& text, const std::string& where) {
  auto section = parseSection(text, where);
  if (!section) return section;
  const auto known = findSection(section->name);
  return known && toJson(*known) == text ? known : section;
}

/// With every digit of its file, if that is still the one that the recipe was read with.
std::string sectionText(const Recipe& recipe) {
  const std::string text = toJson(recipe.section);
  if (recipe.sectionSource.find('/') == std::string::npos) return text;
  const auto file = readFile(recipe.sectionSource);
  const auto section = file ? parseSection(*file, recipe.sectionSource) : Expected<Section>(tl::unexpected(Error{}));
  return section && toJson(*section) == text ? *file : text;
}

}  // namespace

std::string toJson(const RecordedSetup& setup) {
  Json json;
  json["format"] = kFormat;
  json["program"] = setup.program;
  json["simd"] = setup.simdTarget;
  json["source"] = setup.source;
  json["frames"] = setup.whole ? "whole" : "sparse";
  json["cameras"] = Json::array();
  for (const RangeFinderCalibration& finder : setup.calibration.rangeFinders)
    json["cameras"].push_back({{"serial", finder.serial},
                               {"width_px", finder.intrinsics.widthPx},
                               {"height_px", finder.intrinsics.heightPx}});
  json["recipe"] = toToml(setup.recipe);
  json["section"] = sectionText(setup.recipe);
  json["calibration"] = toToml(setup.calibration);
  if (!setup.origin.empty()) json["origin"] = setup.origin;
  return dumped(json);
}

Expected<RecordedSetup> parseSetup(const std::string& text, const std::string& where) {
  const Json json = parsed(text);
  if (json.is_null()) return inputError(where, "does not say what it was recorded with");
  if (numberIn(json, "format", 0) != kFormat)
    return inputError(where, "is of a later version of the program; use that");
  RecordedSetup setup;
  setup.program = textIn(json, "program");
  setup.simdTarget = textIn(json, "simd");
  setup.source = textIn(json, "source");
  setup.origin = textIn(json, "origin");
  setup.whole = textIn(json, "frames") == "whole";
  auto section = recordedSection(textIn(json, "section"), where + ", section");
  if (!section) return tl::unexpected(section.error());
  auto recipe = parseRecipe(textIn(json, "recipe"), where + ", recipe", std::move(*section));
  if (!recipe) return tl::unexpected(recipe.error());
  setup.recipe = std::move(*recipe);
  auto calibration = parseCalibration(textIn(json, "calibration"), where + ", calibration");
  if (!calibration) return tl::unexpected(calibration.error());
  setup.calibration = std::move(*calibration);
  return setup;
}

std::string toJson(const RecordedRailBegin& begin) {
  const RailBegin& rail = begin.rail;
  Json json = {{"id", rail.id},
               {"heat", rail.heat},
               {"section", rail.sectionName},
               {"first_trigger", rail.firstTrigger},
               {"begins_at_mm", rail.beginsAtMm},
               {"spacing_mm", rail.spacingMm},
               {"length_mm", rail.lengthMm},
               {"speed_mm_per_s", rail.speedMmPerS},
               {"temperature_c", rail.temperatureC},
               {"u_temperature_c", rail.temperatureUncertaintyC},
               {"notes", Json::object()}};
  for (const auto& [key, value] : begin.notes) json["notes"][key] = value;
  return dumped(json);
}

Expected<RecordedRailBegin> parseRailBegin(const std::string& text, const std::string& where) {
  const Json json = parsed(text);
  const auto first = json.find("first_trigger");
  if (json.is_null() || first == json.end() || !first->is_number_unsigned())
    return inputError(where, "has a rail that does not say where it begins");
  RecordedRailBegin begin;
  RailBegin& rail = begin.rail;
  rail.id = textIn(json, "id");
  rail.heat = textIn(json, "heat");
  rail.sectionName = textIn(json, "section");
  rail.firstTrigger = first->get<std::uint64_t>();
  rail.beginsAtMm = numberIn(json, "begins_at_mm", 0);
  rail.spacingMm = numberIn(json, "spacing_mm", rail.spacingMm);
  rail.lengthMm = numberIn(json, "length_mm", 0);
  rail.speedMmPerS = numberIn(json, "speed_mm_per_s", 0);
  rail.temperatureC = numberIn(json, "temperature_c", rail.temperatureC);
  rail.temperatureUncertaintyC = numberIn(json, "u_temperature_c", rail.temperatureUncertaintyC);
  if (const auto notes = json.find("notes"); notes != json.end() && notes->is_object())
    for (const auto& [key, value] : notes->items())
      if (value.is_string()) begin.notes[key] = value.get<std::string>();
  return begin;
}

}  // namespace vignole
