#include "engine/recipe/recipe_difference.h"

#include <map>
#include <sstream>

namespace vignole {

namespace {

/// Keys and values of what toToml() writes: one a line, tables in brackets, comments after #.
std::map<std::string, std::string> keysOf(const Recipe& recipe) {
  std::map<std::string, std::string> keys;
  std::istringstream lines(toToml(recipe));
  std::string line, table;
  while (std::getline(lines, line)) {
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i] == '"') quoted = !quoted;
      if (line[i] == '#' && !quoted) line.resize(i);
    }
    const auto trimmed = [](std::string text) {
      const auto from = text.find_first_not_of(" \t"), to = text.find_last_not_of(" \t\r");
      return from == std::string::npos ? std::string() : text.substr(from, to - from + 1);
    };
    line = trimmed(line);
    if (line.empty()) continue;
    if (line.front() == '[') {
      table = line.substr(1, line.find(']') - 1) + ".";
      continue;
    }
    const auto equals = line.find('=');
    if (equals != std::string::npos) keys[table + trimmed(line.substr(0, equals))] = trimmed(line.substr(equals + 1));
  }
  for (const char* which : {"format", "name", "version", "note"}) keys.erase(which);
  return keys;
}

}  // namespace

std::vector<RecipeDifference> recipeDifferences(const Recipe& before, const Recipe& after) {
  const auto a = keysOf(before), b = keysOf(after);
  std::map<std::string, RecipeDifference> all;
  for (const auto& [key, value] : a) all[key] = {key, value, {}};
  for (const auto& [key, value] : b) {
    all[key].key = key;
    all[key].after = value;
  }
  std::vector<RecipeDifference> different;
  for (auto& [key, d] : all)
    if (d.before != d.after) different.push_back(std::move(d));
  return different;
}

}  // namespace vignole
