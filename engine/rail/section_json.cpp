// The JSON form of a section. A file without `format` is read as the exchange form of outlines: the same primitives,
// `profile` for the name, further keys of no concern here.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <numbers>

#include "engine/files/atomic_file.h"
#include "engine/rail/outline.h"
#include "engine/rail/section.h"

namespace vignole {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kFormat = 1;
constexpr double kOnCircleMm = 1e-3;

/// Line and column (from 1) of a byte, for people.
std::string position(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte == 0 ? 0 : byte - 1, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t newline = before.rfind('\n');
  const std::size_t column = before.size() - (newline == std::string_view::npos ? 0 : newline + 1) + 1;
  return ":" + std::to_string(line) + ":" + std::to_string(column);
}

/// Reads values of one object; the first thing that is wrong is kept.
class ObjectReader {
 public:
  ObjectReader(const Json& object, std::string where, std::optional<Error>& error)
      : object_(object), where_(std::move(where)), error_(error) {
    if (!object.is_object()) refuse("", "is not an object { ... }");
  }

  void refuse(const std::string& key, std::string what) {
    if (!error_) error_ = Error{where_ + (key.empty() ? "" : ", " + key), std::move(what), ErrorKind::Input};
  }
  void onlyKnow(std::initializer_list<const char*> keys) {
    if (!object_.is_object()) return;
    for (const auto& [key, value] : object_.items())
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) refuse(key, "is not known here; remove it");
  }
  [[nodiscard]] const Json* find(const char* key) const {
    if (!object_.is_object()) return nullptr;
    const auto it = object_.find(key);
    return it == object_.end() ? nullptr : &*it;
  }
  std::string text(const char* key, std::optional<std::string> fallback = {}) {
    const Json* value = find(key);
    if (value == nullptr && fallback) return *fallback;
    if (value != nullptr && value->is_string()) return value->get<std::string>();
    refuse(key, value == nullptr ? "is missing; give text" : "is not text");
    return {};
  }
  double number(const char* key, std::optional<double> fallback = {}) {
    const Json* value = find(key);
    if (value == nullptr && fallback) return *fallback;
    if (value == nullptr) refuse(key, "is missing; give a number");
    return value == nullptr ? 0 : numberOf(*value, key);
  }
  std::optional<double> optionalNumber(const char* key) {
    const Json* value = find(key);
    if (value == nullptr || value->is_null()) return std::nullopt;
    return numberOf(*value, key);
  }
  bool boolean(const char* key) {
    const Json* value = find(key);
    if (value != nullptr && value->is_boolean()) return value->get<bool>();
    refuse(key, value == nullptr ? "is missing; give true or false" : "is not true or false");
    return false;
  }
  std::array<double, 2> pair(const char* key, std::optional<std::array<double, 2>> fallback = {}) {
    const Json* value = find(key);
    if (value == nullptr && fallback) return *fallback;
    if (value == nullptr || !value->is_array() || value->size() != 2) {
      refuse(key, value == nullptr ? "is missing; give two numbers [ , ]" : "is not a list of two numbers");
      return {0, 0};
    }
    return {numberOf((*value)[0], key), numberOf((*value)[1], key)};
  }
  Point2 point(const char* key) {
    const auto [x, y] = pair(key);
    return {x, y};
  }

 private:
  double numberOf(const Json& value, const char* key) {
    if (!value.is_number()) {
      refuse(key, "is " + std::string(value.type_name()) + " " + value.dump() + "; give a number");
      return 0;
    }
    const double v = value.get<double>();
    if (!std::isfinite(v)) refuse(key, "is not a finite number");
    return v;
  }

  const Json& object_;
  std::string where_;
  std::optional<Error>& error_;
};

Primitive readArc(ObjectReader& reader) {
  const Point2 p0 = reader.point("p0"), p1 = reader.point("p1"), centre = reader.point("centre");
  const double radius = reader.number("radius");
  const bool ccw = reader.boolean("ccw");
  for (const Point2& end : {p0, p1}) {
    const double off = (end - centre).norm() - radius;
    if (!(std::abs(off) < kOnCircleMm)) {
      std::array<char, 64> text{};
      std::snprintf(text.data(), text.size(), "does not fit: an end lies %.4g mm off the circle", off);
      reader.refuse("radius", text.data());
    }
  }
  const double from = std::atan2(p0.y() - centre.y(), p0.x() - centre.x());
  double sweep = std::atan2(p1.y() - centre.y(), p1.x() - centre.x()) - from;
  if (ccw && sweep <= 0) sweep += 2 * std::numbers::pi;
  if (!ccw && sweep >= 0) sweep -= 2 * std::numbers::pi;
  return Arc{centre, radius, from, sweep};
}

NamedPrimitive readPrimitive(const Json& json, std::size_t index, const std::string& file, bool strict,
                             std::optional<Error>& error) {
  const Json* named = json.is_object() && json.contains("name") ? &json["name"] : nullptr;
  std::string where = file + ": primitive " + std::to_string(index + 1);
  if (named != nullptr && named->is_string()) where += " " + named->get<std::string>();
  ObjectReader reader(json, where, error);
  NamedPrimitive result{reader.text("name"), Segment{}};
  const std::string type = reader.text("type");
  if (type == "segment") {
    if (strict) reader.onlyKnow({"name", "type", "p0", "p1"});
    result.shape = Segment{reader.point("p0"), reader.point("p1")};
  } else if (type == "arc") {
    if (strict) reader.onlyKnow({"name", "type", "p0", "p1", "centre", "radius", "ccw"});
    result.shape = readArc(reader);
  } else {
    reader.refuse("type", "is \"" + type + "\"; give \"segment\" or \"arc\"");
  }
  return result;
}

PublishedValues readPublished(const Json& json, const std::string& file, bool strict, std::optional<Error>& error) {
  ObjectReader reader(json, file + ": published", error);
  if (strict)
    reader.onlyKnow(
        {"area_cm2", "mass_kg_per_m", "ix_cm4", "iy_cm4", "centroid_y_mm", "area_tolerance_percent", "source"});
  PublishedValues p;
  p.areaCm2 = reader.optionalNumber("area_cm2");
  p.massKgPerM = reader.optionalNumber(strict ? "mass_kg_per_m" : "mass_kg_m");
  p.ixCm4 = reader.optionalNumber(strict ? "ix_cm4" : "Ix_cm4");
  p.iyCm4 = reader.optionalNumber(strict ? "iy_cm4" : "Iy_cm4");
  p.centroidYMm = reader.optionalNumber("centroid_y_mm");
  p.source = reader.text("source", "");
  p.areaTolerancePercent = reader.number("area_tolerance_percent", p.areaTolerancePercent);
  return p;
}

DimensionParameters readParameters(const Json& json, const std::string& file, std::optional<Error>& error) {
  ObjectReader reader(json, file + ": parameters", error);
  reader.onlyKnow({"rfh_from_axis_mm", "hf_half_width_mm", "hw_depth_mm", "hwa_depth_mm", "ft_inside_mm",
                   "ras_depth_mm", "wt_height_mm", "base_inset_mm"});
  DimensionParameters p;
  const auto sides = [&](const char* key, LeftRight& value) {
    const auto [left, right] = reader.pair(key, std::array<double, 2>{value.left, value.right});
    value = {left, right};
  };
  sides("rfh_from_axis_mm", p.rfhFromAxisMm);
  sides("hf_half_width_mm", p.hfHalfWidthMm);
  p.hwDepthMm = reader.number("hw_depth_mm", p.hwDepthMm);
  p.hwaDepthMm = reader.number("hwa_depth_mm", p.hwaDepthMm);
  sides("ft_inside_mm", p.ftInsideMm);
  sides("ras_depth_mm", p.rasDepthMm);
  p.wtHeightMm = reader.optionalNumber("wt_height_mm");
  p.baseInsetMm = reader.number("base_inset_mm", p.baseInsetMm);
  return p;
}

constexpr std::array<const char*, 3> kStandings = {"standard", "approximate", "invented"};

Section readSection(const Json& json, const std::string& file, std::optional<Error>& error) {
  ObjectReader reader(json, file, error);
  Section section;
  const bool strict = reader.find("format") != nullptr || reader.find("profile") == nullptr;
  if (strict) {
    if (reader.number("format") != kFormat) reader.refuse("format", "is not 1, the only format this version reads");
    reader.onlyKnow({"format", "name", "standard", "standing", "note", "axis_from_foot_middle_mm", "parameters",
                     "published", "primitives"});
    section.axisFromFootMiddleMm = reader.number("axis_from_foot_middle_mm", 0);
    const std::string standing = reader.text("standing");
    const auto known = std::find(kStandings.begin(), kStandings.end(), standing);
    if (known == kStandings.end())
      reader.refuse("standing", "is \"" + standing + "\"; give \"standard\", \"approximate\" or \"invented\"");
    else
      section.standing = static_cast<SectionStanding>(known - kStandings.begin());
  } else {
    section.standing = SectionStanding::Approximate;
    section.note = "Read from an outline file; its provenance is not known to this program.";
  }
  section.name = reader.text(strict ? "name" : "profile");
  section.standard = reader.text("standard", "");
  section.note = reader.text("note", section.note);
  if (const Json* parameters = reader.find("parameters")) section.parameters = readParameters(*parameters, file, error);
  if (const Json* published = reader.find("published"))
    section.published = readPublished(*published, file, strict, error);
  if (!strict)
    section.published.areaTolerancePercent =
        reader.number("area_tolerance_percent", section.published.areaTolerancePercent);

  const Json* primitives = reader.find("primitives");
  if (primitives == nullptr || !primitives->is_array()) {
    reader.refuse("primitives", "is missing or not a list");
    return section;
  }
  for (std::size_t i = 0; i < primitives->size() && !error; ++i)
    section.primitives.push_back(readPrimitive((*primitives)[i], i, file, strict, error));
  // The exchange form has its origin on the axis, also where the foot is not.
  if (!strict) section.axisFromFootMiddleMm = -section.axisXMm();
  return section;
}

double rounded(double value) {
  const double r = std::round(value * 1e6) / 1e6;
  return r == 0 ? 0 : r;  // no -0.0
}
Json toJson(const Point2& p) { return {rounded(p.x()), rounded(p.y())}; }
Json toJson(const LeftRight& sides) { return {sides.left, sides.right}; }

Json toJson(const NamedPrimitive& p) {
  Json json;
  json["name"] = p.name;
  const auto* arc = std::get_if<Arc>(&p.shape);
  json["type"] = arc == nullptr ? "segment" : "arc";
  json["p0"] = toJson(startPoint(p.shape));
  json["p1"] = toJson(endPoint(p.shape));
  if (arc != nullptr) {
    json["centre"] = toJson(arc->centre);
    json["radius"] = rounded(arc->radiusMm);
    json["ccw"] = arc->sweepRad > 0;
  }
  return json;
}

Json toJson(const PublishedValues& published) {
  Json json = Json::object();
  const auto put = [&](const char* key, const std::optional<double>& value) {
    if (value) json[key] = *value;
  };
  put("area_cm2", published.areaCm2);
  put("mass_kg_per_m", published.massKgPerM);
  put("ix_cm4", published.ixCm4);
  put("iy_cm4", published.iyCm4);
  put("centroid_y_mm", published.centroidYMm);
  json["area_tolerance_percent"] = published.areaTolerancePercent;
  if (!published.source.empty()) json["source"] = published.source;
  return json;
}

/// Only what differs from the defaults: a file shows what is special about its section.
Json toJson(const DimensionParameters& p) {
  const DimensionParameters usual;
  Json json = Json::object();
  const auto sides = [&](const char* key, const LeftRight& value, const LeftRight& normal) {
    if (value.left != normal.left || value.right != normal.right) json[key] = toJson(value);
  };
  const auto number = [&](const char* key, double value, double normal) {
    if (value != normal) json[key] = value;
  };
  sides("rfh_from_axis_mm", p.rfhFromAxisMm, usual.rfhFromAxisMm);
  sides("hf_half_width_mm", p.hfHalfWidthMm, usual.hfHalfWidthMm);
  number("hw_depth_mm", p.hwDepthMm, usual.hwDepthMm);
  number("hwa_depth_mm", p.hwaDepthMm, usual.hwaDepthMm);
  sides("ft_inside_mm", p.ftInsideMm, usual.ftInsideMm);
  sides("ras_depth_mm", p.rasDepthMm, usual.rasDepthMm);
  if (p.wtHeightMm) json["wt_height_mm"] = *p.wtHeightMm;
  number("base_inset_mm", p.baseInsetMm, usual.baseInsetMm);
  return json;
}

}  // namespace

Expected<Section> loadSection(const std::filesystem::path& file) {
  const auto text = readFile(file);
  if (!text) return tl::unexpected(text.error());
  return parseSection(*text, file.string());
}

Expected<Section> parseSection(const std::string& text, const std::string& nameInErrors) {
  Json json;
  try {
    json = Json::parse(text);
  } catch (const Json::parse_error& e) {
    const bool truncated = e.byte > text.size();
    return inputError(nameInErrors + position(text, e.byte), truncated ? "ends in the middle; the file is incomplete"
                                                                         : "is not JSON; a section file is expected");
  } catch (const Json::exception&) {  // a number beyond the range of double
    return inputError(nameInErrors, "has a number that is too large");
  }
  std::optional<Error> error;
  Section section = readSection(json, nameInErrors, error);
  if (error) return tl::unexpected(*error);
  auto created = createSection(std::move(section));
  if (!created) return inputError(nameInErrors + ": " + created.error().where, created.error().what);
  if (!json.contains("format")) created->parameters = usualParameters(*created);
  return created;
}

std::string toJson(const Section& section) {
  Json json;
  json["format"] = kFormat;
  json["name"] = section.name;
  json["standard"] = section.standard;
  json["standing"] = kStandings.at(static_cast<std::size_t>(section.standing));
  json["note"] = section.note;
  json["axis_from_foot_middle_mm"] = section.axisFromFootMiddleMm;
  if (Json parameters = toJson(section.parameters); !parameters.empty()) json["parameters"] = std::move(parameters);
  json["published"] = toJson(section.published);
  // One line a primitive, so that people can read and compare files.
  std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace);
  text.erase(text.rfind("\n}"));
  text += ",\n  \"primitives\": [";
  for (std::size_t i = 0; i < section.primitives.size(); ++i)
    text += (i == 0 ? "\n    " : ",\n    ") +
            toJson(section.primitives[i]).dump(-1, ' ', false, Json::error_handler_t::replace);
  return text + "\n  ]\n}\n";
}

}  // namespace vignole
