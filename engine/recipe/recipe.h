#pragma once
// A recipe: what is measured and how. Section, tolerances, parameters of the dimensions, settings of the stages.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/geometry/expected.h"
#include "engine/measurement/measurement.h"
#include "engine/rail/dimension.h"
#include "engine/rail/section.h"
#include "engine/rail/tolerance.h"
#include "engine/registration/registration.h"
#include "engine/stripe/stripe.h"

namespace vignole {

struct Recipe {
  std::string name;  ///< "60E1 X/A"
  int version = 1;
  std::string note;  ///< edition of the tolerances, shown to people
  Section section;
  std::string sectionSource;  ///< how a file names the section: a catalogue name, or the absolute path of its file
  std::string profileClass = "X";
  std::string straightnessClass = "A";
  DimensionParameters parameters;
  PerDimension<ToleranceLimits> limits;
  /// The paper's sigma is chosen for a line as broad as the filter; a rail's is 1 to 1.6 px broad in the nominal rig,
  /// speckle wants it broader than that.
  StripeSettings stripe{.sigma = 2.2};
  RegistrationSettings registration;
  MeasurementSettings measurement;
};

/// From a section of the catalogue (or a section file) and its classes.
[[nodiscard]] Expected<Recipe> makeRecipe(std::string_view section, std::string_view profileClass = "X",
                                          std::string_view straightnessClass = "A");
/// TOML, format = 1; what a file does not say is as makeRecipe has it. A section file is looked for beside the recipe.
/// Refuses unknown keys, swapped limits, values out of range, parameters off their primitive: file, line, key,
/// reason, remedy.
[[nodiscard]] Expected<Recipe> loadRecipe(const std::filesystem::path& file);
/// The same from a text; section files must be named by absolute paths, as toToml() does.
[[nodiscard]] Expected<Recipe> parseRecipe(std::string_view text, const std::string& nameInErrors);
/// The same with the section as it was, whatever the text names and whether that is still there.
[[nodiscard]] Expected<Recipe> parseRecipe(std::string_view text, const std::string& nameInErrors, Section section);
/// A path, or a name of resources/recipes, or "SECTION" / "SECTION CLASS/CLASS" ("60E1", "60E1 X/A").
[[nodiscard]] Expected<Recipe> findRecipe(std::string_view nameOrFile);
/// Names of resources/recipes, sorted.
[[nodiscard]] std::vector<std::string> recipeNames();
/// The whole recipe as a commented file that loadRecipe reads back to the same values.
[[nodiscard]] std::string toToml(const Recipe& recipe);

}  // namespace vignole
