#include "engine/recipe/recipe.h"

#include <algorithm>

#include "engine/files/toml_reader.h"
#include "engine/rail/catalogue.h"
#include "engine/recipe/recipe_fields.h"

namespace vignole {

namespace fs = std::filesystem;

namespace {

fs::path recipeFolder() { return resourceDirectory() / "recipes"; }

bool isFileName(std::string_view text, const char* extension) { return fs::path(text).extension() == extension; }

/// Reads fields out of a file; the field lists name key, range and value (recipe_fields.h).
struct FieldReader {
  TomlReader& file;

  void operator()(const char* key, double& value, double min, double max, const char* /*comment*/) {
    value = file.number(key, min, max, value);
  }
  void operator()(const char* key, int& value, int min, int max, const char* /*comment*/) {
    value = file.integer(key, min, max, value);
  }
  void operator()(const char* key, bool& value, const char* /*comment*/) { value = file.boolean(key, value); }
  void operator()(const char* key, std::optional<double>& value, double min, double max, const char* /*comment*/) {
    if (file.has(key)) value = file.number(key, min, max);
  }
  void operator()(const char* key, LeftRight& value, double min, double max, const char* /*comment*/) {
    if (!file.has(key)) return;
    const std::vector<double> sides = file.numbers(key, 2);
    for (const double side : sides)
      if (side < min || side > max)
        file.refuse(key,
                    "has a value outside " + plainNumber(min) + " to " + plainNumber(max) + "; give [left, right]");
    value = {sides[0], sides[1]};
  }
};

void readLimits(TomlReader& file, PerDimension<ToleranceLimits>& limits) {
  for (const std::string& dimensionName : file.keys("tolerance")) {
    const std::string key = "tolerance." + dimensionName;
    const auto dimension = dimensionFromName(dimensionName);
    if (!dimension) {
      file.refuse(key, "is no dimension; there are " + dimensionNames());
      return;
    }
    ToleranceLimits given;
    const std::string lower = key + ".lower_mm", upper = key + ".upper_mm";
    if (file.has(lower)) given.lowerMm = file.number(lower, -kWidestToleranceMm, kWidestToleranceMm);
    if (file.has(upper)) given.upperMm = file.number(upper, -kWidestToleranceMm, kWidestToleranceMm);
    if (given.lowerMm && given.upperMm && *given.lowerMm > *given.upperMm)
      file.refuse(lower, "is above upper_mm; exchange the two limits");
    const bool judged = file.boolean(key + ".judged", true);
    if (judged && !given.lowerMm && !given.upperMm)
      file.refuse(key, "has no limit; give lower_mm, upper_mm or both, or judged = false");
    if (!judged && (given.lowerMm || given.upperMm))
      file.refuse(key + ".judged", "is false, yet there are limits; remove one or the other");
    limits.at(index(*dimension)) = given;
  }
}

/// The section is named in a recipe by the catalogue or by a file beside the recipe.
std::string sectionOf(const std::string& named, const fs::path& recipeFile) {
  const bool file = isFileName(named, ".json") || named.find('/') != std::string::npos;
  return file && fs::path(named).is_relative() ? (fs::absolute(recipeFile).parent_path() / named).string() : named;
}

Expected<void> checkParameters(const Section& section, const DimensionParameters& parameters) {
  const auto nominals = nominalDimensions(section, parameters);
  if (!nominals) return tl::unexpected(nominals.error());
  return {};
}

}  // namespace

namespace {

Expected<Recipe> recipeOf(Section found, std::string sectionSource, std::string_view profileClass,
                          std::string_view straightnessClass) {
  auto limits = toleranceLimits(found, profileClass, straightnessClass);
  if (!limits) return tl::unexpected(limits.error());
  if (auto good = checkParameters(found, found.parameters); !good) return tl::unexpected(good.error());
  Recipe recipe;
  recipe.name = found.name + " " + std::string(profileClass) + "/" + std::string(straightnessClass);
  recipe.note = toleranceNote();
  recipe.sectionSource = std::move(sectionSource);
  recipe.parameters = found.parameters;
  recipe.section = std::move(found);
  recipe.profileClass = profileClass;
  recipe.straightnessClass = straightnessClass;
  recipe.limits = *limits;
  return recipe;
}

}  // namespace

Expected<Recipe> makeRecipe(std::string_view section, std::string_view profileClass,
                            std::string_view straightnessClass) {
  auto found = findSection(section);
  if (!found) return tl::unexpected(found.error());
  const std::vector<std::string> catalogue = catalogueNames();
  const bool inCatalogue = std::find(catalogue.begin(), catalogue.end(), found->name) != catalogue.end() &&
                           !isFileName(section, ".json") && section.find('/') == std::string_view::npos;
  std::string source = inCatalogue ? found->name : fs::absolute(fs::path(section)).string();
  return recipeOf(std::move(*found), std::move(source), profileClass, straightnessClass);
}

namespace {

/// `given`: not the section that the file names.
Expected<Recipe> readRecipe(Expected<TomlReader> file, const fs::path& path, std::optional<Section> given = {}) {
  if (!file) return tl::unexpected(file.error());
  const std::string section = file->text("section");
  const std::string profileClass = file->text("profile_class", "X");
  const std::string straightnessClass = file->text("straightness_class", "A");
  if (section.empty()) {
    file->refuse("section", "is empty; give a rail of the catalogue or a section file");
    return tl::unexpected(file->finish().error());
  }

  auto made = given ? recipeOf(std::move(*given), section, profileClass, straightnessClass)
                    : makeRecipe(sectionOf(section, path), profileClass, straightnessClass);
  if (!made) {
    const std::string reason = made.error().message();
    const bool profile = reason.starts_with("profile class"), straightness = reason.starts_with("straightness class");
    file->refuse(profile ? "profile_class" : straightness ? "straightness_class" : "section", reason);
    return tl::unexpected(file->finish().error());
  }

  Recipe recipe = std::move(*made);
  recipe.name = file->text("name", recipe.name);
  recipe.version = file->integer("version", 1, 1000000, 1);
  recipe.note = file->text("note", recipe.note);
  forEachField(recipe, FieldReader{*file});
  if (recipe.stripe.low > recipe.stripe.high)
    file->refuse("stripe.t_l_dn", "is above t_h_dn; exchange the two thresholds");
  readLimits(*file, recipe.limits);
  if (auto good = file->finish(); !good) return tl::unexpected(good.error());
  if (auto good = checkParameters(recipe.section, recipe.parameters); !good) {
    file->refuse("parameters", good.error().message());
    return tl::unexpected(file->finish().error());
  }
  return recipe;
}

}  // namespace

Expected<Recipe> loadRecipe(const fs::path& path) { return readRecipe(TomlReader::load(path), path); }

Expected<Recipe> parseRecipe(std::string_view text, const std::string& nameInErrors) {
  return readRecipe(TomlReader::parse(text, nameInErrors), {});
}

Expected<Recipe> parseRecipe(std::string_view text, const std::string& nameInErrors, Section section) {
  return readRecipe(TomlReader::parse(text, nameInErrors), {}, std::move(section));
}

std::vector<std::string> recipeNames() {
  std::vector<std::string> names;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(recipeFolder(), failed))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

Expected<Recipe> findRecipe(std::string_view nameOrFile) {
  const std::vector<std::string> names = recipeNames();
  if (std::find(names.begin(), names.end(), nameOrFile) != names.end())
    return loadRecipe(recipeFolder() / (std::string(nameOrFile) + ".toml"));
  std::error_code failed;
  if (isFileName(nameOrFile, ".toml") ||
      (fs::is_regular_file(fs::path(nameOrFile), failed) && !isFileName(nameOrFile, ".json")))
    return loadRecipe(nameOrFile);

  // "SECTION CLASS/CLASS"; without classes the usual ones.
  const std::size_t space = nameOrFile.rfind(' ');
  const std::size_t slash = nameOrFile.rfind('/');
  if (space != std::string_view::npos && slash != std::string_view::npos && slash > space)
    return makeRecipe(nameOrFile.substr(0, space), nameOrFile.substr(space + 1, slash - space - 1),
                      nameOrFile.substr(slash + 1));
  auto made = makeRecipe(nameOrFile);
  if (made || isFileName(nameOrFile, ".json")) return made;
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return tl::unexpected(Error{"recipe \"" + std::string(nameOrFile) + "\"",
                              "is no recipe (there are " + list + "), and as a rail: " + made.error().message(),
                              made.error().kind});
}

}  // namespace vignole
