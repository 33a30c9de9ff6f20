// A recipe as a file for people: every value with its comment.

#include <array>
#include <charconv>
#include <cstdio>

#include "engine/recipe/recipe_fields.h"

namespace vignole {

namespace {

std::string tomlText(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (byte < 0x20 || byte == 0x7f) {
      std::array<char, 8> escape{};
      std::snprintf(escape.data(), escape.size(), "\\u%04X", static_cast<unsigned>(byte));
      result += escape.data();
    } else {
      result += c;
    }
  }
  return result + "\"";
}

std::string tomlText(double value) { return plainNumber(value); }
std::string tomlText(int value) { return std::to_string(value); }
std::string tomlText(const LeftRight& value) {
  return "[" + plainNumber(value.left) + ", " + plainNumber(value.right) + "]";
}
std::string tomlText(const std::optional<double>& value) { return value ? plainNumber(*value) : ""; }

/// "parameters.hw_depth_mm" under a heading that is written when the table changes.
class FieldWriter {
 public:
  FieldWriter(std::string& text, std::string& table) : text_(text), table_(table) {}

  template <typename Value, typename Limit1, typename Limit2>
  void operator()(std::string_view key, const Value& value, Limit1 /*min*/, Limit2 /*max*/, const char* comment) {
    line(key, tomlText(value), comment);
  }
  void operator()(std::string_view key, bool value, const char* comment) {
    line(key, value ? "true" : "false", comment);
  }

 private:
  void line(std::string_view key, const std::string& value, const char* comment) {
    const std::size_t dot = key.find('.');
    if (const std::string_view table = key.substr(0, dot); table != table_) {
      table_ = table;
      text_ += "\n[" + table_ + "]\n";
    }
    std::string text = value.empty() ? "# " : "";
    text += std::string(key.substr(dot + 1)) + " = " + (value.empty() ? "?" : value);
    text_ += text + std::string(text.size() < 34 ? 34 - text.size() : 1, ' ') + "# " + comment + "\n";
  }

  std::string& text_;
  std::string& table_;
};

void writeLimits(std::string& text, const PerDimension<ToleranceLimits>& limits) {
  text += "\n# Allowed deviations from nominal; a dimension that is not judged says so.\n[tolerance]\n";
  for (const Dimension d : kDimensions) {
    const ToleranceLimits& l = limits.at(index(d));
    text += std::string(name(d)) + " = { ";
    if (l.lowerMm) text += "lower_mm = " + plainNumber(*l.lowerMm);
    if (l.lowerMm && l.upperMm) text += ", ";
    if (l.upperMm) text += "upper_mm = " + plainNumber(*l.upperMm);
    if (!l.lowerMm && !l.upperMm) text += "judged = false";
    text += " }\n";
  }
}

}  // namespace

std::string plainNumber(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::string dimensionNames() {
  std::string names;
  for (const Dimension d : kDimensions) names += (names.empty() ? "" : ", ") + std::string(name(d));
  return names;
}

std::string toToml(const Recipe& recipe) {
  std::string text =
      "# A recipe: what is measured and how. What a file leaves out is as the section and its classes say.\n";
  text += "format = 1\n";
  text += "name = " + tomlText(recipe.name) + "\n";
  text += "version = " + std::to_string(recipe.version) + "\n";
  text += "note = " + tomlText(recipe.note) + "\n";
  text += "section = " + tomlText(recipe.sectionSource.empty() ? recipe.section.name : recipe.sectionSource) +
          "  # a rail of the catalogue, or a section file\n";
  text += "profile_class = " + tomlText(recipe.profileClass) + "\n";
  text += "straightness_class = " + tomlText(recipe.straightnessClass) + "  # governs HF\n";
  std::string table;
  forEachField(recipe, FieldWriter(text, table));
  writeLimits(text, recipe.limits);
  return text;
}

}  // namespace vignole
