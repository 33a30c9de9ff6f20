#include "engine/rail/catalogue.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <optional>

namespace vignole {

namespace fs = std::filesystem;

namespace {

bool sameText(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

bool looksLikeFile(std::string_view text) {
  return text.find('/') != std::string_view::npos || fs::path(text).extension() == ".json";
}

}  // namespace

fs::path resourceDirectory() {
  const char* chosen = std::getenv("VIGNOLE_RESOURCES");  // NOLINT(concurrency-mt-unsafe): nobody sets it
  if (chosen != nullptr && *chosen != '\0') return chosen;
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  if (!failed)
    for (const fs::path& folder : {program.parent_path(), program.parent_path().parent_path()})
      for (const char* name : {"resources", "share/vignole"})
        if (fs::is_directory(folder / name / "rails", failed)) return folder / name;
  return VIGNOLE_SOURCE_RESOURCES;
}

std::vector<std::string> catalogueNames() {
  std::vector<std::string> names;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(resourceDirectory() / "rails", failed))
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<Section> catalogueSections() {
  std::vector<Section> sections;
  for (const std::string& name : catalogueNames())
    if (auto section = findSection(name)) sections.push_back(std::move(*section));
  return sections;
}

Expected<Section> findSection(std::string_view nameOrFile) {
  if (looksLikeFile(nameOrFile)) return loadSection(nameOrFile);
  const std::vector<std::string> names = catalogueNames();
  for (const std::string& name : names)
    if (sameText(name, nameOrFile)) return loadSection(resourceDirectory() / "rails" / (name + ".json"));

  std::error_code failed;
  if (fs::is_regular_file(fs::path(nameOrFile), failed)) return loadSection(nameOrFile);
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  if (list.empty())
    return worldError((resourceDirectory() / "rails").string(), "holds no sections; set VIGNOLE_RESOURCES");
  return inputError("rail \"" + std::string(nameOrFile) + "\"",
                    "is not in the catalogue and no file; there are " + list);
}

}  // namespace vignole
