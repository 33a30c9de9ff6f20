#include "cli/study_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace vignole::cli {

namespace {

std::string formatted(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_number_float()) {
    char text[40];
    std::snprintf(text, sizeof text, "%.10g", value.get<double>());
    return text;
  }
  if (value.is_null()) return "-";
  if (value.is_array()) {
    std::string text;
    for (std::size_t i = 0; i < value.size() && i < 12; ++i)
      text += (i == 0 ? "" : value[i].is_string() ? ", " : " ... ") + formatted(value[i]);
    return value.size() == 2 ? text : "";
  }
  return value.dump();
}

bool isFlat(const Json& row) {
  return row.is_object() && std::none_of(row.begin(), row.end(), [](const Json& v) { return v.is_object(); });
}
bool isTable(const Json& value) {
  return value.is_array() && !value.empty() && std::all_of(value.begin(), value.end(), isFlat);
}
/// A pair is a range and stands in a line; longer lists are for the JSON.
bool isShown(const Json& value) { return !value.is_array() || (value.size() == 2 && value[0].is_primitive()); }

void appendTable(std::string& text, const std::string& name, const Json& rows, const std::string& indent) {
  std::vector<std::string> keys;  // of all rows: a moving range begins with the second
  for (const Json& row : rows)
    for (const auto& [key, value] : row.items())
      if (isShown(value) && std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
  std::vector<std::vector<std::string>> cells = {keys};
  for (const Json& row : rows) {
    cells.emplace_back();
    for (const std::string& key : keys) cells.back().push_back(row.contains(key) ? formatted(row.at(key)) : "");
  }
  std::vector<std::size_t> widths(keys.size(), 0);
  for (const auto& row : cells)
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  text += "\n" + indent + name + "\n";
  constexpr std::size_t kMostRows = 60;
  for (std::size_t r = 0; r < std::min(cells.size(), kMostRows + 1); ++r) {
    text += indent + " ";
    for (std::size_t c = 0; c < cells[r].size(); ++c)
      text += " " + std::string(widths[c] - cells[r][c].size(), ' ') + cells[r][c];
    text += "\n";
  }
  if (cells.size() > kMostRows + 1)
    text += indent + "  ... " + std::to_string(cells.size() - kMostRows - 1) + " more, all in --json\n";
}

void appendObject(std::string& text, const Json& object, const std::string& indent) {
  std::size_t width = 0;
  for (const auto& [key, value] : object.items())
    if (!value.is_object() && isShown(value)) width = std::max(width, key.size());
  for (const auto& [key, value] : object.items())
    if (!value.is_object() && isShown(value))
      text += indent + key + std::string(width - key.size() + 2, ' ') + formatted(value) + "\n";
  for (const auto& [key, value] : object.items()) {
    if (value.is_object()) {
      text += "\n" + indent + key + "\n";
      appendObject(text, value, indent + "  ");
    } else if (isTable(value)) {
      appendTable(text, key, value, indent);
    } else if (value.is_array() && !value.empty() && value.front().is_object()) {
      for (const Json& element : value) {
        text += "\n";
        appendObject(text, element, indent);
      }
    }
  }
}

}  // namespace

std::string studyText(const std::string& study, const StudyOutcome& outcome) {
  std::string text = study + "\n\n";
  appendObject(text, outcome.results, "");
  if (!outcome.refused.empty()) text += "\nrefused: " + outcome.refused + "\n";
  text += "\nformulas\n";
  for (const std::string& formula : outcome.notes.formulas) text += "  " + formula + "\n";
  text += "\noptions\n";
  appendObject(text, outcome.options, "  ");
  text += "\nconstants\n";
  for (const auto& [name, value] : outcome.notes.constants) text += "  " + name + " = " + formatted(Json(value)) + "\n";
  return text;
}

}  // namespace vignole::cli
